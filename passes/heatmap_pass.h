// Per-pixel quantities of the transparency and of the level of detail as colours over the image.
#pragma once

#include <string>
#include <vector>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "engine/image/legend.h"
#include "passes/lod/plan.h"
#include "passes/oit/plan.h"

namespace macula::passes {

/// What is shown in place of the image: a quantity as colours over it.
inline constexpr frame::Resource kHeatmapColor{"heat map", GL_RGBA8, frame::SizeRule::Output,
                                               frame::ByteClass::Other, frame::Initial::Undefined};

class HeatmapPass final : public frame::Pass {
 public:
  struct Settings {
    std::string map = "none";  ///< one of heatmapNames()
    double range = 0.0;        ///< value of the hottest colour for counts and k; 0: the largest
                               ///< of the last frame
  };
  HeatmapPass(const Settings& settings, const OitPlan& plan, const LodPlan& lod,
              const int& samplesPerAxis)
      : settings_(settings), plan_(plan), lod_(lod), samplesPerAxis_(samplesPerAxis) {}
  [[nodiscard]] std::string_view name() const override { return "heatmap"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  const Settings& settings_;
  const OitPlan& plan_;
  const LodPlan& lod_;
  const int& samplesPerAxis_;
  GLuint program_ = 0;
};

/// none, k, depth-complexity, importance, periphery, depth-factor, fresnel, shading-rate.
[[nodiscard]] std::vector<std::string> heatmapNames();
/// Whether a map shows a factor of the importance, which is then kept for it.
[[nodiscard]] bool needsFactors(const std::string& map);
/// Value of the hottest colour: counts and k by the setting, factors 1, log2 of pitches of
/// shading 3.
[[nodiscard]] double heatmapRange(const HeatmapPass::Settings& settings, const OitPlan& plan);
/// Whether that value is the largest of the last frame.
[[nodiscard]] bool rangeFollowsFrames(const HeatmapPass::Settings& settings);
/// What the colours of a map mean, with its present range. @param settings with a map
[[nodiscard]] image::Legend legendOf(const HeatmapPass::Settings& settings, double range);

}  // namespace macula::passes
