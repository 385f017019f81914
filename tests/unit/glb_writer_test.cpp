#include "engine/scene/glb_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/glb_buffer.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/load.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A folder of its own that vanishes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / fmt::format("macula-glb-{}", ::getpid())) {
    fs::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] fs::path file(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

Scene reload(const Scene& scene) {
  const std::string bytes = glbBytes(scene);
  return loadGltfFromMemory(std::as_bytes(std::span(bytes)), {}, scene.name);
}

std::uint32_t wordAt(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

json jsonOf(const std::string& bytes) {
  return json::parse(bytes.substr(20, wordAt(bytes, 12)));
}

/// A scene that uses everything that the writer knows.
Scene richScene() {
  Scene scene;
  scene.name = "rich";
  scene.ambient = {0.1F, 0.2F, 0.3F};
  scene.occlusion = {0.25F, 64};
  Image image;
  image.name = "four pixels";
  image.width = image.height = 2;
  image.rgba = {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 10, 20, 30, 40};
  scene.images = {image, image};
  for (std::size_t i = 3; i < 16; i += 4) scene.images[1].rgba[i] = 255;

  Material glass;
  glass.name = "glass";
  glass.baseColor = {0.1F, 0.2F, 0.3F, 0.4F};
  glass.metallic = 0.25F;
  glass.roughness = 0.75F;
  glass.emissive = {4.0F, 2.0F, 1.0F};
  glass.alphaMode = AlphaMode::Blend;
  glass.doubleSided = true;
  glass.transmission = 0.9F;
  glass.thickness = 0.01F;
  glass.attenuationDistance = 0.5F;
  glass.attenuationColor = {0.9F, 0.5F, 0.25F};
  Material cut;
  cut.name = "cut";
  cut.unlit = true;
  cut.alphaMode = AlphaMode::Mask;
  cut.alphaCutoff = 0.3F;
  cut.emissive = {0.5F, 0.25F, 0.0F};
  cut.baseColorTexture.image = 0;
  cut.baseColorTexture.sampler = {Sampler::Wrap::ClampToEdge, Sampler::Wrap::MirroredRepeat, true,
                                  false};
  Material bumpy;
  bumpy.name = "bumpy";
  bumpy.normalScale = 0.5F;
  bumpy.veins = {{0.1F, 0.2F, 0.3F}, 7.5F};
  bumpy.occlusionStrength = 0.4F;
  bumpy.baseColorTexture.image = 1;
  bumpy.normalTexture.image = 1;
  bumpy.normalTexture.uvSet = 1;
  bumpy.occlusionTexture.image = 1;
  bumpy.metallicRoughnessTexture.image = 1;
  bumpy.emissiveTexture.image = 1;
  scene.materials = {glass, cut, bumpy};

  for (std::int32_t m = kNone; m < 3; ++m) {
    Primitive mesh;
    mesh.material = m;
    addSphere(mesh, {0, 0, 0}, 1.0F, 8);
    for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
      const float f = static_cast<float>(i) / static_cast<float>(mesh.attributes.size());
      if (m == 0) mesh.attributes[i].color = {f, 1.0F - f, 0.123F, 0.5F * f};
      if (m == 2) {
        mesh.attributes[i].uv1 = {f, 1.0F - f};
        const glm::vec3 n = mesh.attributes[i].normal;
        const glm::vec3 t = glm::cross(n, glm::vec3(n.y, n.z, -n.x));
        mesh.attributes[i].tangent = glm::vec4(glm::normalize(t), i % 2 == 0 ? 1.0F : -1.0F);
      }
    }
    scene.primitives.push_back(mesh);
  }
  scene.instances = {{0, glm::mat4(1.0F)},
                     {1, place({1, 2, 3}, 0.1F, 2.0F)},
                     {2, place({-1, 0, 0}, 0.7F)},
                     {3, glm::mat4(1.0F)},
                     {1, glm::mat4(-1.0F) * place({0, 0, 4})}};
  scene.instances[4].transform[3][3] = 1.0F;

  Light sun;
  sun.direction = glm::normalize(glm::vec3(-1, -2, -3));
  sun.intensity = 3.0F;
  sun.castsShadow = true;
  sun.shadowTaps = 9;
  Light point;
  point.type = LightType::Point;
  point.color = {1.0F, 0.5F, 0.25F};
  point.position = {1, 2, 3};
  point.range = 9.0F;
  Light spot = point;
  spot.type = LightType::Spot;
  spot.direction = {0, -1, 0};
  spot.innerConeAngle = 0.2F;
  spot.outerConeAngle = 0.5F;
  scene.lights = {sun, point, spot};

  Camera camera;
  camera.name = "orbit";
  camera.position = {1, 2, 3};
  camera.target = {-2, 1, -4};
  camera.verticalFov = 0.9F;
  camera.nearPlane = 0.01F;
  camera.farPlane = 77.0F;
  scene.cameras = {camera};
  return scene;
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance, const std::string& what) {
  EXPECT_LE(glm::distance(a, b), tolerance) << what;
}

void expectSameMesh(const Primitive& a, const Primitive& b, bool tangents) {
  ASSERT_EQ(a.positions, b.positions);
  ASSERT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.material, b.material);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    const VertexAttributes& u = a.attributes[i];
    const VertexAttributes& v = b.attributes[i];
    expectNear(u.normal, v.normal, 1e-6F, "normal");
    EXPECT_EQ(u.uv1, v.uv1);
    EXPECT_EQ(u.color, v.color);
    if (tangents) {
      expectNear(glm::vec3(u.tangent), glm::vec3(v.tangent), 1e-5F, "tangent");
      EXPECT_EQ(u.tangent.w, v.tangent.w);
    }
  }
}

void expectSameMaterial(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.baseColor, b.baseColor);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  expectNear(a.emissive, b.emissive, 1e-6F, "emissive");
  EXPECT_EQ(a.alphaMode, b.alphaMode);
  if (a.alphaMode == AlphaMode::Mask) {
    EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
  }
  EXPECT_EQ(a.doubleSided, b.doubleSided);
  EXPECT_EQ(a.unlit, b.unlit);
  EXPECT_EQ(a.veins.color, b.veins.color);
  EXPECT_EQ(a.veins.scale, b.veins.scale);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_EQ(a.thickness, b.thickness);
  EXPECT_EQ(a.attenuationDistance, b.attenuationDistance);
  EXPECT_EQ(a.attenuationColor, b.attenuationColor);
  const std::pair<const TextureRef*, const TextureRef*> textures[] = {
      {&a.baseColorTexture, &b.baseColorTexture},
      {&a.metallicRoughnessTexture, &b.metallicRoughnessTexture},
      {&a.normalTexture, &b.normalTexture},
      {&a.occlusionTexture, &b.occlusionTexture},
      {&a.emissiveTexture, &b.emissiveTexture}};
  for (const auto& [s, t] : textures) {
    EXPECT_EQ(s->image, t->image);
    EXPECT_EQ(s->uvSet, t->uvSet);
    EXPECT_EQ(s->sampler.wrapS, t->sampler.wrapS);
    EXPECT_EQ(s->sampler.wrapT, t->sampler.wrapT);
    EXPECT_EQ(s->sampler.nearest, t->sampler.nearest);
    EXPECT_EQ(s->sampler.mipmaps, t->sampler.mipmaps);
  }
  if (a.normalTexture.image != kNone) {
    EXPECT_EQ(a.normalScale, b.normalScale);
  }
  if (a.occlusionTexture.image != kNone) {
    EXPECT_EQ(a.occlusionStrength, b.occlusionStrength);
  }
}

void expectSameScene(const Scene& a, const Scene& b) {
  EXPECT_TRUE(b.warnings.empty()) << b.warnings.front();
  EXPECT_TRUE(b.unsupportedExtensions.empty());
  expectNear(a.ambient, b.ambient, 0.0F, "ambient");
  EXPECT_EQ(a.occlusion.radius, b.occlusion.radius);
  EXPECT_EQ(a.occlusion.samples, b.occlusion.samples);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    expectSameMaterial(a.materials[i], b.materials[i]);
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    EXPECT_EQ(a.instances[i].transform, b.instances[i].transform) << i;
    const Primitive& mesh = a.primitives[a.instances[i].primitive];
    expectSameMesh(mesh, b.primitives[b.instances[i].primitive],
                   a.materialOf(mesh).normalTexture.image != kNone);
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    const Light& u = a.lights[i];
    const Light& v = b.lights[i];
    EXPECT_EQ(u.type, v.type);
    EXPECT_EQ(u.color, v.color);
    EXPECT_EQ(u.intensity, v.intensity);
    EXPECT_EQ(u.castsShadow, v.castsShadow);
    EXPECT_EQ(u.shadowTaps, v.shadowTaps);
    EXPECT_EQ(u.range, v.range);
    if (u.type != LightType::Directional) {
      EXPECT_EQ(u.position, v.position);
    }
    if (u.type != LightType::Point) {
      expectNear(u.direction, v.direction, 1e-6F, "direction");
    }
    if (u.type == LightType::Spot) {
      EXPECT_EQ(u.innerConeAngle, v.innerConeAngle);
      EXPECT_EQ(u.outerConeAngle, v.outerConeAngle);
    }
  }
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].name, b.cameras[i].name);
    EXPECT_EQ(a.cameras[i].position, b.cameras[i].position);
    expectNear(a.cameras[i].target, b.cameras[i].target, 1e-5F, "target");
    EXPECT_EQ(a.cameras[i].verticalFov, b.cameras[i].verticalFov);
    EXPECT_EQ(a.cameras[i].nearPlane, b.cameras[i].nearPlane);
    EXPECT_EQ(a.cameras[i].farPlane, b.cameras[i].farPlane);
  }
}

TEST(GlbWriter, LoadsBackWhatItWrote) {
  const Scene scene = richScene();
  const Scene back = reload(scene);
  expectSameScene(scene, back);
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    EXPECT_EQ(back.images[i].rgba, scene.images[i].rgba) << i;
    EXPECT_EQ(back.images[i].width, 2);
  }
  for (std::size_t i = 0; i < scene.primitives[2].attributes.size(); ++i) {
    EXPECT_EQ(back.primitives[2].attributes[i].uv0, scene.primitives[2].attributes[i].uv0);
  }
  EXPECT_EQ(back.primitives.size(), 4U) << "instances share their mesh";
}

class GlbRecipe : public testing::TestWithParam<const char*> {};

TEST_P(GlbRecipe, LoadsBackWhatItWrote) {
  const Scene scene = loadScene(GetParam(), 3);
  expectSameScene(scene, reload(scene));
}

INSTANTIATE_TEST_SUITE_P(All, GlbRecipe,
                         testing::Values("layers-300", "medley-0", "smoke", "bottles", "gallery",
                                         "car", "marble", "chess"),
                         [](const auto& tested) {
                           const std::string name = tested.param;
                           return name.substr(0, name.find('-'));
                         });

TEST(GlbWriter, FollowsTheContainerFormat) {
  const std::string bytes = glbBytes(richScene());
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(wordAt(bytes, 4), 2U);
  EXPECT_EQ(wordAt(bytes, 8), bytes.size());
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(wordAt(bytes, 12) % 4, 0U);
  const std::size_t second = 20 + wordAt(bytes, 12);
  EXPECT_EQ(bytes.substr(second + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(second + 8 + wordAt(bytes, second), bytes.size());
  EXPECT_EQ(bytes.size() % 4, 0U);
}

TEST(GlbWriter, DescribesItsBuffersAsTheSpecificationAsks) {
  const std::string bytes = glbBytes(richScene());
  const json root = jsonOf(bytes);
  const std::size_t length = root["buffers"][0]["byteLength"];
  for (const json& view : root["bufferViews"]) {
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    EXPECT_EQ(offset % 4, 0U);
    EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), length);
  }
  for (const json& mesh : root["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      const json& position = root["accessors"][primitive["attributes"]["POSITION"].get<int>()];
      EXPECT_EQ(position["min"].size(), 3U);
      EXPECT_EQ(position["max"][1].get<float>(), 1.0F);
      EXPECT_EQ(position["min"][1].get<float>(), -1.0F);
      const bool bumpy = primitive.value("material", -1) == 2;
      EXPECT_EQ(primitive["attributes"].contains("TANGENT"), bumpy);
    }
  }
  const std::vector<std::string> used = root["extensionsUsed"];
  EXPECT_EQ(used,
            (std::vector<std::string>{"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                      "KHR_materials_transmission", "KHR_materials_unlit",
                                      "KHR_materials_volume"}));
  EXPECT_FALSE(root.contains("extensionsRequired"));
  EXPECT_EQ(root["textures"].size(), 2U) << "equal pairs of image and sampler are shared";
}

TEST(GlbWriter, LeavesOutExtrasThatAreUsual) {
  Scene scene = richScene();
  scene.ambient = glm::vec3(0.0F);
  scene.occlusion = {};
  scene.materials[2].veins = {};
  for (Light& light : scene.lights) {
    light.castsShadow = false;
    light.shadowTaps = kUsualShadowTaps;
  }
  const json root = jsonOf(glbBytes(scene));
  EXPECT_FALSE(root["scenes"][0].contains("extras"));
  for (const json& material : root["materials"]) EXPECT_FALSE(material.contains("extras"));
  for (const json& light : root["extensions"]["KHR_lights_punctual"]["lights"]) {
    EXPECT_FALSE(light.contains("extras"));
  }
}

TEST(GlbWriter, ClampsColoursIntoTheRangeOfTheFormat) {
  Scene scene;
  Primitive mesh;
  addQuad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  paint(mesh, {1.5F, -1.0F, 0.5F, 1.0F});
  scene.primitives.push_back(mesh);
  scene.instances.push_back({0, glm::mat4(1.0F)});
  EXPECT_EQ(reload(scene).primitives.at(0).attributes.at(0).color,
            glm::vec4(1.0F, 0.0F, 0.5F, 1.0F));
}

TEST(GlbWriter, WritesLargeMeshesWithLongIndices) {
  Scene scene;
  Primitive mesh;
  for (int i = 0; i < 17'000; ++i) {
    const float x = static_cast<float>(i);
    addQuad(mesh, {x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0});
  }
  scene.primitives.push_back(mesh);
  scene.instances.push_back({0, glm::mat4(1.0F)});
  const Scene back = reload(scene);
  EXPECT_EQ(back.primitives.at(0).indices, mesh.indices);
}

TEST(GlbWriter, WritesAnEmptySceneWithoutEmptyArrays) {
  const json root = jsonOf(glbBytes(Scene{}));
  for (const auto& [key, value] : root.items()) {
    if (value.is_array()) {
      EXPECT_FALSE(value.empty()) << key;
    }
  }
  EXPECT_TRUE(reload(Scene{}).instances.empty());
}

TEST(GlbWriter, IsDeterministicAndKeepsOddNames) {
  Scene scene = richScene();
  scene.materials[0].name = "b\xFFroken \"name\"\n";
  EXPECT_EQ(glbBytes(scene), glbBytes(scene));
  EXPECT_EQ(reload(scene).materials.size(), 3U);
}

TEST(GlbWriter, WritesFilesWholeOrNotAtAll) {
  const TemporaryFolder folder;
  writeGlb(richScene(), folder.file("rich.glb"));
  EXPECT_EQ(loadGltf(folder.file("rich.glb")).instances.size(), 5U);
  EXPECT_EQ(readTextFile(folder.file("rich.glb")), glbBytes(richScene()));
  EXPECT_THROW(writeGlb(richScene(), folder.file("missing/rich.glb")), InputError);
}

TEST(Png, DropsAlphaWhereEveryPixelIsOpaque) {
  Image image{"", 1, 1, {1, 2, 3, 255}};
  const auto colorType = [](const std::vector<std::byte>& png) {
    return static_cast<int>(png.at(25));
  };
  EXPECT_EQ(colorType(pngBytes(image)), 2);  // truecolour
  image.rgba[3] = 9;
  EXPECT_EQ(colorType(pngBytes(image)), 6);  // with alpha
}

}  // namespace
}  // namespace macula::scene
