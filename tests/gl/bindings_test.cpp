// What shaders use against what the frame binds: tables of passes, shared structs, shared memory.
#include <gmock/gmock.h>

#include <cstddef>
#include <map>
#include <set>

#include "gl_fixture.h"
#include "lod_scenes.h"
#include "oit_cases.h"
#include "oit_combinations.h"
#include "passes/frame_list.h"
#include "shared/bindings.h"
#include "shared/frame_constants.h"
#include "shared/lod_totals.h"
#include "shared/oit_totals.h"
#include "shared/scene_data.h"

namespace macula::test {
namespace {

using passes::RenderSettings;

constexpr glm::ivec2 kSize{48, 40};

/// Prepares frames as a renderer does, and draws none: tables and programs are compared then. A
/// difference is a debug message, which fails the test.
class Bindings : public GlTest {
 protected:
  /// @returns whether the device can do what the settings ask for
  bool prepare(const RenderSettings& settings, const scene::GpuScene& gpu) {
    frame::FrameInputs in = passes::inputsOf(gpu.facts());
    in.gpu = &gpu;
    in.outputSize = in.displaySize = kSize;
    const auto samples = static_cast<std::uint64_t>(kSize.x * kSize.y);
    passes::OitPlan plan;
    passes::LodPlan lod;
    try {
      planMethod(plan, {settings.oit, device().capabilities, device().ordered, samples});
    } catch (const InputError&) {
      return false;  // interlock, or stencil routing
    }
    plan.importance = settings.importance;
    plan.factorMaps = passes::needsFactors(settings.heatmap.map);
    plan.imageSize = kSize;
    planNetwork(plan, network_);
    planLod(lod, settings.lod, settings.foveation, in.facts, false);
    planFrame(lod, settings.lod, settings.foveation, in, 1);
    plan.resizable = lod.transparency;
    plan.size = lod.transparencySize();
    frame::FrameList list = makeFrameList(settings, plan, lod);
    EXPECT_THAT(list.validate(in), testing::IsEmpty());
    frame::FrameResources resources;
    list.prepare(in, resources, device().programs, {.limits = device().capabilities.limits});
    ++frames_;
    programs_ += list.compared().programs;
    rows_ += list.compared().rows;
    const std::vector<std::string>& messages = debugLog().messages();
    EXPECT_THAT(messages, testing::IsEmpty()) << describe(settings.oit);
    debugLog().clear();
    return messages.empty();
  }
  void TearDown() override {
    note("frames prepared", static_cast<double>(frames_));
    note("programs compared", static_cast<double>(programs_));
    note("rows compared", static_cast<double>(rows_));
    GlTest::TearDown();
  }

  std::size_t frames_ = 0;
  std::size_t programs_ = 0;
  std::size_t rows_ = 0;
  passes::LoadedNetwork network_;
};

/// Materials with an image, in whose holes there is nothing: the textured and the holed variants.
scene::Scene papered(scene::Scene scene) {
  scene.images.push_back(
      {.name = "paper", .width = 2, .height = 1, .rgba = {255, 255, 255, 0, 255, 255, 255, 255}});
  for (scene::Material& material : scene.materials) {
    material.baseColorTexture.image = 0;
    material.baseColorTexture.sampler.nearest = true;
    material.baseColorTexture.sampler.mipmaps = false;
  }
  scene.materials.back().alphaMode = scene::AlphaMode::Mask;
  return scene;
}

scene::Scene glassOnly() {
  scene::Scene scene = tangle(20, 1);
  scene.primitives.pop_back();
  scene.instances.pop_back();
  return scene;
}

TEST_F(Bindings, OfTransparencyAreWhatItsShadersUse) {
  const std::vector<scene::Scene> scenes{tangle(20, 1), unlit(tangle(20, 1)),
                                         papered(tangle(20, 1)), glassOnly()};
  std::vector<std::unique_ptr<scene::GpuScene>> gpus;
  for (const scene::Scene& scene : scenes) {
    gpus.push_back(std::make_unique<scene::GpuScene>(scene, nullptr));
  }
  std::set<std::string> methods;
  for (const passes::OitSettings& oit : acceptedSettings()) {
    for (const passes::SyncMode sync : syncModesOf(passes::methodById(oit.method))) {
      RenderSettings settings = settingsOf(oit);
      if (!passes::methodById(oit.method).isRacy()) settings.oit.sync = nameOf(sync);
      if (!isAccepted(settings.oit)) settings.oit.sync = "auto";
      // Scenes in turn, so that each option meets each scene.
      const scene::GpuScene& gpu = *gpus[frames_ % gpus.size()];
      if (!prepare(settings, gpu)) continue;
      methods.insert(oit.method);
      settings.lod = {.resize = 2.0, .transparency = true};
      prepare(settings, gpu);
    }
  }
  EXPECT_GE(methods.size(), passes::methods().size() - 1) << "all, but perhaps kb-stencil";
  EXPECT_GT(frames_, 300U);
}

TEST_F(Bindings, OfEveryMethodAreWhatItsShadersUseInEveryScene) {
  scene::Panorama even{32, 16, {}};
  even.pixels.assign(32 * 16, glm::vec3(0.5F));
  const scene::Environment environment = scene::makeEnvironment(even);
  scene::Scene shadowed = tangle(20, 1);
  shadowed.lights = still().lights;
  for (const scene::Scene& scene :
       {tangle(20, 1), unlit(tangle(20, 1)), papered(tangle(20, 1)), glassOnly(), shadowed}) {
    for (const scene::Environment* around :
         {static_cast<const scene::Environment*>(nullptr), &environment}) {
      const scene::GpuScene gpu(scene, around);
      for (const passes::Method& method : passes::methods()) {
        prepare(settingsOf({.method = std::string(method.id)}), gpu);
      }
    }
  }
}

TEST_F(Bindings, OfTheLevelOfDetailAreWhatItsShadersUse) {
  scene::Scene mixed = richStill();
  mixed.materials.front().unlit = true;
  for (const scene::Scene& scene : {still(), richStill(), swatches(), mixed}) {
    const scene::GpuScene gpu(scene, nullptr);
    for (const char* what : {"shading", "shadow", "ao", "noise", "ao,noise", "shadow,ao,noise"}) {
      for (const passes::Reconstruction reconstruction :
           {passes::Reconstruction::Bilinear, passes::Reconstruction::Yang2008,
            passes::Reconstruction::Macula}) {
        for (unsigned options = 0; options < 8; ++options) {
          RenderSettings settings = linearSettings("kb-variable");
          settings.lod.resize = 2.0;
          settings.lod.what = what;
          settings.lod.reconstruction = reconstruction;
          settings.lod.demodulate = (options & 1U) != 0;
          settings.lod.holes = (options & 2U) != 0 ? passes::Holes::Shade : passes::Holes::Tap;
          settings.foveation.enabled = (options & 4U) != 0;
          prepare(settings, gpu);
        }
      }
    }
  }
}

TEST_F(Bindings, OfHeatmapsAreWhatTheirShadersUse) {
  const scene::GpuScene gpu(tangle(20, 1), nullptr);
  for (const std::string& map : passes::heatmapNames()) {
    for (const bool foveated : {false, true}) {
      RenderSettings settings = linearSettings("kb-variable");
      settings.heatmap.map = map;
      settings.foveation.enabled = foveated;
      prepare(settings, gpu);
    }
  }
}

constexpr frame::Resource kShown{"shown", GL_RGBA8, frame::SizeRule::Output,
                                 frame::ByteClass::Other, frame::Initial::Undefined};

/// Tone mapping with a table that lacks the image it reads, and has one that it does not use.
class FaultyPass final : public frame::Pass {
 public:
  [[nodiscard]] std::string_view name() const override { return "faulty"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const override {
    d.image(IMG_0, kShown, frame::Access::Write);
    d.image(IMG_4, passes::kLinearColor, frame::Access::Write);
  }
  [[nodiscard]] bool hasWork(const frame::FrameInputs& /*in*/) const override { return true; }
  [[nodiscard]] std::string reason(const frame::FrameInputs& /*in*/) const override { return "-"; }
  void prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) override {
    program_ = programs.get({{"tonemap.comp"}, {{"TONEMAP", "0"}, {"SSAA", "1"}}, {}});
  }
  void execute(frame::PassContext& /*context*/) override { glUseProgram(program_); }

 private:
  GLuint program_ = 0;
};

TEST_F(Bindings, OfAFaultyTableAreReported) {
  std::vector<std::unique_ptr<frame::Pass>> passes;
  passes.push_back(std::make_unique<FaultyPass>());
  frame::FrameList list(std::move(passes), {&kShown});
  frame::FrameInputs in;
  in.outputSize = in.displaySize = kSize;
  frame::FrameResources resources;
  list.prepare(in, resources, device().programs, {.limits = device().capabilities.limits});
  EXPECT_THAT(
      debugLog().messages(),
      testing::UnorderedElementsAre(
          testing::HasSubstr("a shader uses hdrColor at texture unit 8, and no row binds it"),
          testing::HasSubstr("linear colour is bound at image unit 4, and no shader uses it"),
          testing::HasSubstr("a program needs 9 texture units, and its table says 7")));
  debugLog().clear();
}

TEST_F(GlTest, SharedMemoryChangesNoFrame) {
  const scene::Scene scene = tangle(120, 4);
  std::uint64_t apart = 0;
  std::uint64_t shared = 0;
  for (const passes::OitSettings& oit : completeCases(4)) {
    RenderSettings settings = settingsOf(oit);
    settings.lod = {.resize = 2.0, .transparency = true};
    settings.shadow.size = 64;  // or its bytes would hide those of the buffers
    Bench sharing(scene, settings, kSize, device());
    settings.readBack = true;
    Bench separate(scene, settings, kSize, device());
    for (int frame = 0; frame < 3; ++frame) {
      sharing.draw();
      separate.draw();
      EXPECT_EQ(sharing.linear(), separate.linear()) << describe(oit) << " frame " << frame;
    }
    EXPECT_LE(sharing.renderer.bytes().total, separate.renderer.bytes().total) << describe(oit);
    apart += separate.renderer.bytes().total;
    shared += sharing.renderer.bytes().total;
  }
  note("bytes in memory of their own", static_cast<double>(apart));
  note("bytes where buffers share memory", static_cast<double>(shared));
  EXPECT_LT(shared, apart * 97 / 100);
}

/// Byte offsets of the members of one struct, by their names in the shader.
using Members = std::map<std::string, std::size_t>;

// As the C++ compiler lays them out. A member that is missing here is found by the test.
#define OFFSET(Struct, member) \
  { #member, offsetof(shader::Struct, member) }
#define ELEMENT(Struct, member) \
  { #member "[0]", offsetof(shader::Struct, member) }

const Members kFrameConstants{OFFSET(FrameConstants, viewProjection),
                              OFFSET(FrameConstants, inverseViewProjection),
                              OFFSET(FrameConstants, eye),
                              OFFSET(FrameConstants, size),
                              OFFSET(FrameConstants, inverseSize),
                              OFFSET(FrameConstants, gaze),
                              OFFSET(FrameConstants, gazeSpread),
                              OFFSET(FrameConstants, padding0),
                              OFFSET(FrameConstants, background),
                              OFFSET(FrameConstants, frameIndex),
                              OFFSET(FrameConstants, historyValid),
                              OFFSET(FrameConstants, seed),
                              OFFSET(FrameConstants, padding1),
                              OFFSET(FrameConstants, pixelSlots),
                              OFFSET(FrameConstants, slots),
                              OFFSET(FrameConstants, sampledCellSide),
                              OFFSET(FrameConstants, occupancyWords),
                              OFFSET(FrameConstants, nearPlane),
                              OFFSET(FrameConstants, farPlane),
                              OFFSET(FrameConstants, sliceTile),
                              OFFSET(FrameConstants, padding2),
                              OFFSET(FrameConstants, reprojection),
                              OFFSET(FrameConstants, right),
                              OFFSET(FrameConstants, up),
                              OFFSET(FrameConstants, ahead),
                              OFFSET(FrameConstants, depthScale),
                              OFFSET(FrameConstants, depthOffset),
                              OFFSET(FrameConstants, padding3),
                              OFFSET(FrameConstants, padding4),
                              OFFSET(FrameConstants, pitch),
                              OFFSET(FrameConstants, inversePitch),
                              OFFSET(FrameConstants, viewerDistance),
                              OFFSET(FrameConstants, padding5),
                              OFFSET(FrameConstants, lodTexels),
                              OFFSET(FrameConstants, lodTiles),
                              OFFSET(FrameConstants, acuitySlope),
                              OFFSET(FrameConstants, fovealMar),
                              OFFSET(FrameConstants, samplesPerMar),
                              OFFSET(FrameConstants, coarsestRate)};

const Members kLights{OFFSET(LightBlock, ambient),      OFFSET(LightBlock, environment),
                      OFFSET(LightBlock, shadowMatrix), OFFSET(LightBlock, shadow),
                      OFFSET(LightBlock, occlusion),    ELEMENT(LightBlock, veins),
                      ELEMENT(LightBlock, irradiance)};
const Members kLight{OFFSET(LightData, position), OFFSET(LightData, direction),
                     OFFSET(LightData, color), OFFSET(LightData, cone)};
const Members kMaterial{OFFSET(MaterialData, baseColor), OFFSET(MaterialData, emissive),
                        OFFSET(MaterialData, surface), OFFSET(MaterialData, transmission)};
const Members kOitTotalsMembers{OFFSET(OitTotals, importanceLow), OFFSET(OitTotals, importanceHigh),
                                OFFSET(OitTotals, covered),       OFFSET(OitTotals, starved),
                                OFFSET(OitTotals, cursor),        OFFSET(OitTotals, countMax),
                                OFFSET(OitTotals, lockFailures),  OFFSET(OitTotals, oneLayer),
                                OFFSET(OitTotals, extent),        OFFSET(OitTotals, demand),
                                OFFSET(OitTotals, cut),           ELEMENT(OitTotals, dispatches),
                                ELEMENT(OitTotals, sampledDemand)};
const Members kStatistics{OFFSET(OitStatistics, generated), OFFSET(OitStatistics, stored),
                          OFFSET(OitStatistics, merged),    OFFSET(OitStatistics, slots),
                          OFFSET(OitStatistics, covered),   OFFSET(OitStatistics, countMax),
                          OFFSET(OitStatistics, kMax),      OFFSET(OitStatistics, kMinInverted),
                          OFFSET(OitStatistics, tails),     OFFSET(OitStatistics, padding0),
                          OFFSET(OitStatistics, padding1),  OFFSET(OitStatistics, padding2)};
const Members kLodTotalsMembers{ELEMENT(LodTotals, dispatches), OFFSET(LodTotals, shaded),
                                OFFSET(LodTotals, padding0), OFFSET(LodTotals, padding1),
                                OFFSET(LodTotals, padding2)};

#undef OFFSET
#undef ELEMENT

/// Where a block of a shader is declared, and what it should be like.
struct SharedBlock {
  gl::ProgramKey program;
  GLenum interface;    ///< of the members: GL_UNIFORM or GL_BUFFER_VARIABLE
  std::string prefix;  ///< of the members' names
  const Members& members;
  std::size_t offset;  ///< of the first of these structs
  std::size_t stride;  ///< from one to the next; 0: there is one
};

TEST_F(GlTest, SharedStructsLieAsTheShadersReadThem) {
  const gl::ProgramKey lighting{{"lighting.comp"}, {{"ENVIRONMENT", "1"}, {"LIT", "1"}}, {}};
  const gl::ProgramKey gbuffer{{"scene.vert", "gbuffer.frag"}, {{"LIT", "1"}}, {}};
  const gl::ProgramKey importance{{"oit/importance.comp"}, {}, {}};
  const gl::ProgramKey statistics{{"oit/statistics.comp"}, {}, {}};
  const gl::ProgramKey rates{{"lod/rates.comp"}, {}, {}};
  using shader::LightBlock;
  const std::vector<SharedBlock> blocks{
      {lighting, GL_UNIFORM, "frame.", kFrameConstants, 0, 0},
      {lighting, GL_UNIFORM, "lights.", kLights, 0, 0},
      {lighting, GL_UNIFORM, "lights.lights[0].", kLight, offsetof(LightBlock, lights), 0},
      {lighting, GL_UNIFORM, "lights.lights[1].", kLight,
       offsetof(LightBlock, lights) + sizeof(shader::LightData), 0},
      {gbuffer, GL_UNIFORM, "material.", kMaterial, 0, 0},
      {importance, GL_BUFFER_VARIABLE, "totals.", kOitTotalsMembers, 0, 0},
      {statistics, GL_BUFFER_VARIABLE, "statistics.", kStatistics, 0, 0},
      {rates, GL_BUFFER_VARIABLE, "totals.", kLodTotalsMembers, 0, 0}};
  std::size_t compared = 0;
  for (const SharedBlock& block : blocks) {
    const GLuint program = device().programs.get(block.program);
    const std::string where = block.program.files.back() + " " + block.prefix;
    Members missing = block.members;
    GLint count = 0;
    glGetProgramInterfaceiv(program, block.interface, GL_ACTIVE_RESOURCES, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
      std::array<GLchar, 128> text{};
      glGetProgramResourceName(program, block.interface, i, static_cast<GLsizei>(text.size()),
                               nullptr, text.data());
      const std::string name = text.data();
      if (!name.starts_with(block.prefix)) continue;
      const std::string member = name.substr(block.prefix.size());
      if (member.find('.') != std::string::npos) continue;  // of a struct inside of it
      const GLenum property = GL_OFFSET;
      GLint offset = -1;
      glGetProgramResourceiv(program, block.interface, i, 1, &property, 1, nullptr, &offset);
      const auto known = block.members.find(member);
      ASSERT_NE(known, block.members.end()) << where << member << " is not compared";
      EXPECT_EQ(static_cast<std::size_t>(offset), block.offset + known->second) << where << member;
      missing.erase(member);
      ++compared;
      if (block.stride == 0) continue;
      const GLenum strideKind = GL_TOP_LEVEL_ARRAY_STRIDE;
      GLint stride = 0;
      glGetProgramResourceiv(program, block.interface, i, 1, &strideKind, 1, nullptr, &stride);
      EXPECT_EQ(static_cast<std::size_t>(stride), block.stride) << where << member;
    }
    EXPECT_THAT(missing, testing::IsEmpty()) << where << ": not seen in the shader";
  }
  note("offsets compared", static_cast<double>(compared));
}

}  // namespace
}  // namespace macula::test
