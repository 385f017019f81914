// What a frame did with its transparent fragments, found out after it, outside of its time.
#pragma once

#include "engine/frame/pass_context.h"
#include "engine/gl/objects.h"
#include "passes/oit/count_draw.h"
#include "passes/oit/plan.h"
#include "shared/oit_totals.h"

namespace macula::passes {

/// Counts fragments as the frame's method saw them. Methods that count none are given a count of
/// their own here.
class OitStatisticsCounter {
 public:
  explicit OitStatisticsCounter(const OitPlan& plan) : plan_(plan) {}
  /// To be called when scene, size or settings changed.
  void prepare(const frame::FrameInputs& in, const frame::FrameResources& resources,
               gl::ProgramCache& programs);
  /// After a frame with this context. Waits for the GPU.
  [[nodiscard]] shader::OitStatistics measure(frame::PassContext& context);

 private:
  const OitPlan& plan_;
  CountDraw count_;
  gl::FramebufferId framebuffer_;
  gl::FramebufferId resizedFramebuffer_;
  GLuint program_ = 0;
  gl::Texture counts_;
  gl::Buffer sums_;
};

}  // namespace macula::passes
