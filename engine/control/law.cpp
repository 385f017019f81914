#include "engine/control/law.h"

#include <array>

#include "engine/control/macula_law.h"
#include "engine/control/published_laws.h"
#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::control {
namespace {

template <typename T>
std::unique_ptr<Law> make(const LawOptions& options) {
  return std::make_unique<T>(options);
}

struct Row {
  std::string_view name;
  std::unique_ptr<Law> (*make)(const LawOptions& options);
};

constexpr std::array<Row, 7> kLaws{{{"macula", make<MaculaLaw>},
                                    {"yang2008", make<YangLaw>},
                                    {"fixed", make<FixedLaw>},
                                    {"filament", make<FilamentLaw>},
                                    {"unreal", make<UnrealLaw>},
                                    {"unity", make<UnityLaw>},
                                    {"id", make<IdLaw>}}};

}  // namespace

double inSteps(double resize, double step) {
  if (step <= 0.0) return resize;
  // Of a step: renderers keep r as a float, whose last digit must not cost a whole step.
  constexpr double kRounding = 1e-3;
  return std::ceil(resize / step - kRounding) * step;
}

std::string noticeOf(Trouble trouble) {
  switch (trouble) {
    case Trouble::NoTimes:
      return "control waits: no frame times arrive";
    case Trouble::NoEffect:
      return "control is off: frame times do not follow the resize factor, so the clock measures "
             "something else (a vsync, the CPU)";
    case Trouble::CpuBound:
      return "the CPU needs longer than the target; a lower resolution does not help";
    case Trouble::Unreachable:
      return "the target is out of reach at the largest resize factor";
    case Trouble::None:
      break;
  }
  return {};
}

std::vector<std::string> lawNames() {
  std::vector<std::string> names;
  for (const Row& row : kLaws) names.emplace_back(row.name);
  return names;
}

std::unique_ptr<Law> makeLaw(std::string_view name, const LawOptions& options) {
  for (const Row& row : kLaws) {
    if (row.name == name) return row.make(options);
  }
  failInput("control law '{}' is unknown; the nearest is '{}'", name,
            nearestName(std::string(name), lawNames()));
}

}  // namespace macula::control
