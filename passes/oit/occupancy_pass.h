// Marks, for each pixel, which depth intervals hold a transparent fragment (Vasilakis 2015, section
// 2).
#pragma once

#include "engine/gl/objects.h"
#include "passes/oit/oit_pass.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class OccupancyPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.occupancy"; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  SceneVariants variants_;
  bool emptied_ = false;  ///< the map is empty at the begin of a frame
};

}  // namespace macula::passes
