// A pass: its binding table, whether it has work, and the work.
#pragma once

#include <string>
#include <string_view>

#include "engine/frame/binding.h"
#include "engine/gl/program.h"

namespace macula::frame {

struct FrameInputs;
class PassContext;

/// One step of a frame. Constructed without a GL context; only prepare() and execute() may call GL.
/// A pass holds references to its settings and never names another pass.
class Pass {
 public:
  virtual ~Pass() = default;
  /// Short and unique; passes of the transparency family start with "oit.".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// States the binding table. Called where the pass has work: before prepare(), and once a frame
  /// for the conditions of when(); the rows and their order must not change in between. Without GL.
  virtual void declare(PassDeclaration& d, const FrameInputs& in) const = 0;
  /// Whether this scene and these settings give the pass something to do.
  [[nodiscard]] virtual bool hasWork(const FrameInputs& in) const = 0;
  /// One clause that says why it has work or has none, for `macula scene info`.
  [[nodiscard]] virtual std::string reason(const FrameInputs& in) const = 0;
  /// Makes what execute() will use, programs above all. Called after a change of scene, settings or
  /// size for the passes that have work; the first function that may call GL. Programs are named
  /// here and linked, all together, when the passes are prepared.
  virtual void prepare(const FrameInputs& in, gl::ProgramCache& programs) = 0;
  /// The work of one frame, with the rows of step 0 bound. Allocates nothing.
  virtual void execute(PassContext& context) = 0;
};

}  // namespace macula::frame
