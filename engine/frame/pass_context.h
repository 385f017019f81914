// What a pass may do while it runs: bind its resources, dispatch.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>

#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/resource.h"

namespace macula::frame {

class PassContext {
 public:
  PassContext(const FrameInputs& inputs, FrameResources& resources)
      : inputs_(inputs), resources_(resources) {}

  [[nodiscard]] const FrameInputs& inputs() const { return inputs_; }
  [[nodiscard]] FrameResources& resources() const { return resources_; }

  /// glBindTextureUnit; no texture where no pass of this frame writes the resource.
  void bindTexture(GLuint unit, Resource r) const;
  /// glBindImageTexture of level 0. @param access GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE
  void bindImage(GLuint unit, Resource r, GLenum access) const;
  void bindStorage(GLuint binding, Resource r) const;
  /// Binds the framebuffer with these attachments and sets the viewport to its size.
  void bindTargets(std::initializer_list<Resource> colors, Resource depth = Resource::Count) const;
  /// Dispatches enough groups of `group` threads to cover `threads`.
  void dispatch(glm::ivec2 threads, glm::ivec2 group) const;

 private:
  const FrameInputs& inputs_;
  FrameResources& resources_;
};

}  // namespace macula::frame
