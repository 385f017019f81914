// A scene in GPU memory: vertices, instances, materials, textures, lights, draw lists.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "engine/gl/objects.h"
#include "engine/scene/environment.h"
#include "engine/scene/light_block.h"
#include "engine/scene/light_choice.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_facts.h"

namespace macula::scene {

enum class CullMode : std::uint8_t { Back, BackMirrored, None };

/// What the shaders of a run are specialised by.
struct SurfaceFeatures {
  std::uint8_t textures = 0;  ///< bit TEX_...: the material has the texture
  std::uint8_t secondUv = 0;  ///< likewise: it uses the second UV set
  std::uint8_t veins = 0;     ///< number of the material's veins plus one, 0: none
  AlphaMode alpha = AlphaMode::Opaque;
  bool vertexColor = false;  ///< a vertex has a colour that is not white
  bool doubleSided = false;
  bool transmission = false;
  auto operator<=>(const SurfaceFeatures&) const = default;
};

/// Consecutive commands that one multi-draw can take.
struct DrawRun {
  std::uint32_t first = 0;  ///< index of the first command
  std::uint32_t count = 0;
  CullMode cull = CullMode::Back;
  bool lit = false;
  bool mask = false;
  bool holed = false;  ///< transparent, with fragments that alpha may discard
  SurfaceFeatures features;
  /// Index in Scene::materials or kNone for the default one; where only positions are read, that of
  /// the first command.
  std::int32_t material = kNone;
};

/// Draw commands (glMultiDrawElementsIndirect) with the runs they fall into.
struct DrawList {
  std::vector<DrawRun> runs;       ///< by cull mode, shading and material
  std::vector<DrawRun> depthRuns;  ///< merged: split only by cull mode and alpha test
  gl::Buffer commands;
  std::vector<Bounds> bounds;  ///< of each command, in the world
  std::uint64_t triangles = 0;
  [[nodiscard]] bool empty() const { return runs.empty(); }

  /// Of each command, for the view that is drawn.
  mutable std::vector<std::uint8_t> visible;
};

/// How draws are ordered; a test reverses them to prove that order changes nothing.
struct DrawOrder {
  bool reversed = false;  ///< draws and the triangles in them from the last to the first
};

class GpuScene {
 public:
  /// Uploads. @param environment may be nullptr
  GpuScene(const Scene& scene, const Environment* environment, DrawOrder order = {});

  [[nodiscard]] const SceneFacts& facts() const { return facts_; }
  [[nodiscard]] const DrawList& opaque() const { return opaque_; }
  [[nodiscard]] const DrawList& transparent() const { return transparent_; }
  /// The same in the order of the scene's instances, for methods whose image depends on it.
  [[nodiscard]] const DrawList& transparentInOrder() const { return transparentInOrder_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Least and greatest distance from a camera to transparent surfaces.
  [[nodiscard]] glm::vec2 transparentDistances(const Camera& camera) const {
    return distancesTo(transparentBounds_, camera);
  }
  /// World to shadow-map clip space of the shadow-casting light; identity where there is none.
  [[nodiscard]] const glm::mat4& shadowViewProjection() const { return shadowViewProjection_; }
  /// What bindLights() binds, but for the lights of a scene that has more than a frame takes.
  [[nodiscard]] const shader::LightBlock& lightBlock() const { return lightBlock_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Binds vertices and instances for drawing.
  void bindGeometry() const;
  /// Where the scene has more lights than a frame takes, chooses those of this view.
  void chooseLights(const Camera& camera, float aspect) const;
  /// Binds the lights' block and the environment texture.
  void bindLights() const;
  /// Binds the material of a run and its textures.
  void bindMaterial(const DrawRun& run) const;
  /// From now on, draw() leaves out the commands that this view cannot show. Allocates nothing.
  void chooseVisible(const glm::mat4& viewProjection) const;
  /// Draws the visible commands of one run, with its culling; program and material are the
  /// caller's.
  void draw(const DrawList& list, const DrawRun& run) const;
  /// The same with all commands, for other views.
  void drawAll(const DrawList& list, const DrawRun& run) const;

 private:
  void uploadGeometry(const Scene& scene, DrawOrder order);
  void uploadTextures(const Scene& scene);
  void uploadMaterials(const Scene& scene);
  void uploadLights(const Scene& scene, const Environment* environment);
  void buildDrawLists(const Scene& scene, DrawOrder order);

  struct MaterialTextures {
    std::array<GLuint, 5> textures{};
    std::array<GLuint, 5> samplers{};
  };

  SceneFacts facts_;
  Bounds bounds_;
  Bounds transparentBounds_;
  glm::mat4 shadowViewProjection_{1.0F};
  shader::LightBlock lightBlock_{};
  gl::VertexArrayId vertexArray_;
  gl::Buffer positions_;
  gl::Buffer attributes_;
  gl::Buffer indices_;
  gl::Buffer instances_;
  gl::Buffer materials_;
  std::size_t materialStride_ = 0;  ///< bytes from one to the next, as uniform buffers are aligned
  // The buffer depends only on the view that was drawn last.
  mutable gl::Buffer lights_;
  mutable LightChoice lightChoice_;
  mutable std::vector<std::uint32_t> chosenLights_;
  std::vector<shader::LightData> allLights_;  ///< only where they do not all fit
  std::vector<gl::Texture> images_;
  std::vector<gl::SamplerId> samplers_;
  gl::Texture white_;
  gl::Texture environment_;
  std::vector<MaterialTextures> materialTextures_;
  DrawList opaque_;
  DrawList transparent_;
  DrawList transparentInOrder_;
  std::uint64_t bytes_ = 0;

  /// Where a primitive's vertices and indices begin.
  struct Placement {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::int32_t baseVertex = 0;
  };
  std::vector<Placement> placements_;
};

}  // namespace macula::scene
