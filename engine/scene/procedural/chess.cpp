#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/scene_builder.h"
namespace macula::scene {
Scene makeChess(std::uint64_t) {
  return SceneBuilder("chess").finish();
}
}
