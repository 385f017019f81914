// The binding table of a pass: every resource it accesses, where it is bound, how large it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/frame/resource.h"

namespace macula::frame {

/// How a resource is bound. Barriers follow from it and from the access.
enum class BindPoint : std::uint8_t {
  Texture,      ///< sampled or fetched; unit: texture unit
  Image,        ///< image load, store and atomics; unit: image unit
  Storage,      ///< shader storage buffer; unit: its binding
  Indirect,     ///< arguments of an indirect dispatch; not bound to a unit
  ColorTarget,  ///< rendered to; unit: output location
  DepthTarget,  ///< depth- or stencil-tested, perhaps written, as attachment
  Update,       ///< cleared or uploaded by GL commands; not bound
};

/// What a pass does with the contents of a resource.
enum class Access : std::uint8_t {
  Read,              ///< as an earlier pass of this frame left it
  ReadHistory,       ///< as the last frame left it
  Write,             ///< overwritten; what it held before does not matter
  ReadWrite,         ///< read and written
  ReadInvalidate,    ///< read and written, and left without defined contents
  WritePersistent,   ///< written only in some frames; stays valid in the others
  ReadWriteHistory,  ///< as the last frame left it, changed in place
  Scratch,           ///< written and read within the pass; no other pass sees it
};

[[nodiscard]] constexpr bool readsHistory(Access a) {
  return a == Access::ReadHistory || a == Access::ReadWriteHistory;
}
[[nodiscard]] constexpr bool writes(Access a) {
  return a != Access::Read && a != Access::ReadHistory;
}
[[nodiscard]] constexpr bool reads(Access a) {
  return a != Access::Write && a != Access::WritePersistent;
}
/// Reads what an earlier pass or step of this frame wrote, or else the initial contents.
[[nodiscard]] constexpr bool readsThisFrame(Access a) {
  return a == Access::Read || a == Access::ReadWrite || a == Access::ReadInvalidate;
}
/// Contents outlive the frame, so that no other resource may take their memory.
[[nodiscard]] constexpr bool outlivesFrame(Access a) {
  return readsHistory(a) || a == Access::WritePersistent;
}

/// One row of a binding table.
struct Binding {
  const Resource* resource;
  Access access;
  BindPoint point;
  std::uint32_t unit = 0;
  std::uint32_t step = 0;  ///< of the pass, see PassDeclaration::step()
  bool active = true;      ///< bound in this frame; else only allocated for frames that do
};

/// Size of a resource with SizeRule::Declared or DisplaySamples.
struct Extent {
  const Resource* resource;
  std::size_t bytes = 0;  ///< of a buffer
  glm::ivec2 size{0};     ///< texels of a texture
  int samples = 1;        ///< of a multisample texture
};

/// Collects the binding table of a pass. Rows that depend on settings or scene stand behind an
/// `if`; rows that may change from frame to frame without a new prepare() are always declared, and
/// say with when() whether this frame uses them.
class PassDeclaration {
 public:
  /// Refers to the row just added.
  class Row {
   public:
    explicit Row(Binding& binding) : binding_(binding) {}
    void when(bool active) { binding_.active = active; }

   private:
    Binding& binding_;
  };

  Row texture(std::uint32_t unit, const Resource& r, Access access = Access::Read) {
    return add(r, access, BindPoint::Texture, unit);
  }
  /// Bound read-only, write-only or read-write by the access.
  Row image(std::uint32_t unit, const Resource& r, Access access) {
    return add(r, access, BindPoint::Image, unit);
  }
  Row storage(std::uint32_t binding, const Resource& r, Access access) {
    return add(r, access, BindPoint::Storage, binding);
  }
  /// The buffer from which PassContext::dispatchIndirect() takes its numbers of groups.
  Row indirect(const Resource& r) { return add(r, Access::Read, BindPoint::Indirect, 0); }
  Row color(std::uint32_t location, const Resource& r, Access access) {
    return add(r, access, BindPoint::ColorTarget, location);
  }
  Row depth(const Resource& r, Access access = Access::Read) {
    return add(r, access, BindPoint::DepthTarget, 0);
  }
  /// Cleared or uploaded by GL commands in this step.
  Row update(const Resource& r, Access access = Access::Write) {
    return add(r, access, BindPoint::Update, 0);
  }

  /// Rows from here on belong to the next step of the pass. The frame binds step 0 and puts its
  /// barriers before execute(); the pass begins the others by PassContext::beginStep(), which binds
  /// their rows and orders them after what ran before. A resource may stand in several steps.
  /// @returns its number
  std::uint32_t step() { return ++step_; }
  /// The present step draws the scene, whose textures count to the device's limits.
  void scene();
  /// Viewport of the targets of the present step, from the lower left; without it, their size.
  void viewport(glm::ivec2 size);

  // The size of a resource is stated by a pass that writes it; passes that agree may all state it.
  void bytes(const Resource& buffer, std::size_t bytes) { extents_.push_back({&buffer, bytes}); }
  void size(const Resource& texture, glm::ivec2 size) {
    extents_.push_back({&texture, 0, size, 1});
  }
  void samples(const Resource& texture, int samples) {
    extents_.push_back({&texture, 0, glm::ivec2(0), samples});
  }

  [[nodiscard]] const std::vector<Binding>& bindings() const { return bindings_; }
  [[nodiscard]] const std::vector<Extent>& extents() const { return extents_; }
  /// Per step; (0, 0): the size of the targets.
  [[nodiscard]] glm::ivec2 viewportOf(std::uint32_t step) const {
    return step < viewports_.size() ? viewports_[step] : glm::ivec2(0);
  }
  [[nodiscard]] bool drawsScene(std::uint32_t step) const {
    return step < scenes_.size() && scenes_[step];
  }
  [[nodiscard]] std::uint32_t steps() const { return step_ + 1; }
  /// Forgets all rows and keeps their memory, so that a frame declares again without allocating.
  void clear();

 private:
  Row add(const Resource& r, Access access, BindPoint point, std::uint32_t unit) {
    return Row(bindings_.emplace_back(Binding{&r, access, point, unit, step_, true}));
  }

  std::vector<Binding> bindings_;
  std::vector<Extent> extents_;
  std::vector<glm::ivec2> viewports_;
  std::vector<bool> scenes_;
  std::uint32_t step_ = 0;
};

}  // namespace macula::frame
