// A pass: what it reads and writes, whether it has work, and the work.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/resource.h"
#include "engine/gl/program.h"

namespace macula::frame {

struct FrameInputs;
class PassContext;

/// How a pass touches a resource. Barriers follow from it.
enum class Use : std::uint8_t {
  Texture,        ///< sampled or fetched
  Image,          ///< image load and store
  ImageOrTarget,  ///< image store in some frames, rendered to in others
  Storage,        ///< shader storage buffer
  Indirect,       ///< indirect dispatch, and shader storage of the shader that is dispatched
  ColorTarget,    ///< rendered to
  DepthTarget,    ///< depth-tested, perhaps written, as attachment
};

enum class Access : std::uint8_t {
  Read,         ///< as an earlier pass of this frame left it
  ReadHistory,  ///< as the last frame left it
  Write,        ///< overwritten; what it held before does not matter
  Modify,       ///< read and written
  Consume,      ///< read, and left without a defined content
  Keep,         ///< written only when it changes; stays valid in later frames
  Carry,        ///< as the last frame left it, changed in place
  Scratch,      ///< written and read within the pass; nobody else sees it
};

struct Touch {
  Resource resource;
  Use use;
  Access access;
};

/// Collects what a pass touches.
class PassDeclaration {
 public:
  void reads(Resource r, Use use) { touches_.push_back({r, use, Access::Read}); }
  void readsHistory(Resource r, Use use) { touches_.push_back({r, use, Access::ReadHistory}); }
  void writes(Resource r, Use use) { touches_.push_back({r, use, Access::Write}); }
  void modifies(Resource r, Use use) { touches_.push_back({r, use, Access::Modify}); }
  void consumes(Resource r, Use use) { touches_.push_back({r, use, Access::Consume}); }
  void keeps(Resource r, Use use) { touches_.push_back({r, use, Access::Keep}); }
  void carries(Resource r, Use use) { touches_.push_back({r, use, Access::Carry}); }
  void uses(Resource r, Use use) { touches_.push_back({r, use, Access::Scratch}); }
  [[nodiscard]] const std::vector<Touch>& touches() const { return touches_; }

 private:
  std::vector<Touch> touches_;
};

/// One step of a frame. Constructed without a GL context; only prepare() and execute() may call GL.
/// A pass holds references to its settings and never names another pass.
class Pass {
 public:
  virtual ~Pass() = default;
  /// Short and unique; passes of the transparency family start with "oit.".
  [[nodiscard]] virtual std::string_view name() const = 0;
  virtual void declare(PassDeclaration& declaration) const = 0;
  /// Whether this scene and these settings give the pass something to do.
  [[nodiscard]] virtual bool hasWork(const FrameInputs& inputs) const = 0;
  /// One clause that says why it has work or has none, for `macula scene info`.
  [[nodiscard]] virtual std::string reason(const FrameInputs& inputs) const = 0;
  /// Makes what execute() will use, programs above all. Called after a change of scene, settings or
  /// size for the passes that have work; the first function that may call GL.
  virtual void prepare(const FrameInputs& inputs, gl::ProgramCache& programs) = 0;
  /// The work of one frame. Allocates nothing.
  virtual void execute(PassContext& context) = 0;
};

}  // namespace macula::frame
