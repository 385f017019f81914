#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/scene_builder.h"
namespace macula::scene {
Scene makeMarble(std::uint64_t) {
  return SceneBuilder("marble").finish();
}
}
