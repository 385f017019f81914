// GpuScene: which draws, in which runs.
#include <algorithm>
#include <tuple>

#include "engine/scene/alpha_holes.h"
#include "engine/scene/gpu_scene.h"

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
  DrawRun key;

  [[nodiscard]] auto order() const {
    return std::make_tuple(key.cull, key.mask, key.lit, key.texturedMaterial, key.holed,
                           command.baseInstance);
  }
};

bool sameRun(const DrawRun& a, const DrawRun& b) {
  return a.cull == b.cull && a.lit == b.lit && a.mask == b.mask && a.holed == b.holed &&
         a.texturedMaterial == b.texturedMaterial;
}

bool isTextured(const Material& m) {
  return m.baseColorTexture.image != kNone || m.metallicRoughnessTexture.image != kNone ||
         m.normalTexture.image != kNone || m.occlusionTexture.image != kNone ||
         m.emissiveTexture.image != kNone;
}

CullMode cullModeOf(const Material& material, const glm::mat4& transform) {
  if (material.doubleSided) return CullMode::None;
  return glm::determinant(glm::mat3(transform)) < 0.0F ? CullMode::BackMirrored : CullMode::Back;
}

DrawList makeList(std::string_view label, std::vector<Draw> draws, DrawOrder order) {
  DrawList list;
  std::sort(draws.begin(), draws.end(),
            [](const Draw& a, const Draw& b) { return a.order() < b.order(); });
  if (order.reversed) std::reverse(draws.begin(), draws.end());
  std::vector<DrawCommand> commands;
  for (const Draw& draw : draws) {
    const auto index = static_cast<std::uint32_t>(commands.size());
    if (list.runs.empty() || !sameRun(list.runs.back(), draw.key)) {
      list.runs.push_back(draw.key);
      list.runs.back().first = index;
    }
    ++list.runs.back().count;
    // For depth alone, only the culling matters, and textures where alpha is tested.
    DrawRun depthKey = draw.key;
    depthKey.lit = false;
    if (!draw.key.mask && !draw.key.holed) depthKey.texturedMaterial = kNone;
    if (list.depthRuns.empty() || !sameRun(list.depthRuns.back(), depthKey)) {
      list.depthRuns.push_back(depthKey);
      list.depthRuns.back().first = index;
    }
    ++list.depthRuns.back().count;
    list.triangles += draw.command.count / 3;
    commands.push_back(draw.command);
  }
  if (!commands.empty()) list.commands = gl::Buffer::of<DrawCommand>(label, commands);
  return list;
}

}  // namespace

void GpuScene::buildDrawLists(const Scene& scene, DrawOrder order) {
  std::vector<Draw> opaque;
  std::vector<Draw> transparent;
  const std::vector<AlphaHoles> holes = alphaHolesOf(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Primitive& primitive = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(primitive);
    const Placement& placement = placements_[instance.primitive];
    if (placement.indexCount == 0 || holes[instance.primitive] == AlphaHoles::All) continue;
    Draw draw;
    draw.command.count = placement.indexCount;
    draw.command.firstIndex = placement.firstIndex;
    draw.command.baseVertex = placement.baseVertex;
    draw.command.baseInstance = static_cast<std::uint32_t>(i);
    draw.key.cull = cullModeOf(material, instance.transform);
    draw.key.lit = !material.unlit;
    draw.key.mask = material.alphaMode == AlphaMode::Mask && !material.isTransparent();
    draw.key.holed = holes[instance.primitive] == AlphaHoles::Some;
    draw.key.texturedMaterial = isTextured(material) ? primitive.material : kNone;
    draw.key.count = 0;
    (material.isTransparent() ? transparent : opaque).push_back(draw);
  }
  opaque_ = makeList("opaque draws", std::move(opaque), order);
  transparent_ = makeList("transparent draws", std::move(transparent), order);
}

}  // namespace macula::scene
