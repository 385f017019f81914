#include "engine/scene/load.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace {

constexpr std::string_view kLayersPrefix = "layers-";
constexpr std::string_view kMedleyPrefix = "medley-";

struct Recipe {
  const char* name;
  const char* description;
  Scene (*make)(std::uint64_t seed);
};

constexpr Recipe kRecipes[] = {
    {"gallery", "a furnished hall with glass, smoke and plants to walk in (the default)",
     makeGallery},
    {"smoke", "a plume of unlit smoke, at most 16 layers deep", makeSmoke},
    {"bottles", "rows of lit glass bottles, at most 22 layers deep", makeBottles},
    {"hair", "a head with hair and beard of thin lit strands, at most 92 layers deep", makeHair},
    {"greenhouse", "glass, pots and translucent plants in tiers, at most 106 layers deep",
     makeGreenhouse},
    {"hairball", "a ball of thin lit strands, at most 180 layers deep", makeHairball},
    {"spheres", "64 plain unlit spheres, for comparing with other renderers", makeSpheres},
    {"car", "a car in a yard under a sun, its shadows filtered with 81 taps", makeCar},
    {"marble", "a dragon of polished stone with procedural veins", makeMarble},
    {"chess", "a game of chess with ambient occlusion of 96 samples", makeChess},
};

/// The N of a scene's name, "layers-64".
/// @param what N stands for @param example what to write instead
int numberIn(const std::string& name, std::string_view prefix, const char* what, int least,
             int most, const char* example) {
  const std::string_view digits = std::string_view(name).substr(prefix.size());
  int n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (digits.starts_with('-') || error != std::errc{} || end != digits.data() + digits.size() ||
      n < least || n > most) {
    failInput("{}: '{}' is no {}; choose {} to {}, for example {}", name, digits, what, least, most,
              example);
  }
  return n;
}

}  // namespace

bool isSceneFile(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".gltf" || extension == ".glb";
}

bool isProcedural(const std::string& name) {
  return name.starts_with(kLayersPrefix) || name.starts_with(kMedleyPrefix) ||
         std::any_of(std::begin(kRecipes), std::end(kRecipes),
                     [&](const Recipe& recipe) { return name == recipe.name; });
}

std::string unknownScene(const std::string& nameOrPath) {
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return "is a folder; name a .gltf or .glb file in it";
  }
  if (std::filesystem::exists(path, error)) {
    return "is no scene that Macula reads; name a .gltf or .glb file";
  }
  if (path.has_parent_path() || path.has_extension()) return "no such file; check the path";
  std::vector<std::string> names;
  std::string all;
  for (const RecipeInfo& recipe : recipes()) {
    names.push_back(recipe.name);
    all += (all.empty() ? "" : ", ") + recipe.name;
  }
  return fmt::format("no such scene; the nearest is '{}' of {}; or name a .gltf or .glb file",
                     nearestName(nameOrPath, names), all);
}

std::vector<RecipeInfo> recipes() {
  std::vector<RecipeInfo> list;
  for (const Recipe& recipe : kRecipes) list.push_back({recipe.name, recipe.description});
  list.push_back(
      {"layers-N",
       fmt::format("N unlit quads of equal weight that fill the view, N = 1 to {}", kMaxLayers)});
  list.push_back(
      {"medley-N", fmt::format("transparent things drawn at random, another still life for each "
                               "N = 0 to {}",
                               kMaxMedley)});
  return list;
}

Scene loadScene(const std::string& nameOrPath, std::uint64_t seed) {
  if (nameOrPath.empty()) {
    failInput(
        "the name of the scene is empty; name a .gltf or .glb file, or a scene of "
        "'macula scene list'");
  }
  for (const Recipe& recipe : kRecipes) {
    if (nameOrPath == recipe.name) return recipe.make(seed);
  }
  const std::filesystem::path path(nameOrPath);
  if (isSceneFile(path)) return loadGltf(path);
  if (nameOrPath.starts_with(kLayersPrefix)) {
    const int n =
        numberIn(nameOrPath, kLayersPrefix, "number of layers", 1, kMaxLayers, "layers-64");
    return makeLayers(n, seed);
  }
  if (nameOrPath.starts_with(kMedleyPrefix)) {
    return makeMedley(
        numberIn(nameOrPath, kMedleyPrefix, "number of a medley", 0, kMaxMedley, "medley-7"));
  }
  failInput("{}: {}", nameOrPath, unknownScene(nameOrPath));
}

}  // namespace macula::scene
