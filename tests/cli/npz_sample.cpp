// Writes a .npz with an array of each type and a text, for npz_test.py. Usage: npz_sample FILE
#include <array>
#include <cstdint>

#include "engine/dataset/npz.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  macula::dataset::NpzWriter writer;
  writer.add("singles", {2, 3}, std::array{0.0F, 0.5F, -1.0F, 1e-40F, 3.25F, 1e30F});
  writer.add("bytes", {3}, std::array<std::uint8_t, 3>{0, 1, 255});
  writer.add("shorts", {1, 2, 1}, std::array<std::uint16_t, 2>{258, 65535});
  writer.add("words", {}, std::array<std::uint32_t, 1>{4278255873U});
  writer.add("longs", {2}, std::array<std::uint64_t, 2>{1, 0xFFFFFFFFFFFFFFFEU});
  writer.add("none", {0, 4}, std::span<const float>());
  writer.addText("about", R"({"scene": "café"})");
  writer.write(argv[1]);
  return 0;
}
