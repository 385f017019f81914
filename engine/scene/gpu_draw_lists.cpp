// GpuScene: which draws, in which runs.
#include <algorithm>
#include <tuple>

#include "engine/scene/alpha_holes.h"
#include "engine/scene/gpu_scene.h"
#include "engine/scene/light_block.h"
#include "engine/scene/visibility.h"
#include "shared/bindings.h"

namespace macula::scene {
namespace {

/// The layout that glMultiDrawElementsIndirect reads.
struct DrawCommand {
  std::uint32_t count = 0;
  std::uint32_t instanceCount = 1;
  std::uint32_t firstIndex = 0;
  std::int32_t baseVertex = 0;
  std::uint32_t baseInstance = 0;
};

struct Draw {
  DrawCommand command;
  Bounds bounds;
  DrawRun key;

  /// By material, so that there are few runs; or in the order of the instances as far as the state
  /// allows.
  [[nodiscard]] auto order(bool byMaterial) const {
    const std::int32_t textured = key.features.textures != 0 ? key.material : kNone;
    return std::make_tuple(key.cull, key.mask, key.lit, textured, key.holed,
                           byMaterial ? key.material : kNone, command.baseInstance);
  }
};

bool sameRun(const DrawRun& a, const DrawRun& b) {
  return a.cull == b.cull && a.lit == b.lit && a.mask == b.mask && a.holed == b.holed &&
         a.features == b.features && a.material == b.material;
}

bool hasVertexColor(const Primitive& primitive) {
  static constexpr glm::vec4 kWhite(1.0F);
  return std::any_of(primitive.attributes.begin(), primitive.attributes.end(),
                     [](const VertexAttributes& v) { return v.color != kWhite; });
}

/// @param vein number of the material's veins or kNone
SurfaceFeatures featuresOf(const Material& m, bool vertexColor, std::int32_t vein) {
  SurfaceFeatures f;
  f.veins = static_cast<std::uint8_t>(vein + 1);
  f.vertexColor = vertexColor;
  f.doubleSided = m.doubleSided;
  f.transmission = m.transmission > 0.0F && !m.unlit;
  f.alpha = m.alphaMode;
  const auto add = [&f](const TextureRef& texture, int unit) {
    if (texture.image == kNone) return;
    const unsigned bit = 1U << unit;
    f.textures = static_cast<std::uint8_t>(f.textures | bit);
    if (texture.uvSet == 1) f.secondUv = static_cast<std::uint8_t>(f.secondUv | bit);
  };
  add(m.baseColorTexture, TEX_BASE_COLOR);
  add(m.normalTexture, TEX_NORMAL);
  if (m.unlit) return f;  // the others are parts of its light
  add(m.metallicRoughnessTexture, TEX_METALLIC_ROUGHNESS);
  add(m.occlusionTexture, TEX_OCCLUSION);
  add(m.emissiveTexture, TEX_EMISSIVE);
  return f;
}

/// Of a run that is drawn for its depth alone: culling matters, and the base colour where alpha is
/// tested.
DrawRun depthRunOf(DrawRun run) {
  run.lit = false;
  const bool tested = run.mask || run.holed;
  SurfaceFeatures f;
  if (tested) {
    f.textures = run.features.textures & (1U << TEX_BASE_COLOR);
    f.secondUv = static_cast<std::uint8_t>(run.features.secondUv & f.textures);
    f.alpha = run.features.alpha;
    f.vertexColor = run.features.vertexColor;
  } else {
    run.material = kNone;
  }
  run.features = f;
  return run;
}

CullMode cullModeOf(const Material& material, const glm::mat4& transform) {
  if (material.doubleSided) return CullMode::None;
  return glm::determinant(glm::mat3(transform)) < 0.0F ? CullMode::BackMirrored : CullMode::Back;
}

DrawList makeList(std::string_view label, std::vector<Draw> draws, bool byMaterial,
                  DrawOrder order) {
  DrawList list;
  std::sort(draws.begin(), draws.end(), [byMaterial](const Draw& a, const Draw& b) {
    return a.order(byMaterial) < b.order(byMaterial);
  });
  if (order.reversed) std::reverse(draws.begin(), draws.end());
  std::vector<DrawCommand> commands;
  for (const Draw& draw : draws) {
    const auto index = static_cast<std::uint32_t>(commands.size());
    if (list.runs.empty() || !sameRun(list.runs.back(), draw.key)) {
      list.runs.push_back(draw.key);
      list.runs.back().first = index;
    }
    ++list.runs.back().count;
    const DrawRun depthKey = depthRunOf(draw.key);
    if (list.depthRuns.empty() || !sameRun(list.depthRuns.back(), depthKey)) {
      list.depthRuns.push_back(depthKey);
      list.depthRuns.back().first = index;
    }
    ++list.depthRuns.back().count;
    list.triangles += draw.command.count / 3;
    commands.push_back(draw.command);
    list.bounds.push_back(draw.bounds);
  }
  list.visible.assign(commands.size(), 1);
  if (!commands.empty()) list.commands = gl::Buffer::of<DrawCommand>(label, commands);
  return list;
}

}  // namespace

void GpuScene::buildDrawLists(const Scene& scene, DrawOrder order) {
  std::vector<Draw> opaque;
  std::vector<Draw> transparent;
  const std::vector<AlphaHoles> holes = alphaHolesOf(scene);
  const std::vector<std::int32_t> veins = veinNumbers(scene);
  std::vector<bool> colored;
  std::vector<Bounds> boxes;
  for (const Primitive& primitive : scene.primitives) {
    colored.push_back(hasVertexColor(primitive));
    boxes.push_back(boundsOf(primitive));
  }
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Primitive& primitive = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(primitive);
    const Placement& placement = placements_[instance.primitive];
    if (placement.indexCount == 0 || holes[instance.primitive] == AlphaHoles::All) continue;
    Draw draw;
    draw.bounds = transformed(boxes[instance.primitive], instance.transform);
    draw.command.count = placement.indexCount;
    draw.command.firstIndex = placement.firstIndex;
    draw.command.baseVertex = placement.baseVertex;
    draw.command.baseInstance = static_cast<std::uint32_t>(i);
    draw.key.cull = cullModeOf(material, instance.transform);
    draw.key.lit = !material.unlit;
    draw.key.mask = material.alphaMode == AlphaMode::Mask && !material.isTransparent();
    draw.key.holed = holes[instance.primitive] == AlphaHoles::Some;
    const std::int32_t vein =
        primitive.material == kNone ? kNone : veins[static_cast<std::size_t>(primitive.material)];
    draw.key.features = featuresOf(material, colored[instance.primitive], vein);
    draw.key.material = primitive.material;
    draw.key.count = 0;
    (material.isTransparent() ? transparent : opaque).push_back(draw);
  }
  opaque_ = makeList("opaque draws", std::move(opaque), true, order);
  transparent_ = makeList("transparent draws", transparent, true, order);
  transparentInOrder_ =
      makeList("transparent draws in order", std::move(transparent), false, order);
}

}  // namespace macula::scene
