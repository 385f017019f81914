// What a pass may do while it runs: bind its resources, get its programs, draw, dispatch.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>

#include "engine/frame/frame_inputs.h"
#include "engine/frame/frame_resources.h"
#include "engine/frame/resource.h"
#include "engine/gl/program.h"

namespace macula::frame {

class PassContext {
 public:
  PassContext(const FrameInputs& inputs, FrameResources& resources, gl::ProgramCache& programs)
      : inputs_(inputs), resources_(resources), programs_(programs) {}

  [[nodiscard]] const FrameInputs& inputs() const { return inputs_; }
  [[nodiscard]] FrameResources& resources() const { return resources_; }
  [[nodiscard]] gl::ProgramCache& programs() const { return programs_; }

  void use(const gl::ProgramKey& key) const;
  /// glBindTextureUnit.
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
  gl::ProgramCache& programs_;
};

}  // namespace macula::frame
