#include "engine/scene/gltf_nodes.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "engine/core/plural.h"

namespace macula::scene::gltf {
namespace {

std::string placeOf(std::size_t node) {
  return fmt::format("node {}", node);
}

void checkSize(const Document& document, std::size_t node, const std::vector<double>& values,
               std::size_t size, const char* what) {
  if (values.empty() || values.size() == size) return;
  document.fail(placeOf(node), "its {} has {} numbers where {} are needed; export the file again",
                what, values.size(), size);
}

// Specification section 3.5.2: matrix, or translation * rotation * scale.
glm::dmat4 localTransform(Document& document, std::size_t index) {
  const tinygltf::Node& node = document.model.nodes[index];
  checkSize(document, index, node.matrix, 16, "matrix");
  checkSize(document, index, node.translation, 3, "translation");
  checkSize(document, index, node.rotation, 4, "rotation");
  checkSize(document, index, node.scale, 3, "scale");
  glm::dmat4 m(1.0);
  if (!node.matrix.empty()) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) m[c][r] = node.matrix[static_cast<std::size_t>(4 * c + r)];
    }
    // glTF matrices are affine; a last row off by rounding or worse must not act as a projection.
    for (int c = 0; c < 4; ++c) m[c][3] = c == 3 ? 1.0 : 0.0;
    return m;
  }
  if (!node.rotation.empty()) {
    glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    const double length = glm::length(q);
    if (!(length > 0.0) || !std::isfinite(length)) {
      document.warn(placeOf(index), "its rotation is no quaternion and left out");
    } else {
      m = glm::dmat4(glm::mat3_cast(q / length));
    }
  }
  for (int c = 0; c < 3 && !node.scale.empty(); ++c)
    m[c] *= node.scale[static_cast<std::size_t>(c)];
  if (!node.translation.empty()) {
    m[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
  }
  return m;
}

// The parent of each node, kNone for roots.
std::vector<std::int32_t> findParents(const Document& document) {
  const auto& nodes = document.model.nodes;
  std::vector<std::int32_t> parents(nodes.size(), kNone);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      if (child < 0 || static_cast<std::size_t>(child) >= nodes.size()) {
        document.fail(placeOf(i), "names child {} of {}; export the file again", child,
                      nodes.size());
      }
      std::int32_t& parent = parents[static_cast<std::size_t>(child)];
      if (parent != kNone) {
        document.fail(placeOf(static_cast<std::size_t>(child)),
                      "is a child of both node {} and node {}, but the hierarchy must be a tree; "
                      "export the file again",
                      parent, i);
      }
      parent = static_cast<std::int32_t>(i);
    }
  }
  return parents;
}

std::vector<std::int32_t> sceneRoots(const Document& document,
                                     const std::vector<std::int32_t>& roots) {
  const auto& model = document.model;
  if (model.scenes.empty()) return roots;
  const int chosen = model.defaultScene < 0 ? 0 : model.defaultScene;
  if (static_cast<std::size_t>(chosen) >= model.scenes.size()) {
    document.fail("scene", "names scene {} of {}; export the file again", chosen,
                  model.scenes.size());
  }
  const std::vector<int>& nodes = model.scenes[static_cast<std::size_t>(chosen)].nodes;
  for (const int node : nodes) {
    if (node < 0 || static_cast<std::size_t>(node) >= model.nodes.size()) {
      document.fail(fmt::format("scene {}", chosen), "names node {} of {}; export the file again",
                    node, model.nodes.size());
    }
  }
  return nodes;
}

// All nodes below the given ones, each once, parents before children.
std::vector<std::int32_t> traverse(const Document& document,
                                   const std::vector<std::int32_t>& roots) {
  std::vector<bool> visited(document.model.nodes.size(), false);
  std::vector<std::int32_t> order;
  std::vector<std::int32_t> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const std::int32_t index = stack.back();
    stack.pop_back();
    if (visited[static_cast<std::size_t>(index)]) continue;
    visited[static_cast<std::size_t>(index)] = true;
    order.push_back(index);
    const std::vector<int>& children =
        document.model.nodes[static_cast<std::size_t>(index)].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return order;
}

}  // namespace

NodeTree placeNodes(Document& document) {
  const std::size_t count = document.model.nodes.size();
  const std::vector<std::int32_t> parents = findParents(document);
  std::vector<std::int32_t> roots;
  for (std::size_t i = 0; i < count; ++i) {
    if (parents[i] == kNone) roots.push_back(static_cast<std::int32_t>(i));
  }
  const std::vector<std::int32_t> all = traverse(document, roots);
  if (all.size() < count) {  // with one parent each, only a ring has no way from a root
    document.fail("nodes", "{} of {} are their own ancestors; export the file again",
                  count - all.size(), counted(count, "node"));
  }
  std::vector<glm::dmat4> exact(count, glm::dmat4(1.0));
  NodeTree tree;
  tree.world.resize(count);
  for (const std::int32_t node : all) {
    const auto i = static_cast<std::size_t>(node);
    exact[i] = localTransform(document, i);
    if (parents[i] != kNone) exact[i] = exact[static_cast<std::size_t>(parents[i])] * exact[i];
    tree.world[i] = glm::mat4(exact[i]);
    for (int c = 0; c < 4; ++c) {
      if (!isUsable(glm::vec3(tree.world[i][c]))) {
        document.fail(placeOf(i), "its transform is beyond {:g}; export the file again",
                      kMaxCoordinate);
      }
    }
  }
  tree.drawn = traverse(document, sceneRoots(document, roots));
  return tree;
}

}  // namespace macula::scene::gltf
