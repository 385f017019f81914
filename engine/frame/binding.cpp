#include "engine/frame/binding.h"

namespace macula::frame {

void PassDeclaration::viewport(glm::ivec2 size) {
  if (viewports_.size() <= step_) viewports_.resize(step_ + 1, glm::ivec2(0));
  viewports_[step_] = size;
}

void PassDeclaration::clear() {
  bindings_.clear();
  extents_.clear();
  viewports_.clear();
  step_ = 0;
}

}  // namespace macula::frame
