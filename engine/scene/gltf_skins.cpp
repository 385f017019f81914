#include "engine/scene/gltf_skins.h"

#include <utility>

namespace macula::scene::gltf {
namespace {

glm::mat4 matrixAt(const Elements& elements, std::size_t i) {
  glm::mat4 m;
  for (std::size_t c = 0; c < 16; ++c) {
    m[static_cast<int>(c / 4)][static_cast<int>(c % 4)] = elements.at(i, c);
  }
  return m;
}

// Weighted sum of the joints of one vertex, weights made to sum to 1.
glm::mat4 blend(const Document& document, const SkinPose& pose, const Influences& influences,
                std::size_t vertex, std::string_view place) {
  glm::mat4 sum(0.0F);
  float total = 0.0F;
  for (std::size_t set = 0; set < influences.joints.size(); ++set) {
    for (std::size_t c = 0; c < 4; ++c) {
      const float weight = influences.weights[set].at(vertex, c);
      if (!(weight > 0.0F)) continue;
      const float joint = influences.joints[set].at(vertex, c);
      if (!(joint >= 0.0F && joint < static_cast<float>(pose.size()))) {
        document.fail(place, "vertex {} names joint {} of {}; export the file again", vertex, joint,
                      pose.size());
      }
      sum += pose[static_cast<std::size_t>(joint)] * weight;
      total += weight;
    }
  }
  // A vertex without weights follows the first joint, as most viewers draw it.
  if (!(total > 0.0F)) return pose.front();
  return sum / total;
}

}  // namespace

SkinPose poseOf(const Document& document, const NodeTree& tree, std::int32_t skin) {
  const std::string place = fmt::format("skin {}", skin);
  if (skin < 0 || static_cast<std::size_t>(skin) >= document.model.skins.size()) {
    document.fail(place, "does not exist among {}; export the file again",
                  document.model.skins.size());
  }
  const tinygltf::Skin& source = document.model.skins[static_cast<std::size_t>(skin)];
  if (source.joints.empty()) document.fail(place, "has no joints; export the file again");
  Elements inverseBind;
  if (source.inverseBindMatrices != kNone) {
    inverseBind = readElements(document, source.inverseBindMatrices, source.joints.size(), place);
    if (inverseBind.components != 16) {
      document.fail(place, "its inverse bind matrices are not MAT4; export the file again");
    }
  }
  SkinPose pose;
  for (std::size_t i = 0; i < source.joints.size(); ++i) {
    const int joint = source.joints[i];
    if (joint < 0 || static_cast<std::size_t>(joint) >= tree.world.size()) {
      document.fail(place, "names node {} of {} as a joint; export the file again", joint,
                    tree.world.size());
    }
    glm::mat4 matrix = tree.world[static_cast<std::size_t>(joint)];
    if (inverseBind.count > 0) matrix = matrix * matrixAt(inverseBind, i);
    pose.push_back(matrix);
  }
  return pose;
}

void applySkin(const Document& document, const SkinPose& pose, const Influences& influences,
               std::string_view place, Primitive& primitive) {
  std::vector<bool> mirrored(primitive.positions.size(), false);
  for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
    const glm::mat4 m = blend(document, pose, influences, i, place);
    const glm::mat3 linear(m);
    // Normals take the cofactors, the inverse transpose times the determinant, which exist even
    // where a joint flattens.
    const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                              glm::cross(linear[0], linear[1]));
    const bool mirrors = glm::dot(linear[0], cofactors[0]) < 0.0F;
    mirrored[i] = mirrors;
    VertexAttributes& vertex = primitive.attributes[i];
    primitive.positions[i] = glm::vec3(m * glm::vec4(primitive.positions[i], 1.0F));
    vertex.normal = cofactors * vertex.normal * (mirrors ? -1.0F : 1.0F);
    // The bitangent is a cross product and turns with mirroring.
    vertex.tangent = glm::vec4(linear * glm::vec3(vertex.tangent),
                               mirrors ? -vertex.tangent.w : vertex.tangent.w);
  }
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    if (mirrored[primitive.indices[i]])
      std::swap(primitive.indices[i + 1], primitive.indices[i + 2]);
  }
}

}  // namespace macula::scene::gltf
