#include "engine/experiment/tone_curve.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace macula::experiment {
namespace {

glm::vec3 neutral(glm::vec3 c) {
  const float start = 0.8F - 0.04F;
  const float desaturation = 0.15F;
  const float least = std::min(c.r, std::min(c.g, c.b));
  c -= least < 0.08F ? least - 6.25F * least * least : 0.04F;
  const float peak = std::max(c.r, std::max(c.g, c.b));
  if (peak < start) return c;
  const float room = 1.0F - start;
  const float newPeak = 1.0F - room * room / (peak + room - start);
  c *= newPeak / peak;
  const float grey = 1.0F - 1.0F / (desaturation * (peak - newPeak) + 1.0F);
  return glm::mix(c, glm::vec3(newPeak), grey);
}

glm::vec3 aces(const glm::vec3& c) {
  return glm::clamp((c * (2.51F * c + 0.03F)) / (c * (2.43F * c + 0.59F) + 0.14F), 0.0F, 1.0F);
}

}  // namespace

glm::vec3 toneCurve(std::string_view curve, const glm::vec3& linear) {
  if (curve == "none") return linear;
  if (curve == "neutral") return neutral(linear);
  if (curve == "aces") return aces(linear);
  throw std::invalid_argument("no tone curve is called " + std::string(curve));
}

}  // namespace macula::experiment
