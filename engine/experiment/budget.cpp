#include <fmt/format.h>

#include <algorithm>

#include "engine/experiment/experiment.h"

namespace macula::experiment {

bool Budget::appliesTo(const std::string& scene) const {
  return scenes.empty() || std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
}

std::string Budget::label() const {
  switch (kind) {
    case Kind::KAve:
      return fmt::format("k_ave {:g}", value);
    case Kind::MiB:
      return fmt::format("{:g} MiB", value);
    case Kind::Share:
      return fmt::format("share {:g}", value);
  }
  return {};
}

double Budget::bytes(std::uint64_t samples, std::uint64_t generated) const {
  constexpr double kMebi = 1024.0 * 1024.0;
  switch (kind) {
    case Kind::KAve:
      return value * static_cast<double>(samples) * kBytesPerFragment;
    case Kind::MiB:
      return value * kMebi;
    case Kind::Share:
      return value * static_cast<double>(generated) * kBytesPerFragment;
  }
  return 0.0;
}

std::string_view nameOf(Oracle oracle) {
  switch (oracle) {
    case Oracle::OptimalK:
      return "optimal-k";
    case Oracle::LeastRmse:
      return "least-rmse";
    case Oracle::LeastRmseTail:
      return "least-rmse-tail";
    case Oracle::None:
      break;
  }
  return "";
}

}  // namespace macula::experiment
