// Shader assembly, and every variant through the reference compiler.
#include "engine/gl/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/core/error.h"
#include "model_network.h"
#include "oit_combinations.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/utility/demand.h"

namespace macula::gl {
namespace {

namespace fs = std::filesystem;
const fs::path kShaders = fs::path(MACULA_SOURCE_DIR) / "shaders";

class TemporaryFolder {
 public:
  TemporaryFolder() {
    path_ = fs::temp_directory_path() /
            ("macula_shaders_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
             "_" + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

TEST(ShaderSource, PutsVersionDefinesAndIncludesTogether) {
  const TemporaryFolder folder;
  folder.write("a.glsl", "int a;\n");
  folder.write("main.comp", "#include \"a.glsl\"\n#include \"a.glsl\"\nvoid main() {}\n");
  EXPECT_EQ(assembleShader(folder.path(), "main.comp", {{"K", "4"}}, {"GL_X"}),
            "#version 450 core\n#extension GL_X : require\n#define MACULA_GLSL 1\n#define K 4\n"
            "#line 1 0\n#line 1 1\nint a;\n#line 2 0\n#line 3 0\nvoid main() {}\n");
}

TEST(ShaderSource, LiteralsReadBackAsTheSameFloat) {
  for (const float value : {0.0F, 1.0F, 0.1F, 16777216.0F, 1e-30F, 3.4e38F, 1.1754944e-38F}) {
    const std::string text = literal(value);
    EXPECT_EQ(std::stof(text), value) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << " would be an integer";
  }
  EXPECT_EQ(literal(-0.5F), "(-0.5)");
  EXPECT_EQ(literal(-0.0F), "(-0.0)");
}

TEST(ShaderSource, NamesAMissingInclude) {
  const TemporaryFolder folder;
  folder.write("main.comp", "#include \"gone.glsl\"\n");
  try {
    (void)assembleShader(folder.path(), "main.comp", {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("gone.glsl"));
  }
}

struct Variant {
  std::string file;
  Defines defines;
  std::vector<std::string> extensions;
};

/// What one switch stands for: a textured run is compiled with all textures, and one with colours
/// in its vertices with everything else that a material can have.
void addSwitch(Defines& defines, const std::string& name) {
  std::vector<std::string> names{name};
  if (name == "TEXTURED") {
    names = {name,         "BASE_COLOR_MAP", "METALLIC_ROUGHNESS_MAP",
             "NORMAL_MAP", "OCCLUSION_MAP",  "EMISSIVE_MAP",
             "SECOND_UV"};
  } else if (name == "VERTEX_COLOR") {
    names = {name, "DOUBLE_SIDED", "TRANSMISSION"};
  }
  for (const std::string& each : names) defines.emplace_back(each, "1");
}

/// Every combination of the given switches on top of some fixed defines.
void addCombinations(std::vector<Variant>& out, const std::string& file, const Defines& fixed,
                     const std::vector<std::string>& switches,
                     const std::vector<std::string>& extensions = {}) {
  for (unsigned bits = 0; bits < (1U << switches.size()); ++bits) {
    Variant variant{file, fixed, extensions};
    for (std::size_t i = 0; i < switches.size(); ++i) {
      if ((bits & (1U << i)) != 0) addSwitch(variant.defines, switches[i]);
    }
    out.push_back(std::move(variant));
  }
}

Defines together(const Defines& a, const Defines& b) {
  Defines all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

/// Adds a variant unless it is there already.
class VariantSet {
 public:
  void add(const Variant& variant) {
    std::string name = variant.file;
    for (const auto& [key, value] : variant.defines) name += " " + key + "=" + value;
    for (const std::string& extension : variant.extensions) name += " " + extension;
    if (seen_.insert(name).second) all_.push_back(variant);
  }
  void addAll(const std::vector<Variant>& variants) {
    for (const Variant& variant : variants) add(variant);
  }
  [[nodiscard]] const std::vector<Variant>& all() const { return all_; }

 private:
  std::vector<Variant> all_;
  std::set<std::string> seen_;
};

/// Numbers of every form: negative, whole, small, with an exponent.
shader::LightBlock sampleLights() {
  shader::LightBlock block{};
  block.ambient = {0.1F, 0.0F, 1e-30F, 2.0F};
  block.shadowMatrix = glm::mat4(-0.5F);
  block.shadow = {12.5F, 1e-4F, 0.0F, 0.0F};
  block.lights[0] = {
      {-1.0F, 2.0F, 3.0F, 1.0F}, {0, 0, -1, 0}, {7e9F, 1, 1, 0}, {1000, -0.0F, 0, 0}};
  return block;
}

/// What lit, textured and environment runs add. All of their combinations are compiled with
/// oit/blend.frag; the least and the most are enough where an option multiplies them.
const std::vector<std::string> kShading{"LIT",     "TEXTURED",    "HOLED",
                                        "SHADOWS", "ENVIRONMENT", "VERTEX_COLOR"};
const std::vector<Defines> kShadingEnds{
    {},
    {{"TEXTURED", "1"}, {"BASE_COLOR_MAP", "1"}, {"SECOND_UV", "1"}, {"ALPHA_BLEND", "1"}},
    {{"TEXTURED", "1"}, {"BASE_COLOR_MAP", "1"}, {"HOLED", "1"}, {"ALPHA_MASK", "1"}},
    {{"LIT", "1"}, {"VERTEX_COLOR", "1"}, {"SHADOWS", "1"}, {"ENVIRONMENT", "1"}},
    {{"LIT", "1"},
     {"SHADOWS", "1"},
     {"SHADOW_LIGHT", "1"},
     {"EACH_LIGHT(F)", "F(0, 1u) F(1, 0u)"},
     {"LIGHT_CONSTANTS", passes::constantOf(sampleLights())}}};

void addOpaque(std::vector<Variant>& all) {
  addCombinations(all, "scene.vert", {{"POSITION_ONLY", "1"}}, {"SHADOW", "WITH_IDS"});
  addCombinations(all, "scene.vert", {{"UV_ONLY", "1"}}, {"SHADOW"});
  addCombinations(all, "scene.vert", {}, {"TEXTURED", "VERTEX_COLOR"});
  addCombinations(all, "scene.vert", {{"UV_ONLY", "1"}, {"HOLED", "1"}}, {"WITH_IDS"});
  addCombinations(all, "scene.vert", {{"VERTEX_LIGHT", "1"}},
                  {"LIT", "TEXTURED", "HOLED", "ENVIRONMENT", "VERTEX_COLOR"});
  addCombinations(all, "gbuffer.frag", {}, {"LIT", "TEXTURED", "MASK", "VERTEX_COLOR"});
  addCombinations(all, "shadow.frag", {{"MASK", "1"}, {"UV_ONLY", "1"}},
                  {"TEXTURED", "VERTEX_COLOR"});
  addCombinations(all, "shadow.frag", {{"POSITION_ONLY", "1"}}, {});
  addCombinations(all, "lighting.comp", {}, {"LIT", "SHADOWS", "ENVIRONMENT"});
  const Defines rich{{"LIT", "1"},   {"SHADOWS", "1"},   {"SHADOW_TAPS", "9"},
                     {"VEINS", "1"}, {"OCCLUSION", "1"}, {"ENVIRONMENT", "1"}};
  const Defines skips{{"SKIP_SHADOW", "1"}, {"SKIP_OCCLUSION", "1"}, {"SKIP_NOISE", "1"}};
  for (const char* place : {"AT_PIXELS", "AT_GRID", "AT_TILES", "AT_HOLES"}) {
    addCombinations(all, "lighting.comp", together(rich, {{place, "1"}}), {});
    addCombinations(all, "lighting.comp", together(rich, {{place, "1"}, {"PARTS_OUT", "1"}}),
                    {"SKIP_SHADOW", "SKIP_OCCLUSION", "SKIP_NOISE"});
  }
  addCombinations(all, "lighting.comp", together(together(rich, skips), {{"PARTS_IN", "1"}}), {});
  for (const char* place : {"AT_GRID", "AT_TILES"}) {
    addCombinations(all, "lighting.comp", together(rich, {{place, "1"}, {"DEMODULATE", "1"}}), {});
  }
  addCombinations(all, "lod/reconstruct.comp", {{"MACULA", "1"}, {"DEMODULATE", "1"}},
                  {"FOVEATED", "SHADE_HOLES", "UNLIT"});
  for (const char* file : {"lod/rates.comp", "lod/depth.frag", "lod/transparency.comp"}) {
    addCombinations(all, file, {}, {});
  }
  for (const char* filter : {"BILINEAR", "YANG2008", "MACULA"}) {
    addCombinations(all, "lod/reconstruct.comp", {{filter, "1"}},
                    {"PARTS", "FOVEATED", "SHADE_HOLES"});
  }
  for (const char* curve : {"0", "1", "2"}) {
    addCombinations(all, "tonemap.comp", {{"TONEMAP", curve}, {"SSAA", "2"}}, {"LINEAR_OUT"});
  }
  addCombinations(all, "heatmap.comp", {{"SOURCE_CHANNEL", "g"}}, {"SOURCE_INTEGER"});
  addCombinations(all, "heatmap.comp", {{"SOURCE_RATE", "1"}}, {});
  addCombinations(all, "difference.comp", {}, {});
  addCombinations(all, "time_source.comp", {}, {});
}

/// Passes whose defines do not depend on the options of a method.
void addPlainTransparent(std::vector<Variant>& all) {
  for (const char* file :
       {"oit/sync_check.vert", "oit/sync_check.frag", "oit/full_screen.vert", "oit/tile_depth.frag",
        "oit/routing_check.frag", "oit/routing_check.comp", "oit/routing_depth.frag",
        "oit/reserve.comp", "oit/histogram.comp", "oit/one_k.comp", "oit/weighted_resolve.comp",
        "oit/predict.comp", "oit/extent.comp"}) {
    addCombinations(all, file, {}, {});
  }
  addCombinations(all, "oit/covered.comp", {{"SAMPLED", "1"}}, {});
  const Defines ids{{"POSITION_ONLY", "1"}, {"WITH_IDS", "1"}};
  // Where alpha is tested, that of a run without colours needs what it comes from.
  const Defines tested{{"UV_ONLY", "1"}, {"HOLED", "1"}};
  const Defines testedIds = together(tested, {{"WITH_IDS", "1"}});
  addCombinations(all, "oit/count.frag", {{"POSITION_ONLY", "1"}}, {"RANGE"});
  addCombinations(all, "oit/count.frag", tested, {"RANGE", "TEXTURED"});
  addCombinations(all, "oit/atomic_keys.frag", testedIds, {"STAGE_IDS", "TEXTURED"});
  addCombinations(all, "oit/occupancy.frag", tested, {"RANGES", "TEXTURED"});
  for (const char* stage : {"STAGE_DEPTH", "STAGE_IDS"}) {
    addCombinations(all, "oit/peel.frag", together(testedIds, {{stage, "1"}}), {"TEXTURED"});
  }
  addCombinations(all, "oit/importance.comp", {}, {"FACTORS"});
  addCombinations(all, "oit/prefix.comp", {}, {});
  addCombinations(all, "oit/prefix_rows.comp", {}, {});
  addCombinations(all, "oit/atomic_keys.frag", ids, {"STAGE_IDS"});
  addCombinations(all, "oit/peel.frag", together(ids, {{"STAGE_DEPTH", "1"}}), {});
  addCombinations(all, "oit/peel.frag", together(ids, {{"STAGE_IDS", "1"}}), {});
  addCombinations(all, "oit/peel.frag", {{"STAGE_COLOR", "1"}}, kShading);
  addCombinations(all, "oit/occupancy.frag", {{"POSITION_ONLY", "1"}}, {"RANGES", "SYNC_ORDERED"});
  addCombinations(all, "oit/cull_depth.frag", {}, {"RANGES"});
  addCombinations(all, "oit/peel_layer.comp", {}, {"FINISH"});
  addCombinations(all, "oit/statistics.comp", {}, {"SLOTS_RANGES", "FILLS"});
  for (const char* tile : {"1", "2"}) {
    addCombinations(all, "oit/slices.frag",
                    {{"VERTEX_LIGHT", "1"}, {"SLICES", "4"}, {"SLICE_TILE", tile}},
                    {"SYNC_ORDERED", "LEARNED", "LIT", "TEXTURED", "HOLED", "ENVIRONMENT"});
  }
  addCombinations(all, "oit/count_colors.frag", {{"VERTEX_LIGHT", "1"}},
                  {"LIT", "TEXTURED", "HOLED", "ENVIRONMENT"});
  for (const char* file : {"oit/blend.frag", "oit/weighted.frag", "oit/routed.frag"}) {
    addCombinations(all, file, {}, kShading);
  }
}

/// The passes around networks of importance, at every size of tiles; a small network stands for
/// larger ones.
void addNetworks(std::vector<Variant>& all) {
  using passes::NetworkModel;
  for (const int tile : {1, 2, 4}) {
    addCombinations(all, "oit/covered.comp", {{"LISTED_TILE", std::to_string(tile)}}, {});
    addCombinations(all, "oit/network_importance.comp", {{"NETWORK_TILE", std::to_string(tile)}},
                    {"FACTORS"});
    for (const NetworkModel model : {NetworkModel::Thesis, NetworkModel::Learned}) {
      const Defines network = networkDefines(test::randomNetwork(model, {3, 2}, 1), model, tile);
      for (const char* listed : {"1", "2", "4"}) {
        addCombinations(all, "oit/network.comp", together(network, {{"LISTED_TILE", listed}}), {});
      }
      addCombinations(all, "oit/network.comp", together(network, {{"FEATURES_OUT", "1"}}), {});
      addCombinations(all, "oit/network.comp", together(network, {{"PROBE", "1"}}), {});
    }
  }
}

/// Passes that the plan of one combination of options specialises, as their prepare() does.
void addPlanned(VariantSet& all, const passes::OitPlan& plan) {
  const passes::Method& method = *plan.method;
  if (!method.stores()) return;
  all.add({"oit/resolve.comp", definesOf(plan), {}});
  if (method.insertion.sortedAtResolve) {
    all.add({"oit/resolve.comp", together(definesOf(plan), {{"DEEP", "1"}}), {}});
  }
  if (plan.sharesByUtility()) {
    const Defines demand = demandDefines(plan);
    if (plan.slices()) {
      const std::string listed = std::to_string(plan.listedTile());
      all.add({"oit/marginal_demand.comp", together(demand, {{"LISTED_TILE", listed}}), {}});
      all.add({"oit/demand.comp", together(demand, {{"DEMAND_STORED", "1"}}), {}});
    } else {
      all.add({"oit/demand.comp", demand, {}});
    }
    for (const char* round : {"0", "1"}) {
      all.add({"oit/multiplier.comp", together(demand, {{"ROUND", round}}), {}});
    }
    all.add({"oit/share.comp", slotRangeDefines(plan), {}});
  } else if (method.hasRanges()) {
    all.add({"oit/allocate.comp",
             together(slotRangeDefines(plan), {{method.allocation.define, "1"}}),
             {}});
  }
  if (!method.captures()) return;
  for (const Defines& shading : kShadingEnds) {
    all.add({"oit/capture.frag", together(captureDefines(plan), shading), captureExtensions(plan)});
  }
}

std::vector<Variant> allVariants() {
  std::vector<Variant> plain;
  addOpaque(plain);
  addPlainTransparent(plain);
  addNetworks(plain);
  VariantSet all;
  all.addAll(plain);
  for (const passes::OitSettings& settings : test::acceptedSettings()) {
    for (const passes::SyncMode sync : test::syncModesOf(passes::methodById(settings.method))) {
      passes::OitPlan plan = test::planOf(settings, sync);
      for (const int tile : {1, 2, 4}) {
        plan.importance.networkTile = tile;
        addPlanned(all, plan);
        if (!plan.usesNetwork()) break;
      }
    }
  }
  return all.all();
}

TEST(ShaderVariants, EveryFileHasOne) {
  std::set<std::string> covered;
  for (const Variant& variant : allVariants()) covered.insert(variant.file);
  for (const auto& entry : fs::recursive_directory_iterator(kShaders)) {
    const std::string extension = entry.path().extension();
    if (extension != ".vert" && extension != ".frag" && extension != ".comp") continue;
    EXPECT_THAT(covered, testing::Contains(fs::relative(entry.path(), kShaders).string()));
  }
}

TEST(ShaderVariants, EveryOneCompiles) {
  if (std::system("command -v glslangValidator >/dev/null") != 0) {
    GTEST_SKIP() << "glslangValidator is not installed (package glslang-tools)";
  }
  const TemporaryFolder folder;
  std::string command = "glslangValidator";
  int number = 0;
  for (const Variant& variant : allVariants()) {
    for (const bool groups : {false, true}) {
      Defines defines = variant.defines;
      if (groups) defines.emplace_back("GROUP_SUMS", "1");
      const std::string text = assembleShader(kShaders, variant.file, defines, variant.extensions);
      if (groups && text.find("#ifdef GROUP_SUMS") == std::string::npos) continue;
      const std::string name =
          std::to_string(number++) + fs::path(variant.file).extension().string();
      folder.write(name, text);
      command += " " + (folder.path() / name).string();
    }
  }
  const fs::path log = folder.path() / "log.txt";
  const int status = std::system((command + " >" + log.string() + " 2>&1").c_str());
  if (status != 0) {
    std::ifstream in(log);
    std::string line;
    while (std::getline(in, line)) {
      if (line.find("ERROR") != std::string::npos) ADD_FAILURE() << line;
    }
  }
  EXPECT_EQ(status, 0) << number << " variants";
}

}  // namespace
}  // namespace macula::gl
