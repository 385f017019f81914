// Slots into the image: the stored fragments of each pixel, nearest first, over what lies behind.
#include <cstddef>
#include <cstdint>

#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"
#include "shared/oit_totals.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Which tiles have pixels that are too deep to be sorted in registers: a mark for each, and a
/// list.
constexpr frame::Resource kDeepTiles{"deep tiles", 0, frame::SizeRule::Declared,
                                     frame::ByteClass::Overhead, frame::Initial::Zero};

class ResolvePass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.resolve"; }

  [[nodiscard]] bool wanted() const override { return plan_.method->stores(); }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    // Sorting in place leaves the pool in another order.
    rows(d, sortsByDepth() ? Access::Read : Access::ReadInvalidate);
    if (!sortsByDepth()) return;
    const glm::ivec2 tiles = (plan_.imageSize + FULLSCREEN_GROUP - 1) / FULLSCREEN_GROUP;
    d.bytes(kDeepTiles, 2 * sizeof(std::uint32_t) * static_cast<std::size_t>(tiles.x) *
                            static_cast<std::size_t>(tiles.y));
    d.step();
    rows(d, Access::ReadInvalidate);
    d.indirect(kOitTotals);
  }

  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    program_ = programs.get({{"oit/resolve.comp"}, definesOf(plan_), {}});
    if (!sortsByDepth()) return;
    gl::Defines deep = definesOf(plan_);
    deep.emplace_back("DEEP", "1");
    deepProgram_ = programs.get({{"oit/resolve.comp"}, deep, {}});
  }

 private:
  /// Deep pixels are sorted apart from the others, which would wait for them.
  [[nodiscard]] bool sortsByDepth() const { return plan_.method->insertion.sortedAtResolve; }

  void rows(frame::PassDeclaration& d, Access pool) const {
    const Method& method = *plan_.method;
    if (method.hasRanges()) d.texture(TEX_INPUT0, kFragmentRange);
    if (method.captures()) {
      if (method.hasFill()) d.texture(TEX_INPUT1, kFragmentFill);
      keysRow(d, plan_, pool);
      colorsRow(d, plan_, pool);
      linksRow(d, plan_, pool);
    } else {
      d.texture(TEX_INPUT3, kRoutedKeys);
      d.texture(TEX_INPUT4, kRoutedColors);
    }
    if (plan_.denseTail()) d.texture(TEX_INPUT2, kTailSums);
    colorImage(d, IMG_0);
    if (!sortsByDepth()) return;
    d.storage(SSBO_DEEP_TILES, kDeepTiles, Access::ReadWrite);
    totalsRow(d, Access::ReadWrite);
  }

  void run(frame::PassContext& context) override {
    glUseProgram(program_);
    context.dispatch(plan_.size, kFullScreenGroup);
    if (!sortsByDepth()) return;
    context.beginStep(1);
    glUseProgram(deepProgram_);
    context.dispatchIndirect(kOitTotals, offsetof(shader::OitTotals, dispatches[LIST_OF_DEEP]));
  }

  GLuint program_ = 0;
  GLuint deepProgram_ = 0;
};

}  // namespace

OitPassPtr makeResolvePass(const OitPlan& plan) {
  return std::make_unique<ResolvePass>(plan);
}

}  // namespace macula::passes
