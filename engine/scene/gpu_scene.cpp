#include "engine/scene/gpu_scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>

#include "engine/core/error.h"
#include "engine/scene/alpha_holes.h"
#include "engine/scene/vertex_order.h"
#include "engine/scene/visibility.h"
#include "shared/bindings.h"
#include "shared/scene_data.h"

namespace macula::scene {
namespace {

glm::vec4 row(const glm::mat4& m, int i) {
  return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

template <typename T>
gl::Buffer bufferOf(std::string_view label, const std::vector<T>& values) {
  // A buffer of no bytes is an error in GL; an empty scene still binds one element.
  static const T kNothing{};
  return values.empty() ? gl::Buffer(label, sizeof(T), &kNothing)
                        : gl::Buffer::of<T>(label, values);
}

void setCulling(CullMode cull) {
  if (cull == CullMode::None) {
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
  } else {
    glEnable(GL_CULL_FACE);
    glFrontFace(cull == CullMode::BackMirrored ? GL_CW : GL_CCW);
  }
}

/// Of the bound buffer.
void drawCommands(std::size_t first, std::size_t count) {
  constexpr std::size_t kCommandBytes = 5 * sizeof(GLuint);
  if (count == 0) return;
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                              reinterpret_cast<const void*>(first * kCommandBytes),
                              static_cast<GLsizei>(count), 0);
}

/// One instance, read as vertex attributes.
struct InstanceAttributes {
  std::array<glm::vec4, 3> modelRows;   ///< of the 3x4 object-to-world matrix
  std::array<glm::vec4, 3> normalRows;  ///< of its inverse transpose; w of the first: -1 where the
                                        ///< transform mirrors, else 1
  glm::uvec2 ids;                       ///< of the first triangle; step of the id (1 or -1)
};

}  // namespace

GpuScene::GpuScene(const Scene& scene, const Environment* environment, DrawOrder order)
    : facts_(factsOf(scene, environment != nullptr)),
      bounds_(boundsOf(scene)),
      transparentBounds_(transparentBoundsOf(scene)) {
  uploadGeometry(scene, order);
  uploadTextures(scene);
  uploadMaterials(scene);
  buildDrawLists(scene, order);
  uploadLights(scene, environment);
  bytes_ += positions_.bytes() + attributes_.bytes() + indices_.bytes() + instances_.bytes() +
            materials_.bytes() + lights_.bytes();
  for (const DrawList* list : {&opaque_, &transparent_, &transparentInOrder_}) {
    bytes_ += list->commands.bytes();
  }
  for (const gl::Texture& image : images_) bytes_ += image.bytes();
  if (environment_) bytes_ += environment_.bytes();
}

void GpuScene::uploadGeometry(const Scene& scene, DrawOrder order) {
  std::vector<glm::vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<std::uint32_t> indices;
  for (const Primitive& given : scene.primitives) {
    const Material& material = scene.materialOf(given);
    // Fragments of transparent triangles carry ids, which follow the file.
    const bool reorder = !material.isTransparent();
    const Primitive ordered = reorder ? orderedForDrawing(given) : Primitive{};
    const Primitive& primitive = reorder ? ordered : given;
    Placement placement;
    placement.firstIndex = static_cast<std::uint32_t>(indices.size());
    placement.indexCount = static_cast<std::uint32_t>(primitive.indices.size());
    placement.baseVertex = static_cast<std::int32_t>(positions.size());
    placements_.push_back(placement);
    positions.insert(positions.end(), primitive.positions.begin(), primitive.positions.end());
    attributes.insert(attributes.end(), primitive.attributes.begin(), primitive.attributes.end());
    const std::size_t triangles = primitive.indices.size() / 3;
    for (std::size_t i = 0; i < triangles; ++i) {
      const std::uint32_t* corners =
          &primitive.indices[3 * (order.reversed ? triangles - 1 - i : i)];
      // One corner thrice covers no pixel, and the ids of the others stay.
      const bool nothing = isNothing(material, primitive, corners);
      for (std::size_t c = 0; c < 3; ++c) indices.push_back(corners[nothing ? 0 : c]);
    }
  }
  positions_ = bufferOf("positions", positions);
  attributes_ = bufferOf("vertex attributes", attributes);
  indices_ = bufferOf("indices", indices);

  std::vector<InstanceAttributes> instances;
  std::uint64_t firstId = 0;
  for (const Instance& instance : scene.instances) {
    const Primitive& primitive = scene.primitives[instance.primitive];
    const glm::mat4& m = instance.transform;
    const glm::mat3 linear(m);
    const float determinant = glm::determinant(linear);
    // A flattening transform has no inverse; its normals come out as zero and are replaced in the
    // shader by the default direction.
    const glm::mat3 normal = std::abs(determinant) > std::numeric_limits<float>::min()
                                 ? glm::transpose(glm::inverse(linear))
                                 : glm::mat3(0.0F);
    const glm::mat4 n(normal);
    const auto triangles = static_cast<std::uint32_t>(primitive.indices.size() / 3);
    InstanceAttributes data{};
    for (std::size_t i = 0; i < 3; ++i) {
      data.modelRows[i] = row(m, static_cast<int>(i));
      data.normalRows[i] = row(n, static_cast<int>(i));
    }
    data.normalRows[0].w = determinant < 0.0F ? -1.0F : 1.0F;
    // Reversed triangles keep their ids: the last one drawn first has the highest.
    data.ids.x = static_cast<std::uint32_t>(firstId) + (order.reversed ? triangles - 1 : 0);
    data.ids.y = order.reversed ? std::numeric_limits<std::uint32_t>::max() : 1;
    instances.push_back(data);
    firstId += triangles;
  }
  if (firstId > std::numeric_limits<std::uint32_t>::max()) {
    failInput("{}: {} triangles are more than a fragment's 32-bit id can tell apart", scene.name,
              firstId);
  }
  instances_ = bufferOf("instances", instances);

  GLuint vao = 0;
  glCreateVertexArrays(1, &vao);
  vertexArray_ = gl::VertexArrayId(vao);
  gl::label(GL_VERTEX_ARRAY, vao, "scene");
  glVertexArrayVertexBuffer(vao, 0, positions_.id(), 0, sizeof(glm::vec3));
  glVertexArrayVertexBuffer(vao, 1, attributes_.id(), 0, sizeof(VertexAttributes));
  glVertexArrayVertexBuffer(vao, 2, instances_.id(), 0, sizeof(InstanceAttributes));
  glVertexArrayBindingDivisor(vao, 2, 1);
  glVertexArrayElementBuffer(vao, indices_.id());
  const auto floats = [vao](GLuint attribute, GLuint binding, GLint size, std::size_t offset) {
    glEnableVertexArrayAttrib(vao, attribute);
    glVertexArrayAttribFormat(vao, attribute, size, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(vao, attribute, binding);
  };
  floats(ATTR_POSITION, 0, 3, 0);
  floats(ATTR_NORMAL, 1, 3, offsetof(VertexAttributes, normal));
  floats(ATTR_TANGENT, 1, 4, offsetof(VertexAttributes, tangent));
  floats(ATTR_UV0, 1, 2, offsetof(VertexAttributes, uv0));
  floats(ATTR_UV1, 1, 2, offsetof(VertexAttributes, uv1));
  floats(ATTR_COLOR, 1, 4, offsetof(VertexAttributes, color));
  for (GLuint i = 0; i < 3; ++i) {
    const std::size_t bytes = i * sizeof(glm::vec4);
    floats(ATTR_MODEL_ROWS + i, 2, 4, offsetof(InstanceAttributes, modelRows) + bytes);
    floats(ATTR_NORMAL_ROWS + i, 2, 4, offsetof(InstanceAttributes, normalRows) + bytes);
  }
  glEnableVertexArrayAttrib(vao, ATTR_IDS);
  glVertexArrayAttribIFormat(vao, ATTR_IDS, 2, GL_UNSIGNED_INT,
                             static_cast<GLuint>(offsetof(InstanceAttributes, ids)));
  glVertexArrayAttribBinding(vao, ATTR_IDS, 2);
}

void GpuScene::bindGeometry() const {
  glBindVertexArray(vertexArray_.id());
}

void GpuScene::bindLights() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LIGHTS, lights_.id());
  if (environment_) glBindTextureUnit(TEX_ENVIRONMENT, environment_.id());
}

void GpuScene::bindMaterial(const DrawRun& run) const {
  const auto index = static_cast<std::size_t>(run.material + 1);
  glBindBufferRange(GL_UNIFORM_BUFFER, UBO_MATERIAL, materials_.id(),
                    static_cast<GLintptr>(index * materialStride_), sizeof(shader::MaterialData));
  if (run.features.textures == 0) return;
  const MaterialTextures& set = materialTextures_[index];
  glBindTextures(TEX_BASE_COLOR, MATERIAL_TEXTURES, set.textures.data());
  glBindSamplers(TEX_BASE_COLOR, MATERIAL_TEXTURES, set.samplers.data());
}

void GpuScene::chooseVisible(const glm::mat4& viewProjection) const {
  for (const DrawList* list : {&opaque_, &transparent_, &transparentInOrder_}) {
    for (std::size_t i = 0; i < list->bounds.size(); ++i) {
      list->visible[i] = mayBeSeen(list->bounds[i], viewProjection) ? 1 : 0;
    }
  }
}

void GpuScene::draw(const DrawList& list, const DrawRun& run) const {
  setCulling(run.cull);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.commands.id());
  const std::size_t end = std::size_t{run.first} + run.count;
  for (std::size_t i = run.first; i < end;) {
    std::size_t next = i;
    while (next < end && list.visible[next] != 0) ++next;
    drawCommands(i, next - i);
    i = next + 1;
  }
}

void GpuScene::drawAll(const DrawList& list, const DrawRun& run) const {
  setCulling(run.cull);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.commands.id());
  drawCommands(run.first, run.count);
}

}  // namespace macula::scene
