#include "engine/scene/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/plural.h"
#include "engine/scene/mesh_attributes.h"

namespace macula::scene::gltf {
namespace {

// Sets of four influences that are read; files in use have one or two.
constexpr std::size_t kMaxInfluenceSets = 4;
// Vertices whose positions have no bytes in the file: nothing bounds their count but this.
constexpr std::uint64_t kMaxUnbackedVertices = std::uint64_t{1} << 20U;

bool has(const tinygltf::Primitive& source, const std::string& semantic) {
  return source.attributes.contains(semantic);
}

bool isFinite(const glm::vec2& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

glm::vec3 vec3At(const Elements& e, std::size_t i) {
  return {e.at(i, 0), e.at(i, 1), e.at(i, 2)};
}

}  // namespace

void MeshReader::countVertices(std::uint64_t vertices) {
  vertices_ += vertices;
  if (vertices_ > limits_.vertices) {
    document_.fail(place_, "the meshes hold more than {} vertices; split the file",
                   limits_.vertices);
  }
}

void MeshReader::countIndices(std::uint64_t indices) {
  indices_ += indices;
  if (indices_ > limits_.indices) {
    document_.fail(place_, "the meshes hold more than {} indices; split the file", limits_.indices);
  }
}

bool MeshReader::isSkinned(std::int32_t mesh, std::int32_t skin) const {
  if (skin == kNone || mesh < 0 ||
      static_cast<std::size_t>(mesh) >= document_.model.meshes.size()) {
    return false;
  }
  const auto& primitives = document_.model.meshes[static_cast<std::size_t>(mesh)].primitives;
  return std::all_of(primitives.begin(), primitives.end(), [](const tinygltf::Primitive& p) {
    return has(p, "JOINTS_0") && has(p, "WEIGHTS_0");
  });
}

MeshReader::Range MeshReader::read(std::int32_t mesh, std::int32_t skin) {
  if (mesh < 0 || static_cast<std::size_t>(mesh) >= document_.model.meshes.size()) {
    document_.fail("nodes", "a node names mesh {} of {}; export the file again", mesh,
                   document_.model.meshes.size());
  }
  const auto [entry, isNew] = ranges_.try_emplace({mesh, skin});
  if (!isNew) return entry->second;
  const tinygltf::Mesh& source = document_.model.meshes[static_cast<std::size_t>(mesh)];
  Range range{static_cast<std::uint32_t>(scene_.primitives.size()), 0};
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    place_ = source.name.empty() ? fmt::format("mesh {} primitive {}", mesh, i)
                                 : fmt::format("mesh {} ({}) primitive {}", mesh, source.name, i);
    readPrimitive(source.primitives[i], skin);
  }
  range.count = static_cast<std::uint32_t>(scene_.primitives.size()) - range.first;
  entry->second = range;
  return range;
}

void MeshReader::readPrimitive(const tinygltf::Primitive& source, std::int32_t skin) {
  if (source.mode < TINYGLTF_MODE_POINTS || source.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    document_.fail(place_, "unknown mode {}; export the file again", source.mode);
  }
  if (source.mode < TINYGLTF_MODE_TRIANGLES) {
    document_.warn(place_, "{} are not drawn",
                   source.mode == TINYGLTF_MODE_POINTS ? "points" : "lines");
    return;
  }
  const auto position = source.attributes.find("POSITION");
  if (position == source.attributes.end()) {
    document_.warn(place_, "has no positions and is not drawn");
    return;
  }
  Primitive primitive;
  primitive.material = source.material;
  if (source.material != kNone &&
      (source.material < 0 ||
       static_cast<std::size_t>(source.material) >= scene_.materials.size())) {
    document_.fail(place_, "names material {} of {}; export the file again", source.material,
                   scene_.materials.size());
  }
  count_ = vertexCount(source, position->second);
  readAttributes(source, primitive);
  readIndexList(source, primitive);
  if (skin != kNone) applyPose(source, skin, primitive);
  if (!source.targets.empty()) {
    document_.warnings.add("morph targets are drawn in their base shape");
  }
  dropUnusable(primitive);
  if (primitive.indices.empty()) {
    document_.warn(place_, "has no triangles");
    return;
  }
  completeAttributes(source, primitive);
  scene_.primitives.push_back(std::move(primitive));
}

std::size_t MeshReader::vertexCount(const tinygltf::Primitive& source, std::int32_t position) {
  const tinygltf::Accessor& accessor = accessorAt(document_, position, place_);
  if (accessor.bufferView == kNone && accessor.count > kMaxUnbackedVertices) {
    document_.fail(place_, "{} without data; export the file again",
                   counted(accessor.count, "position"));
  }
  for (const auto& [semantic, index] : source.attributes) {
    const std::size_t count = accessorAt(document_, index, place_).count;
    if (count != accessor.count) {
      document_.fail(place_, "{} has {} for {}; export the file again", oneLine(semantic),
                     counted(count, "element"), counted(accessor.count, "position"));
    }
  }
  countVertices(accessor.count);
  return accessor.count;
}

Elements MeshReader::attribute(const tinygltf::Primitive& source, const std::string& semantic,
                               std::size_t least, std::size_t most, Integers integers) {
  const auto found = source.attributes.find(semantic);
  if (found == source.attributes.end()) return {};
  const std::string place = place_ + " " + semantic;
  Elements elements = readElements(document_, found->second, count_, place, integers);
  if (elements.components < least || elements.components > most) {
    document_.fail(place, "has {} where {} needed; export the file again",
                   counted(elements.components, "component"), counted(least, "is", "are"));
  }
  return elements;
}

void MeshReader::readAttributes(const tinygltf::Primitive& source, Primitive& primitive) {
  const Elements positions = attribute(source, "POSITION", 3, 3);
  const Elements normals = attribute(source, "NORMAL", 3, 3);
  const Elements tangents = attribute(source, "TANGENT", 4, 4);
  const Elements uv0 = attribute(source, "TEXCOORD_0", 2, 2);
  const Elements uv1 = attribute(source, "TEXCOORD_1", 2, 2);
  const Elements colors = attribute(source, "COLOR_0", 3, 4, Integers::Normalized);
  primitive.positions.resize(count_);
  primitive.attributes.resize(count_);
  bool repaired = false;
  for (std::size_t i = 0; i < count_; ++i) {
    primitive.positions[i] = vec3At(positions, i);
    VertexAttributes& vertex = primitive.attributes[i];
    if (normals.count > 0) vertex.normal = vec3At(normals, i);
    if (tangents.count > 0) vertex.tangent = glm::vec4(vec3At(tangents, i), tangents.at(i, 3));
    if (uv0.count > 0) vertex.uv0 = {uv0.at(i, 0), uv0.at(i, 1)};
    if (uv1.count > 0) vertex.uv1 = {uv1.at(i, 0), uv1.at(i, 1)};
    if (colors.count > 0) {
      vertex.color = glm::vec4(vec3At(colors, i), colors.components == 4 ? colors.at(i, 3) : 1.0F);
    }
    if (!isFinite(vertex.uv0) || !isFinite(vertex.uv1)) {
      vertex.uv0 = vertex.uv1 = glm::vec2(0.0F);
      repaired = true;
    }
    if (!isUsable(glm::vec3(vertex.color)) || !std::isfinite(vertex.color.a)) {
      vertex.color = glm::vec4(1.0F);
      repaired = true;
    }
  }
  if (repaired)
    document_.warn(place_, "texture coordinates or colours that are not finite are reset");
}

void MeshReader::readIndexList(const tinygltf::Primitive& source, Primitive& primitive) {
  std::vector<std::uint32_t> indices;
  const bool list = source.mode == TINYGLTF_MODE_TRIANGLES;
  const std::uint64_t asked =
      source.indices == kNone ? count_ : accessorAt(document_, source.indices, place_).count;
  countIndices(list ? asked : 3 * asked);
  if (source.indices == kNone) {
    indices.resize(count_);
    std::iota(indices.begin(), indices.end(), 0U);
  } else {
    indices = readIndices(document_, source.indices, place_);
    const auto largest = std::max_element(indices.begin(), indices.end());
    if (largest != indices.end() && *largest >= count_) {
      document_.fail(place_, "index {} has no vertex among {}; export the file again", *largest,
                     count_);
    }
  }
  if (list && indices.size() % 3 != 0) {
    document_.warn(place_, "{} no whole number of triangles, the last are left out",
                   counted(indices.size(), "index is", "indices are"));
  }
  const Topology topology = list                                          ? Topology::Triangles
                            : source.mode == TINYGLTF_MODE_TRIANGLE_STRIP ? Topology::TriangleStrip
                                                                          : Topology::TriangleFan;
  primitive.indices = triangleList(topology, indices);
}

void MeshReader::applyPose(const tinygltf::Primitive& source, std::int32_t skin,
                           Primitive& primitive) {
  Influences influences;
  for (std::size_t set = 0; set < kMaxInfluenceSets; ++set) {
    const std::string joints = fmt::format("JOINTS_{}", set);
    const std::string weights = fmt::format("WEIGHTS_{}", set);
    if (!has(source, joints) || !has(source, weights)) break;
    influences.joints.push_back(attribute(source, joints, 4, 4));
    influences.weights.push_back(attribute(source, weights, 4, 4, Integers::Normalized));
  }
  auto pose = poses_.find(skin);
  if (pose == poses_.end()) pose = poses_.emplace(skin, poseOf(document_, tree_, skin)).first;
  applySkin(document_, pose->second, influences, place_, primitive);
  document_.warnings.add("skins stand in the pose of the file's nodes");
}

// Removes triangles that cannot be drawn, and their coordinates from all sums over positions.
void MeshReader::dropUnusable(Primitive& primitive) {
  std::vector<bool> unusable(primitive.positions.size(), false);
  bool any = false;
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    if (isUsable(primitive.positions[i])) continue;
    unusable[i] = any = true;
  }
  if (!any) return;
  std::vector<std::uint32_t> kept;
  glm::vec3 stand(0.0F);  // a position in use, so that the box of the primitive does not grow
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* corner = &primitive.indices[i];
    if (unusable[corner[0]] || unusable[corner[1]] || unusable[corner[2]]) continue;
    if (kept.empty()) stand = primitive.positions[corner[0]];
    kept.insert(kept.end(), corner, corner + 3);
  }
  if (const std::size_t lost = (primitive.indices.size() - kept.size()) / 3; lost > 0) {
    document_.warn(place_, "{} with coordinates that are not finite {} left out",
                   counted(lost, "triangle"), nounFor(lost, "is", "are"));
  }
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    if (unusable[i]) primitive.positions[i] = stand;
  }
  primitive.indices = std::move(kept);
}

void MeshReader::completeAttributes(const tinygltf::Primitive& source, Primitive& primitive) {
  const bool hasNormals = has(source, "NORMAL");
  if (!hasNormals) {
    countVertices(primitive.indices.size());
    splitWithFlatNormals(primitive);
  } else if (const std::uint64_t broken = repairNormals(primitive); broken > 0) {
    document_.warn(place_, "{} without direction {} replaced", counted(broken, "normal"),
                   nounFor(broken, "is", "are"));
  }
  // Without normals the file's tangents do not count: specification section 3.7.2.1.
  if (has(source, "TANGENT") && hasNormals) {
    repairTangents(primitive);
  } else if (const TextureRef& map = scene_.materialOf(primitive).normalTexture;
             map.image != kNone) {
    computeTangents(primitive, map.uvSet);
  }
}

}  // namespace macula::scene::gltf
