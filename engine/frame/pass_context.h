// What a pass may do while it runs: bind its resources, dispatch.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <span>

#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/pass.h"
#include "engine/frame/resource.h"

namespace macula::frame {

/// What a pass counts its samples in; FrameConstants exist for both.
enum class Raster : std::uint8_t {
  Image,    ///< samples of the image
  Resized,  ///< texels at which resized transparency is drawn
};

class PassContext {
 public:
  /// @param constants uniform buffers with FrameConstants, by Raster
  PassContext(const FrameInputs& inputs, FrameResources& resources,
              const std::array<GLuint, 2>& constants)
      : inputs_(inputs), resources_(resources), constants_(constants) {}

  [[nodiscard]] const FrameInputs& inputs() const { return inputs_; }
  [[nodiscard]] FrameResources& resources() const { return resources_; }

  /// What the running pass declares. In debug contexts, binding anything else is reported: no
  /// barrier would stand before it.
  void setDeclared(std::span<const Touch> touches) { declared_ = touches; }

  /// glBindTextureUnit; no texture where no pass of this frame writes the resource.
  void bindTexture(GLuint unit, Resource r) const;
  /// glBindImageTexture of level 0. @param access GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE
  void bindImage(GLuint unit, Resource r, GLenum access) const;
  void bindStorage(GLuint binding, Resource r) const;
  /// Binds the FrameConstants of a raster. A pass that needs others than those of the image binds
  /// those of the image again when it is done.
  void bindConstants(Raster raster) const;
  /// Binds the framebuffer with these attachments and sets the viewport to its size.
  void bindTargets(std::initializer_list<Resource> colors, Resource depth = Resource::Count) const;
  /// The same, with a viewport of this size at the lower left.
  void bindTargets(std::initializer_list<Resource> colors, Resource depth,
                   glm::ivec2 viewport) const;
  /// Dispatches enough groups of `group` threads to cover `threads`.
  void dispatch(glm::ivec2 threads, glm::ivec2 group) const;
  /// Dispatches the groups that earlier passes asked for. @param offset bytes into the buffer, at
  /// which their numbers in x, y and z stand
  void dispatchIndirect(Resource buffer, GLintptr offset) const;

 private:
  const FrameInputs& inputs_;
  FrameResources& resources_;
  std::array<GLuint, 2> constants_;
  std::span<const Touch> declared_;  ///< empty outside of passes

  void expectDeclared(Resource r, std::initializer_list<Use> uses) const;
};

}  // namespace macula::frame
