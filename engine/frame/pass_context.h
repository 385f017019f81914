// What a pass may do while it runs: begin its steps, dispatch, clear.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/frame/binding.h"
#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"

namespace macula::frame {

class BarrierTracker;

/// What a pass counts its samples in; FrameConstants exist for both.
enum class Raster : std::uint8_t {
  Image,    ///< samples of the image
  Reduced,  ///< texels at which reduced-rate transparency is drawn
};

class PassContext {
 public:
  /// @param constants uniform buffers with FrameConstants, by Raster
  PassContext(const FrameInputs& inputs, FrameResources& resources, BarrierTracker& barriers,
              const std::array<GLuint, 2>& constants)
      : inputs_(inputs), resources_(resources), barriers_(barriers), constants_(constants) {}

  [[nodiscard]] const FrameInputs& inputs() const { return inputs_; }
  [[nodiscard]] FrameResources& resources() const { return resources_; }

  /// Puts the barriers that a step of the running pass needs, and binds its rows. The frame does so
  /// for step 0.
  void beginStep(std::uint32_t step);
  /// Binds the FrameConstants of a raster. A pass that needs others than those of the image binds
  /// those of the image again when it is done.
  void bindConstants(Raster raster) const;
  /// Dispatches enough groups of `group` threads to cover `threads`.
  void dispatch(glm::ivec2 threads, glm::ivec2 group) const;
  /// Dispatches the groups that earlier passes asked for. @param offset bytes into the buffer, at
  /// which their numbers in x, y and z stand
  void dispatchIndirect(const Resource& buffer, GLintptr offset) const;
  /// Fills a buffer with one word, or a R32UI texture (its whole level 0). The present step
  /// declares it with update().
  void fill(const Resource& r, std::uint32_t word) const;

  /// The table of the pass that runs from now on. Called by the frame, and by readers of a finished
  /// frame that bind its resources by a table of their own.
  /// @param slots of the rows' resources; both must outlive the pass
  void beginPass(const PassDeclaration& declaration, std::span<const std::uint32_t> slots) {
    declaration_ = &declaration;
    slots_ = slots;
  }

 private:
  const FrameInputs& inputs_;
  FrameResources& resources_;
  BarrierTracker& barriers_;
  std::array<GLuint, 2> constants_;
  const PassDeclaration* declaration_ = nullptr;
  std::span<const std::uint32_t> slots_;

  void bind(const Binding& row, std::uint32_t slot) const;
  void bindTargets(std::uint32_t step);
  /// Slot of a resource that the running pass declares.
  [[nodiscard]] std::uint32_t slotOf(const Resource& r, BindPoint point) const;
};

/// Slots of the rows of a table, as beginPass() takes them.
[[nodiscard]] std::vector<std::uint32_t> slotsOf(const PassDeclaration& declaration,
                                                 const FrameResources& resources);

}  // namespace macula::frame
