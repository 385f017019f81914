#include "engine/frame/binding.h"

namespace macula::frame {

void PassDeclaration::viewport(glm::ivec2 size) {
  if (viewports_.size() <= step_) viewports_.resize(step_ + 1, glm::ivec2(0));
  viewports_[step_] = size;
}

void PassDeclaration::scene() {
  if (scenes_.size() <= step_) scenes_.resize(step_ + 1, false);
  scenes_[step_] = true;
}

void PassDeclaration::clear() {
  bindings_.clear();
  extents_.clear();
  viewports_.clear();
  scenes_.clear();
  step_ = 0;
}

}  // namespace macula::frame
