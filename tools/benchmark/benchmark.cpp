// macula_benchmark: methods against each other in one run. Writes BENCHMARKS.md and BENCHMARKS.json
// into the folder given by --out (default: the current one).
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/window/headless.h"
#include "macula_version.h"
#include "measure.h"
#include "write.h"

namespace {

using namespace macula;

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::gmtime(&now));
  return text;
}

std::string commandOf(int argc, char** argv) {
  std::string text = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Measures transparency methods against each other in one run.",
                 "macula_benchmark");
    int frames = 21;
    int side = 1024;
    std::string out = ".";
    std::string load;
    std::vector<std::string> scenes{"smoke", "bottles"};
    app.add_option("--frames", frames, "Rounds (default 21)")->check(CLI::Range(1, 10000));
    app.add_option("--side", side, "Width and height (default 1024)")->check(CLI::Range(16, 8192));
    app.add_option("--scenes", scenes,
                   "Procedural names or files, name@SIDE for a size of its own");
    app.add_option("--load", load, "glTF file whose loading is measured");
    app.add_option("--out", out, "Folder of the results");
    CLI11_PARSE(app, argc, argv);

    const window::HeadlessContext context;
    passes::Machine machine;
    bench::Run run;
    run.command = commandOf(argc, argv);
    run.commit = MACULA_COMMIT;
    run.date = today();
    run.renderer = machine.capabilities.renderer;
    run.version = machine.capabilities.version;
    run.timeSource = machine.time.source == gl::TimeSource::Finish ? "glFinish and a steady clock"
                                                                   : "GL timer queries";
    run.cores = static_cast<int>(std::thread::hardware_concurrency());
    run.frames = frames;
    for (const std::string& entry : scenes) {
      const std::size_t at = entry.rfind('@');
      const int own = at == std::string::npos ? side : std::stoi(entry.substr(at + 1));
      std::fprintf(stderr, "%s\n", entry.c_str());
      run.scenes.push_back(
          bench::measureScene(entry.substr(0, at), glm::ivec2(own), frames, machine));
    }
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "macula";
    if (!load.empty()) run.load = bench::measureLoad(program.string(), load);
    const std::filesystem::path folder(out);
    writeFileAtomically(folder / "BENCHMARKS.md", bench::toMarkdown(run));
    writeFileAtomically(folder / "BENCHMARKS.json", bench::toJson(run).dump(2) + "\n");
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "macula_benchmark: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "macula_benchmark: fault: %s\n", error.what());
    return 3;
  }
}
