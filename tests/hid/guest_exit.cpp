// guest_exit VALUE: ends QEMU with status 2 VALUE + 1 through its isa-debug-exit device.
#include <sys/io.h>

#include <cstdlib>

namespace {
constexpr unsigned short kExitPort = 0xF4;  // as in run_guest.sh
}

int main(int argc, char** argv) {
  if (argc != 2 || ioperm(kExitPort, 4, 1) != 0) return 1;
  outl(static_cast<unsigned>(std::atoi(argv[1])), kExitPort);
  return 1;
}
