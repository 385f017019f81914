// A triangle that covers everything, for what only a fragment stage can write: depth, stencil.
#pragma once

#include "engine/gl/objects.h"

namespace macula::passes {

class FullScreenDraw {
 public:
  /// @param program with shaders/oit/full_screen.vert · the state is the caller's, but for culling
  void draw(GLuint program) {
    if (!noAttributes_) {
      GLuint id = 0;
      glCreateVertexArrays(1, &id);
      noAttributes_ = gl::VertexArrayId(id);
    }
    glDisable(GL_CULL_FACE);
    glBindVertexArray(noAttributes_.id());
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  gl::VertexArrayId noAttributes_;
};

}  // namespace macula::passes
