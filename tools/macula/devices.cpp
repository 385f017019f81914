// macula devices
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "common.h"
#include "passes/machine.h"

namespace macula::tools {
namespace {

struct Options {
  std::string platform = "auto";
  std::string json;
};

void run(const Options& options) {
  const window::HeadlessContext context(platformOf(options.platform));
  const passes::Machine machine;
  const gl::Capabilities& c = machine.capabilities;
  const auto sync = passes::chooseSync(passes::SyncMode::Auto, c, machine.ordered);
  if (options.json != "-") {
    fmt::print("context           EGL {}\nrenderer          {}\nversion           {}\n",
               context.description(), c.renderer, c.version);
    fmt::print("storage block     {} bytes\ntexture side      {} texels\nsamples           {}\n",
               c.maxStorageBlockBytes, c.maxTextureSize, c.maxSamples);
    fmt::print("interlock         {}\n", c.fragmentShaderInterlock ? "yes" : "no");
    fmt::print("ordered           {} ({})\n", machine.ordered.passed ? "yes" : "no",
               machine.ordered.reason);
    fmt::print("synchronisation   {}\ntime source       {}\n", passes::nameOf(sync),
               machine.time.reason);
    for (std::size_t i = 0; i < machine.time.kRepeats.size(); ++i) {
      fmt::print("  {} dispatches    timer {:.3f} ms, steady clock {:.3f} ms\n",
                 machine.time.kRepeats[i], machine.time.queryMs[i], machine.time.finishMs[i]);
    }
  }
  writeJson(options.json, {{"context", context.description()},
                           {"renderer", c.renderer},
                           {"version", c.version},
                           {"max_storage_block_bytes", c.maxStorageBlockBytes},
                           {"max_texture_size", c.maxTextureSize},
                           {"interlock", c.fragmentShaderInterlock},
                           {"ordered", machine.ordered.passed},
                           {"sync", passes::nameOf(sync)},
                           {"time_source",
                            {{"source", gl::nameOf(machine.time.source)},
                             {"reason", machine.time.reason},
                             {"query_ms", machine.time.queryMs},
                             {"finish_ms", machine.time.finishMs}}}});
}

}  // namespace

void addDevices(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      root.add_subcommand("devices", "The GL device, its time source and synchronisation");
  addPlatformOption(*command, options->platform);
  addJsonOption(*command, options->json);
  command->callback([options] { run(*options); });
}

}  // namespace macula::tools
