#include "measure.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/core/file.h"
#include "engine/measure/image_error.h"
#include "engine/measure/statistics.h"
#include "engine/scene/load.h"
#include "passes/frame_renderer.h"

namespace macula::bench {
namespace {

constexpr int kWarmUp = 3;
constexpr double kBudgets[] = {2.0, 4.0};

Times timesOf(const std::vector<double>& values) {
  return {measure::median(values).value_or(0.0), measure::percentile(values, 0.05).value_or(0.0),
          measure::p95(values).value_or(0.0)};
}

/// A renderer of one method and what its frames took.
struct Contender {
  Contender(const std::string& method, double kAve, passes::Machine& machine,
            const scene::GpuScene& gpu, glm::ivec2 size)
      : settings(makeSettings(method, kAve)), renderer(settings, machine) {
    row.method = method;
    row.kAve = kAve;
    renderer.resize(size);
    renderer.setScene(gpu);
  }

  static passes::RenderSettings makeSettings(const std::string& method, double kAve) {
    passes::RenderSettings s;
    s.oit.method = method;
    if (kAve > 0.0) s.oit.kAve = kAve;
    s.tonemap.linearOut = true;
    return s;
  }

  void draw(const scene::Camera& camera, bool measured) {
    result = renderer.render(camera, glm::vec2(0.5F));
    if (!measured) return;
    totals.push_back(result.totalMs);
    double sum = 0.0;
    for (const frame::PassTime& pass : result.passes) {
      const auto known = std::find_if(passMs.begin(), passMs.end(),
                                      [&](const auto& p) { return p.first == pass.name; });
      if (known == passMs.end()) {
        passMs.emplace_back(pass.name, std::vector<double>{pass.ms});
      } else {
        known->second.push_back(pass.ms);
      }
      if (pass.name.starts_with("oit.")) sum += pass.ms;
    }
    transparency.push_back(sum);
  }

  void finish(const Contender& reference, glm::ivec2 size) {
    row.total = timesOf(totals);
    row.transparency = timesOf(transparency);
    for (const auto& [name, values] : passMs) row.passes.emplace_back(name, timesOf(values));
    const frame::ResourceBytes bytes = renderer.bytes();
    row.oitBytes = bytes.oit;
    row.overheadBytes = bytes.overhead;
    row.budgetBytes = renderer.plan().budgetBytes;
    row.deepest = result.deepest;
    if (result.fragments) {
      row.generated = result.fragments->generated;
      row.lost = result.fragments->lost;
    }
    row.sync = renderer.plan().method->insertion == passes::Insertion::Sorted
                   ? std::string(passes::nameOf(renderer.plan().sync))
                   : "-";
    const auto image = [size](const Contender& c) {
      image::ImageF linear{size.x, size.y, 3, {}, true};
      c.renderer.readLinear(linear.pixels);
      return measure::toDisplay(linear);
    };
    const measure::ImageError error =
        measure::compareImages(image(reference), image(*this), {.flip = false});
    row.rmse = error.rmse;
    row.psnrDb = error.psnrDb;
  }

  passes::RenderSettings settings;
  passes::FrameRenderer renderer;
  passes::FrameResult result;
  Row row;
  std::vector<double> totals;
  std::vector<double> transparency;
  std::vector<std::pair<std::string, std::vector<double>>> passMs;
};

std::string lightOf(const scene::Scene& scene) {
  const scene::SceneFacts facts = scene::factsOf(scene, false);
  if (!facts.litTransparent) return "transparent surfaces unlit";
  return fmt::format("transparent surfaces lit by {} lights{}", scene.lights.size(),
                     facts.shadowLight ? ", one with a shadow map" : "");
}

}  // namespace

SceneResult measureScene(const std::string& name, glm::ivec2 size, int frames,
                         passes::Machine& machine) {
  scene::Scene scene = scene::loadScene(name, 1);
  scene::addDefaultLights(scene);
  const scene::GpuScene gpu(scene, nullptr);
  const scene::Camera camera = scene.cameras.front();
  std::vector<std::unique_ptr<Contender>> all;
  const auto add = [&](const std::string& method, double kAve) {
    all.push_back(std::make_unique<Contender>(method, kAve, machine, gpu, size));
  };
  add("blend", 0.0);
  add("ab-sbuffer", 0.0);
  for (const double kAve : kBudgets) add("kb-variable", kAve);
  for (int i = 0; i < kWarmUp + frames; ++i) {
    for (auto& contender : all) contender->draw(camera, i >= kWarmUp);
  }
  SceneResult result{name, size, lightOf(scene), {}};
  for (auto& contender : all) {
    contender->finish(*all[1], size);
    result.rows.push_back(contender->row);
  }
  return result;
}

std::optional<LoadResult> measureLoad(const std::string& program, const std::string& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("macula_load_{}", ::getpid());
  const std::string out = folder.string();
  const pid_t child = ::fork();
  if (child == 0) {
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, STDOUT_FILENO);
    ::dup2(null, STDERR_FILENO);
    ::execl(program.c_str(), program.c_str(), "replay", file.c_str(), "--frames", "1", "--size",
            "512x512", "--out", out.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  const auto report = nlohmann::json::parse(readTextFile(folder / "report.json"));
  std::filesystem::remove_all(folder);
  constexpr double kKibiPerMebi = 1024.0;
  return LoadResult{std::filesystem::path(file).filename().string(),
                    report["summary"]["load_ms"].get<double>(),
                    report["summary"]["first_frame_ms"].get<double>(),
                    static_cast<double>(usage.ru_maxrss) / kKibiPerMebi};
}

}  // namespace macula::bench
