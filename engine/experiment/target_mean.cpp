#include "engine/experiment/target_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/core/plural.h"

namespace macula::experiment {
namespace {

bool holds(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Whether two points differ in nothing but their scene.
bool sameButScene(const Point& a, const Point& b) {
  for (const char* key : {"study", "width", "height", "seed", "light", "budget", "sweep"}) {
    if (a.value(key, Point(nullptr)) != b.value(key, Point(nullptr))) return false;
  }
  return true;
}

/// The scenes that a mean is over, beside a point of the study.
std::vector<std::string> scenesOf(const Study& study, const Target& target, const Point& point) {
  const std::string budget = textOf(point, "budget");
  std::vector<std::string> scenes;
  for (const std::string& scene : study.scenes) {
    if (target.scenes.empty() ? study.isOptional(scene) : !holds(target.scenes, scene)) continue;
    const bool measured =
        budget.empty() ||
        std::any_of(study.budgets.begin(), study.budgets.end(), [&](const Budget& candidate) {
          return candidate.label() == budget && candidate.appliesTo(scene);
        });
    if (measured) scenes.push_back(scene);
  }
  return scenes;
}

std::string shortName(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

/// "mean of 4 scenes, 512x512, share 0.3": where the scene stands in the row of one of them.
std::string placeOf(const ScenePart& part, std::size_t scenes) {
  const std::string scene = shortName(textOf(*part.point, "scene"));
  const std::string rest = part.row.where.substr(std::min(scene.size() + 1, part.row.where.size()));
  return fmt::format("mean of {}, {}", counted(scenes, "scene"), rest);
}

TargetRow meanOf(const Target& target, const std::vector<std::string>& scenes,
                 const std::vector<const ScenePart*>& parts) {
  TargetRow row{&target, parts.front()->row.study,     placeOf(*parts.front(), scenes.size()),
                {},      TargetRow::State::Unmeasured, {},
                {}};
  double sum = 0.0;
  std::string values;
  for (const std::string& scene : scenes) {
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const ScenePart* candidate) {
      return textOf(*candidate->point, "scene") == scene;
    });
    if (part == parts.end() || !(*part)->row.value) {
      row.note = shortName(scene) + ": " +
                 (part == parts.end() ? "no point of " + target.of : (*part)->row.note);
      if (part != parts.end() && (*part)->row.state == TargetRow::State::NotApplicable) {
        row.state = TargetRow::State::NotApplicable;
        row.reason = shortName(scene) + ": " + (*part)->row.reason;
      }
      return row;
    }
    sum += *(*part)->row.value;
    values += fmt::format("{}{:.4g} ({})", values.empty() ? "" : ", ", *(*part)->row.value,
                          shortName(scene));
  }
  row.note = values;
  row.value = sum / static_cast<double>(scenes.size());
  row.state = target.admits(*row.value) ? TargetRow::State::Met : TargetRow::State::Missed;
  return row;
}

}  // namespace

std::vector<TargetRow> meansOverScenes(const Experiment& experiment, const Target& target,
                                       std::span<const ScenePart> parts) {
  std::vector<TargetRow> rows;
  std::vector<const Point*> leads;  // of the rows, where each begins
  for (const ScenePart& part : parts) {
    const Study& study = experiment.study(textOf(*part.point, "study"));
    const std::vector<std::string> scenes = scenesOf(study, target, *part.point);
    if (!holds(scenes, textOf(*part.point, "scene"))) continue;
    if (std::any_of(leads.begin(), leads.end(),
                    [&](const Point* lead) { return sameButScene(*lead, *part.point); })) {
      continue;
    }
    leads.push_back(part.point);
    std::vector<const ScenePart*> members;
    for (const ScenePart& other : parts) {
      if (sameButScene(*part.point, *other.point)) members.push_back(&other);
    }
    rows.push_back(meanOf(target, scenes, members));
  }
  return rows;
}

}  // namespace macula::experiment
