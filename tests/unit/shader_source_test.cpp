// Shader assembly, and every variant through the reference compiler.
#include "engine/gl/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/core/error.h"

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

/// Every combination of the given switches on top of some fixed defines.
void addCombinations(std::vector<Variant>& out, const std::string& file, const Defines& fixed,
                     const std::vector<std::string>& switches,
                     const std::vector<std::string>& extensions = {}) {
  for (unsigned bits = 0; bits < (1U << switches.size()); ++bits) {
    Variant variant{file, fixed, extensions};
    for (std::size_t i = 0; i < switches.size(); ++i) {
      if ((bits & (1U << i)) != 0) variant.defines.emplace_back(switches[i], "1");
    }
    out.push_back(std::move(variant));
  }
}

std::vector<Variant> allVariants() {
  std::vector<Variant> all;
  for (const char* kind : {"POSITION_ONLY", "UV_ONLY"}) {
    addCombinations(all, "scene.vert", {{kind, "1"}}, {"SHADOW"});
  }
  addCombinations(all, "scene.vert", {}, {});
  addCombinations(all, "gbuffer.frag", {}, {"TEXTURED", "MASK"});
  addCombinations(all, "shadow.frag", {}, {"MASK"});
  addCombinations(all, "lighting.comp", {}, {"LIT", "SHADOWS", "ENVIRONMENT"});
  for (const char* curve : {"0", "1", "2"}) {
    addCombinations(all, "tonemap.comp", {{"TONEMAP", curve}, {"SSAA", "2"}}, {"LINEAR_OUT"});
  }
  addCombinations(all, "heatmap.comp", {{"SOURCE_CHANNEL", "g"}}, {"SOURCE_INTEGER"});
  addCombinations(all, "time_source.comp", {}, {});
  addCombinations(all, "oit/sync_check.vert", {}, {});
  addCombinations(all, "oit/sync_check.frag", {}, {});
  addCombinations(all, "oit/count.frag", {}, {});
  addCombinations(all, "oit/importance.comp", {}, {"FACTORS"});
  addCombinations(all, "oit/reserve.comp", {}, {});
  addCombinations(all, "oit/allocate.comp", {{"ALLOCATION_EXACT", "1"}}, {});
  addCombinations(all, "oit/allocate.comp", {{"ALLOCATION_IMPORTANCE", "1"}},
                  {"FRONT_NORMAL", "LOCKS"});
  addCombinations(all, "oit/resolve.comp", {}, {"SORTED"});
  const std::vector<std::string> shading{"LIT", "TEXTURED", "SHADOWS", "ENVIRONMENT"};
  addCombinations(all, "oit/blend.frag", {}, shading);
  for (const char* sync : {"SYNC_ORDERED", "SYNC_SPINLOCK", "SYNC_NONE"}) {
    addCombinations(all, "oit/capture.frag",
                    {{"INSERTION_SORTED", "1"}, {"FRONT_NORMAL", "1"}, {sync, "1"}}, shading);
    addCombinations(all, "oit/capture.frag", {{"INSERTION_APPEND", "1"}, {sync, "1"}}, shading);
  }
  addCombinations(all, "oit/capture.frag",
                  {{"INSERTION_SORTED", "1"}, {"FRONT_NORMAL", "1"}, {"SYNC_INTERLOCK", "1"}},
                  shading, {"GL_ARB_fragment_shader_interlock"});
  addCombinations(all, "oit/capture.frag", {{"INSERTION_APPEND", "1"}, {"SYNC_INTERLOCK", "1"}},
                  shading);
  return all;
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
    const std::string name = std::to_string(number++) + fs::path(variant.file).extension().string();
    folder.write(name, assembleShader(kShaders, variant.file, variant.defines, variant.extensions));
    command += " " + (folder.path() / name).string();
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
