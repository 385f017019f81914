// macula devices
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "commands.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/gaze/hid/eye_tracker.h"
#include "passes/device_context.h"

namespace macula::tools {
namespace {

struct Options {
  std::string platform = "auto";
  std::string json;
};

nlohmann::ordered_json toJson(const std::vector<gaze::hid::TrackerInfo>& trackers) {
  auto list = nlohmann::ordered_json::array();
  for (const gaze::hid::TrackerInfo& tracker : trackers) {
    list.push_back({{"name", oneLine(tracker.name)},
                    {"vendor", fmt::format("{:04x}", tracker.vendorId)},
                    {"product", fmt::format("{:04x}", tracker.productId)},
                    {"serial", oneLine(tracker.serial)},
                    {"path", tracker.path},
                    {"accessible", tracker.accessible}});
  }
  return list;
}

void print(const std::vector<gaze::hid::TrackerInfo>& trackers) {
  const char* none =
      gaze::hid::hidSupported() ? "none" : "not supported by this build (MACULA_HID)";
  fmt::print("eye trackers      {}\n", trackers.empty() ? none : fmt::to_string(trackers.size()));
  for (const gaze::hid::TrackerInfo& tracker : trackers) {
    fmt::print("  {:04x}:{:04x}       {}{}{}, {}{}\n", tracker.vendorId, tracker.productId,
               oneLine(tracker.name), tracker.serial.empty() ? "" : ", serial ",
               oneLine(tracker.serial), tracker.path,
               tracker.accessible ? "" : " (no permission: install the udev rule in assets/udev)");
  }
}

void print(const gl::Limits& limits) {
  fmt::print("limits            value, and what every OpenGL 4.5 has\n");
  for (const gl::LimitRow& row : gl::limitRows()) {
    fmt::print("  {:<40} {:>10} {:>10}\n", row.name, limits[row.limit], row.guaranteed);
  }
}

nlohmann::ordered_json toJson(const gl::Limits& limits) {
  auto values = nlohmann::ordered_json::object();
  for (const gl::LimitRow& row : gl::limitRows()) values[std::string(row.name)] = limits[row.limit];
  return values;
}

/// Where linked programs are kept, or why they are not.
std::string cacheOf(const passes::DeviceContext& device) {
  const auto folder = gl::programBinaryFolder();
  if (!folder) return "off";
  return device.programs.binaries().active() ? folder->string()
                                             : "none: the driver has no binaries";
}

nlohmann::ordered_json describeGl(const Options& options) {
  const window::HeadlessContext context(platformOf(options.platform));
  const passes::DeviceContext device;
  const gl::Capabilities& c = device.capabilities;
  const auto sync = passes::chooseSync(passes::SyncMode::Auto, c, device.ordered);
  if (options.json != "-") {
    fmt::print("context           EGL {}\nrenderer          {}\nversion           {}\n",
               context.description(), c.renderer, c.version);
    fmt::print("storage block     {} bytes\ntexture side      {} texels\nsamples           {}\n",
               c.limits[gl::Limit::StorageBlockBytes], c.limits[gl::Limit::TextureSide],
               c.maxSamples);
    fmt::print("interlock         {}\n", c.fragmentShaderInterlock ? "yes" : "no");
    fmt::print("parallel compile  {}\nshader cache      {}\n", c.parallelCompile ? "yes" : "no",
               cacheOf(device));
    fmt::print("ordered           {} ({})\n", device.ordered.passed ? "yes" : "no",
               device.ordered.reason);
    fmt::print("synchronisation   {}\ntime source       {}\n", passes::nameOf(sync),
               device.time.reason);
    for (std::size_t i = 0; i < device.time.kRepeats.size(); ++i) {
      fmt::print(
          "  {:<15} timer {:.3f} ms, steady clock {:.3f} ms\n",
          counted(static_cast<std::uint64_t>(device.time.kRepeats[i]), "dispatch", "dispatches"),
          device.time.queryMs[i], device.time.finishMs[i]);
    }
    print(c.limits);
  }
  return {{"context", context.description()},
          {"renderer", c.renderer},
          {"version", c.version},
          {"max_storage_block_bytes", c.limits[gl::Limit::StorageBlockBytes]},
          {"max_texture_size", c.limits[gl::Limit::TextureSide]},
          {"max_samples", c.maxSamples},
          {"limits", toJson(c.limits)},
          {"interlock", c.fragmentShaderInterlock},
          {"parallel_compile", c.parallelCompile},
          {"shader_cache", cacheOf(device)},
          {"ordered", device.ordered.passed},
          {"sync", passes::nameOf(sync)},
          {"time_source",
           {{"source", gl::nameOf(device.time.source)},
            {"reason", device.time.reason},
            {"query_ms", device.time.queryMs},
            {"finish_ms", device.time.finishMs}}}};
}

/// Eye trackers do not need a GL device: they are told even where that one is refused.
void run(const Options& options) {
  const auto trackers = gaze::hid::listTrackers();
  const auto tellTrackers = [&](nlohmann::ordered_json json) {
    if (options.json != "-") print(trackers);
    json["hid"] = gaze::hid::hidSupported();
    json["eye_trackers"] = toJson(trackers);
    writeJson(options.json, json);
  };
  nlohmann::ordered_json gl;
  try {
    gl = describeGl(options);
  } catch (const InputError& error) {
    tellTrackers({{"gl_error", error.what()}});
    throw;
  }
  tellTrackers(std::move(gl));
}

}  // namespace

void addDevices(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand(
      "devices", "The GL device, its time source and synchronisation; eye trackers");
  addPlatformOption(*command, options->platform);
  addJsonOption(*command, options->json);
  command->callback([options] { run(*options); });
}

}  // namespace macula::tools
