#include "engine/frame/binding.h"

namespace macula::frame {

void PassDeclaration::viewport(glm::ivec2 size) {
  if (viewports_.size() <= step_) viewports_.resize(step_ + 1, glm::ivec2(0));
  viewports_[step_] = size;
}

void PassDeclaration::scene(SceneUse use) {
  if (scenes_.size() <= step_) scenes_.resize(step_ + 1, SceneUse::None);
  scenes_[step_] = use;
}

void PassDeclaration::clear() {
  bindings_.clear();
  extents_.clear();
  viewports_.clear();
  scenes_.clear();
  step_ = 0;
}

}  // namespace macula::frame
