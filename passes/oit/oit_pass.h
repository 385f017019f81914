// What the passes of transparency share: the plan, and rows of binding tables that follow from it.
#pragma once

#include <cstdint>
#include <string>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"
#include "passes/oit/plan.h"
#include "passes/resources.h"
#include "shared/dispatch.h"

namespace macula::passes {

/// Threads of a group of the full-screen passes.
inline constexpr glm::ivec2 kFullScreenGroup{FULLSCREEN_GROUP};

/// A pass that some methods use and others do not.
class OitPass : public frame::Pass {
 public:
  explicit OitPass(const OitPlan& plan) : plan_(plan) {}
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const final;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const final;
  /// Binds the constants of the plan's size around run().
  void execute(frame::PassContext& context) final;

 protected:
  /// Whether the plan's method and options use this pass.
  [[nodiscard]] virtual bool wanted() const = 0;
  /// Its work in one frame, at the plan's size. Allocates nothing.
  virtual void run(frame::PassContext& context) = 0;

  // Rows that are one resource at full rate and another at a reduced rate.
  /// Opaque depth at the samples of transparency.
  /// @param active whether this frame uses it
  void depthTexture(frame::PassDeclaration& d, std::uint32_t unit, bool active = true) const;
  /// The same as attachment, with a viewport of the plan's size.
  void depthTarget(frame::PassDeclaration& d, bool active = true) const;
  /// What captured fragments are tested against: opaque depth, or the cull depth.
  void testedDepthTexture(frame::PassDeclaration& d, std::uint32_t unit) const;
  /// The same as attachment, with a viewport of the plan's size.
  void testedDepthTarget(frame::PassDeclaration& d) const;
  /// What transparency is drawn over, read and written: the image, or at a reduced rate a buffer of
  /// its own.
  void colorImage(frame::PassDeclaration& d, std::uint32_t unit) const;
  /// The same as attachment; the viewport is set by a row of depth.
  void colorTarget(frame::PassDeclaration& d, std::uint32_t location) const;

  /// The shadow map, where shaders with lightingDefines() read it.
  static void shadowMap(frame::PassDeclaration& d, const frame::FrameInputs& in);

  const OitPlan& plan_;
};

/// A pass of one compute shader.
class OitComputePass : public OitPass {
 public:
  using OitPass::OitPass;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) final;

 protected:
  [[nodiscard]] virtual gl::ProgramKey program() const = 0;
  /// Sets uniforms and dispatches, with the program in use: a group for each tile, unless
  /// overridden.
  virtual void dispatch(const frame::PassContext& context);

 private:
  void run(frame::PassContext& context) final;

  GLuint program_ = 0;
};

// Rows of storage, with its size where it is written.
void totalsRow(frame::PassDeclaration& d, frame::Access access);
/// Keys of the fragment pool.
void keysRow(frame::PassDeclaration& d, const OitPlan& plan, frame::Access access);
/// Colours of the fragment pool; nothing where keys hold them.
void colorsRow(frame::PassDeclaration& d, const OitPlan& plan, frame::Access access);
/// Links of the fragment pool; nothing where it holds no lists.
void linksRow(frame::PassDeclaration& d, const OitPlan& plan, frame::Access access);

/// What an allocation writes (shaders/lib/slot_range.glsl): the range of each pixel, and the tails
/// that it empties.
void slotRangeRows(frame::PassDeclaration& d, const OitPlan& plan);
[[nodiscard]] gl::Defines slotRangeDefines(const OitPlan& plan);

/// Work-groups for all tiles of so many samples (shaders/lib/tile.glsl).
void dispatchTiles(const frame::PassContext& context, glm::ivec2 size);

}  // namespace macula::passes
