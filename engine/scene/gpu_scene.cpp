#include "engine/scene/gpu_scene.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "engine/core/error.h"
#include "engine/scene/alpha_holes.h"
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
            instanceNumbers_.bytes() + materials_.bytes() + lights_.bytes();
  for (const gl::Texture& image : images_) bytes_ += image.bytes();
  if (environment_) bytes_ += environment_.bytes();
}

void GpuScene::uploadGeometry(const Scene& scene, DrawOrder order) {
  std::vector<glm::vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<std::uint32_t> indices;
  for (const Primitive& primitive : scene.primitives) {
    const Material& material = scene.materialOf(primitive);
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

  std::vector<shader::Instance> instances;
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
    shader::Instance data{};
    data.modelRow0 = row(m, 0);
    data.modelRow1 = row(m, 1);
    data.modelRow2 = row(m, 2);
    data.normalRow0 = glm::vec4(glm::vec3(row(n, 0)), determinant < 0.0F ? -1.0F : 1.0F);
    data.normalRow1 = row(n, 1);
    data.normalRow2 = row(n, 2);
    // Material 0 is the glTF default one.
    data.ids.x = static_cast<std::uint32_t>(primitive.material + 1);
    // Reversed triangles keep their ids: the last one drawn first has the highest.
    data.ids.y = static_cast<std::uint32_t>(firstId) + (order.reversed ? triangles - 1 : 0);
    data.ids.z = order.reversed ? std::numeric_limits<std::uint32_t>::max() : 1;
    instances.push_back(data);
    firstId += triangles;
  }
  if (firstId > std::numeric_limits<std::uint32_t>::max()) {
    failInput("{}: {} triangles are more than a fragment's 32-bit id can tell apart", scene.name,
              firstId);
  }
  instances_ = bufferOf("instances", instances);
  std::vector<std::uint32_t> numbers(std::max<std::size_t>(1, instances.size()));
  std::iota(numbers.begin(), numbers.end(), 0U);
  instanceNumbers_ = bufferOf("instance numbers", numbers);

  GLuint vao = 0;
  glCreateVertexArrays(1, &vao);
  vertexArray_ = gl::VertexArrayId(vao);
  gl::label(GL_VERTEX_ARRAY, vao, "scene");
  glVertexArrayVertexBuffer(vao, 0, positions_.id(), 0, sizeof(glm::vec3));
  glVertexArrayVertexBuffer(vao, 1, attributes_.id(), 0, sizeof(VertexAttributes));
  glVertexArrayVertexBuffer(vao, 2, instanceNumbers_.id(), 0, sizeof(std::uint32_t));
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
  glEnableVertexArrayAttrib(vao, ATTR_INSTANCE);
  glVertexArrayAttribIFormat(vao, ATTR_INSTANCE, 1, GL_UNSIGNED_INT, 0);
  glVertexArrayAttribBinding(vao, ATTR_INSTANCE, 2);
}

void GpuScene::bindGeometry() const {
  glBindVertexArray(vertexArray_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_INSTANCES, instances_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_MATERIALS, materials_.id());
}

void GpuScene::bindLights() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LIGHTS, lights_.id());
  if (environment_) glBindTextureUnit(TEX_ENVIRONMENT, environment_.id());
}

void GpuScene::bindMaterialTextures(std::int32_t material) const {
  const MaterialTextures& set = materialTextures_[static_cast<std::size_t>(material + 1)];
  glBindTextures(TEX_BASE_COLOR, MATERIAL_TEXTURES, set.textures.data());
  glBindSamplers(TEX_BASE_COLOR, MATERIAL_TEXTURES, set.samplers.data());
}

void GpuScene::draw(const DrawList& list, const DrawRun& run) const {
  if (run.cull == CullMode::None) {
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
  } else {
    glEnable(GL_CULL_FACE);
    glFrontFace(run.cull == CullMode::BackMirrored ? GL_CW : GL_CCW);
  }
  constexpr std::size_t kCommandBytes = 5 * sizeof(GLuint);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.commands.id());
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                              reinterpret_cast<const void*>(run.first * kCommandBytes),
                              static_cast<GLsizei>(run.count), 0);
}

}  // namespace macula::scene
