#include "write.h"

#include <fmt/format.h>

#include <algorithm>

namespace macula::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string nameOf(const Row& row) {
  return row.kAve > 0.0 ? fmt::format("{}, k_ave {:g}", row.method, row.kAve) : row.method;
}

std::string shown(const Times& t) {
  return fmt::format("{:.1f} ({:.1f}-{:.1f})", t.median, t.p5, t.p95);
}

template <typename T>
std::string orDash(const std::optional<T>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

void appendScene(std::string& text, const SceneResult& scene) {
  const Row& floor = scene.rows.front();
  text += fmt::format("\n## {} at {}x{}\n\n{}; at most {} layers deep.\n\n", scene.scene,
                      scene.size.x, scene.size.y, scene.light, scene.rows.at(1).deepest);
  text +=
      "| method | transparency ms | / blend | frame ms | / blend | fragments | lost | RMSE | PSNR "
      "dB "
      "| bytes | budget | overhead |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : scene.rows) {
    const std::optional<double> loss = row.generated && *row.generated > 0
                                           ? std::optional(100.0 * static_cast<double>(*row.lost) /
                                                           static_cast<double>(*row.generated))
                                           : std::nullopt;
    text += fmt::format(
        "| {} | {} | {:.2f} | {} | {:.2f} | {} | {} | {} | {} | {} | {} | {} |\n", nameOf(row),
        shown(row.transparency), row.transparency.median / floor.transparency.median,
        shown(row.total), row.total.median / floor.total.median, orDash(row.generated, "{}"),
        orDash(loss, "{:.2f} %"), orDash(row.rmse, "{:.5f}"), orDash(row.psnrDb, "{:.1f}"),
        row.oitBytes, orDash(row.budgetBytes, "{}"), row.overheadBytes);
  }
  text += "\nMedian ms of each pass:\n\n| pass |";
  for (const Row& row : scene.rows) text += fmt::format(" {} |", nameOf(row));
  text += "\n|---|";
  std::vector<std::string> names;
  for (const Row& row : scene.rows) {
    text += "---|";
    for (const auto& [name, times] : row.passes) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  text += "\n";
  for (const std::string& name : names) {
    text += fmt::format("| {} |", name);
    for (const Row& row : scene.rows) {
      std::string cell = "-";
      for (const auto& [pass, times] : row.passes) {
        if (pass == name) cell = fmt::format("{:.2f}", times.median);
      }
      text += fmt::format(" {} |", cell);
    }
    text += "\n";
  }
}

Json timesJson(const Times& t) {
  return {{"median_ms", t.median}, {"p5_ms", t.p5}, {"p95_ms", t.p95}};
}

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::string toMarkdown(const Run& run) {
  std::string text = "# Benchmarks\n\n";
  text += fmt::format(
      "Made by `{}`, which also writes `BENCHMARKS.json`. Commit {}, {}, on {} ({}), {} cores, "
      "times "
      "from {}. Each method draws one frame in turn, {} rounds after {} of warm-up; the figures "
      "are "
      "medians with the 5th and 95th percentile. Ratios are of medians of the same run. "
      "\"Transparency\" is the sum of the passes whose names start with `oit.`. RMSE and PSNR are "
      "against `ab-sbuffer`, on display values 0..1. Times of a software rasteriser say how "
      "methods "
      "compare on it, not what a GPU needs.\n",
      run.command, run.commit, run.date, run.renderer, run.version, run.cores, run.timeSource,
      run.frames, run.warmUp);
  for (const SceneResult& scene : run.scenes) appendScene(text, scene);
  if (run.load) {
    text += fmt::format(
        "\n## Loading\n\n{}: loaded in {:.0f} ms; the first frame (512x512) stood {:.0f} ms after "
        "the "
        "start of the program, start-up checks and shader compilation included; peak memory {:.0f} "
        "MiB, the rasteriser's own included.\n",
        run.load->file, run.load->loadMs, run.load->firstFrameMs, run.load->peakMiB);
  }
  return text;
}

Json toJson(const Run& run) {
  Json json{{"schema", 1},
            {"command", run.command},
            {"commit", run.commit},
            {"date", run.date},
            {"gl", {{"renderer", run.renderer}, {"version", run.version}}},
            {"time_source", run.timeSource},
            {"cores", run.cores},
            {"frames", run.frames},
            {"warm_up", run.warmUp},
            {"scenes", Json::array()}};
  for (const SceneResult& scene : run.scenes) {
    Json rows = Json::array();
    for (const Row& row : scene.rows) {
      Json passes = Json::object();
      for (const auto& [name, times] : row.passes) passes[name] = timesJson(times);
      rows.push_back(
          {{"method", row.method},
           {"k_ave", row.kAve > 0.0 ? Json(row.kAve) : Json(nullptr)},
           {"sync", row.sync},
           {"frame", timesJson(row.total)},
           {"transparency", timesJson(row.transparency)},
           {"passes", passes},
           {"bytes",
            {{"oit", row.oitBytes},
             {"budget", orNull(row.budgetBytes)},
             {"overhead", row.overheadBytes}}},
           {"fragments", {{"generated", orNull(row.generated)}, {"lost", orNull(row.lost)}}},
           {"deepest", row.deepest},
           {"rmse", orNull(row.rmse)},
           {"psnr_db", orNull(row.psnrDb)}});
    }
    json["scenes"].push_back({{"scene", scene.scene},
                              {"width", scene.size.x},
                              {"height", scene.size.y},
                              {"light", scene.light},
                              {"rows", rows}});
  }
  if (run.load) {
    json["load"] = {{"file", run.load->file},
                    {"load_ms", run.load->loadMs},
                    {"first_frame_ms", run.load->firstFrameMs},
                    {"peak_mib", run.load->peakMiB}};
  }
  return json;
}

}  // namespace macula::bench
