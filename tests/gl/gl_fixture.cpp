#include "gl_fixture.h"

#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>

#include "engine/core/error.h"

namespace macula::test {
namespace {

/// Made on first use and kept for the program: contexts and compiled shaders are expensive.
struct World {
  /// Tests compile what they test, and leave the user's cache alone.
  int noCache = setenv("MACULA_SHADER_CACHE", "off", 1);
  window::HeadlessContext context{window::EglPlatform::Auto, true};
  gl::DebugLog log;
  passes::DeviceContext device;

  World() {
    const char* expected = std::getenv("MACULA_EXPECTED_DRIVER");
    if (expected != nullptr && device.capabilities.renderer.find(expected) == std::string::npos) {
      throw std::runtime_error("the tests were to run on " + std::string(expected) +
                               " and run on " + device.capabilities.renderer);
    }
  }
};

World& world() {
  static World* const instance = new World;  // never destroyed: GL must outlive every static
  return *instance;
}

/// Where a method leaves its per-pixel ordering to the device, MACULA_TEST_SYNC chooses it: a mode
/// that the device offers. tools/bundle/gpu-report.sh runs the tests with each.
passes::RenderSettings withTestedSync(passes::RenderSettings settings) {
  const char* sync = std::getenv("MACULA_TEST_SYNC");
  if (sync == nullptr || settings.oit.sync != "auto") return settings;
  passes::OitSettings asked = settings.oit;
  asked.sync = sync;
  try {
    passes::checkCombination(asked);
    settings.oit = asked;
  } catch (const InputError&) {  // its fragments need no ordering
  }
  return settings;
}

}  // namespace

void GlTest::SetUp() {
  world().log.clear();
}

void GlTest::TearDown() {
  for (const std::string& message : world().log.messages()) ADD_FAILURE() << "GL: " << message;
}

passes::DeviceContext& GlTest::device() {
  return world().device;
}
gl::DebugLog& GlTest::debugLog() {
  return world().log;
}

Bench::Bench(const scene::Scene& scene, const passes::RenderSettings& s, glm::ivec2 size,
             passes::DeviceContext& device, scene::DrawOrder order)
    : settings(withTestedSync(s)),
      gpu(scene, nullptr, order),
      renderer(settings, device),
      camera(scene.cameras.front()) {
  renderer.resize(size);
  renderer.setScene(gpu);
}

passes::FrameResult Bench::draw(glm::vec2 gaze, bool cut) {
  return renderer.render(camera, gaze, cut);
}

std::vector<std::uint8_t> Bench::display() const {
  std::vector<std::uint8_t> rgb;
  renderer.readDisplay(rgb);
  return rgb;
}

std::vector<std::uint8_t> Bench::shown() const {
  std::vector<std::uint8_t> rgb;
  renderer.readShown(rgb);
  return rgb;
}

std::vector<float> Bench::linear() const {
  std::vector<float> rgb;
  renderer.readLinear(rgb);
  return rgb;
}

namespace {

/// Level 0 of a texture, `channels` values a texel.
template <typename T>
std::vector<T> readTexels(const Bench& bench, const frame::Resource& resource, GLenum format,
                          GLenum type, int channels = 1) {
  const gl::Texture& texture = bench.renderer.resources().texture(resource);
  std::vector<T> data(static_cast<std::size_t>(texture.width()) *
                      static_cast<std::size_t>(texture.height()) *
                      static_cast<std::size_t>(channels));
  bench.renderer.resources().read(resource, format, type, data.size() * sizeof(T), data.data());
  return data;
}

}  // namespace

std::vector<std::uint32_t> Bench::words(const frame::Resource& resource, int channels) const {
  const GLenum format = channels == 4   ? GL_RGBA_INTEGER
                        : channels == 2 ? GL_RG_INTEGER
                                        : GL_RED_INTEGER;
  return readTexels<std::uint32_t>(*this, resource, format, GL_UNSIGNED_INT, channels);
}

std::vector<float> Bench::floats(const frame::Resource& resource, int channels) const {
  const GLenum format = channels == 4 ? GL_RGBA : channels == 2 ? GL_RG : GL_RED;
  return readTexels<float>(*this, resource, format, GL_FLOAT, channels);
}

std::vector<float> Bench::depths(const frame::Resource& resource) const {
  return readTexels<float>(*this, resource, GL_DEPTH_COMPONENT, GL_FLOAT);
}

std::vector<std::uint32_t> Bench::bufferWords(const frame::Resource& resource) const {
  return renderer.resources().readBuffer<std::uint32_t>(resource);
}

passes::RenderSettings linearSettings(const std::string& method, double kAve) {
  passes::RenderSettings settings;
  settings.oit.method = method;
  settings.oit.kAve = kAve;
  settings.tonemap.curve = "none";
  settings.tonemap.linearOut = true;
  return settings;
}

scene::Scene tangle(int triangles, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0F; };
  scene::Scene scene;
  scene.name = "tangle";
  scene::Material glass;
  glass.alphaMode = scene::AlphaMode::Blend;
  glass.doubleSided = true;
  glass.metallic = 0.0F;
  scene.materials = {glass, scene::Material{}};
  const auto corner = [&](scene::Primitive& p, glm::vec3 position, glm::vec4 color) {
    p.indices.push_back(static_cast<std::uint32_t>(p.positions.size()));
    p.positions.push_back(position);
    scene::VertexAttributes a;
    a.normal = glm::normalize(glm::vec3(unit() - 0.5F, unit() - 0.5F, 1.0F));
    a.color = color;
    p.attributes.push_back(a);
  };
  // Several primitives, so that reversing the draws has something to reverse.
  constexpr int kPrimitives = 4;
  for (int n = 0; n < kPrimitives; ++n) {
    scene::Primitive p;
    p.material = 0;
    for (int t = n; t < triangles; t += kPrimitives) {
      const glm::vec3 center(4.0F * unit() - 2.0F, 4.0F * unit() - 2.0F, -3.0F - 4.0F * unit());
      const glm::vec4 color(unit(), unit(), unit(), 0.1F + 0.7F * unit());
      for (int c = 0; c < 3; ++c) {
        corner(p, center + 2.5F * glm::vec3(unit() - 0.5F, unit() - 0.5F, unit() - 0.5F), color);
      }
    }
    scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
    scene.primitives.push_back(std::move(p));
  }
  scene::Primitive wall;  // opaque, slanted through the tangle
  wall.material = 1;
  for (const glm::vec3& v : {glm::vec3(-3, -3, -4), glm::vec3(3, -3, -6), glm::vec3(0, 1, -5)}) {
    corner(wall, v, glm::vec4(0.8F));
  }
  scene.instances.push_back({static_cast<std::uint32_t>(scene.primitives.size()), glm::mat4(1)});
  scene.primitives.push_back(std::move(wall));
  scene::addDefaultLights(scene);
  scene::Camera camera;
  camera.nearPlane = 0.1F;
  camera.farPlane = 20.0F;
  scene.cameras.push_back(camera);
  return scene;
}

}  // namespace macula::test
