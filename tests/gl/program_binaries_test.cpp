// Programs that are compiled together, and those that an earlier run has linked.
#include "engine/gl/program_binaries.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <span>

#include "engine/core/file.h"
#include "engine/core/sha256.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;
using gl::ProgramBinaries;

constexpr glm::ivec2 kSize{48, 40};

class Binaries : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = fs::temp_directory_path() /
              ("macula_binaries_" + std::to_string(fs::hash_value(fs::current_path())) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    if (!ProgramBinaries(folder_).active()) GTEST_SKIP() << "this driver has no binaries";
  }
  void TearDown() override {
    fs::remove_all(folder_);
    GlTest::TearDown();
  }

  struct Run {
    std::vector<std::vector<float>> images;
    ProgramBinaries::Counts counts;
  };
  /// Draws by some methods on a device of its own.
  static Run draw(ProgramBinaries binaries) {
    passes::DeviceContext own(std::move(binaries));
    Run run;
    for (const char* method : {"blend", "kb-variable", "ab-list"}) {
      Bench bench(tangle(40, 2), settingsOf({.method = method}), kSize, own);
      bench.draw();
      bench.draw();
      run.images.push_back(bench.linear());
    }
    run.counts = own.programs.binaries().counts();
    return run;
  }
  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path());
    return all;
  }
  /// Damages each file of a filled folder, and looks at how the next run fares.
  template <typename Function>
  void damage(const Function& function) {
    const Run first = draw(ProgramBinaries(folder_));
    ASSERT_GT(first.counts.stored, 10U);
    for (const fs::path& file : files()) {
      const std::string bytes = function(readTextFile(file));
      std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    }
    const Run second = draw(ProgramBinaries(folder_));
    EXPECT_EQ(second.images, first.images);
    EXPECT_EQ(second.counts.refused, first.counts.stored);
    EXPECT_EQ(second.counts.loaded, 0U);
    EXPECT_EQ(second.counts.stored, first.counts.stored) << "each is replaced";
    EXPECT_EQ(draw(ProgramBinaries(folder_)).counts.loaded, first.counts.stored);
  }

  fs::path folder_;
};

TEST_F(Binaries, ChangeNoImage) {
  const Run without = draw({});
  const Run first = draw(ProgramBinaries(folder_));
  const Run second = draw(ProgramBinaries(folder_));
  EXPECT_EQ(first.images, without.images);
  EXPECT_EQ(second.images, without.images);
  EXPECT_EQ(without.counts.stored, 0U);
  EXPECT_EQ(first.counts.loaded, 0U);
  EXPECT_EQ(second.counts.loaded, first.counts.stored);
  EXPECT_EQ(second.counts.stored, 0U);
  EXPECT_EQ(files().size(), first.counts.stored) << "no temporary file is left";
  note("programs", static_cast<double>(first.counts.stored));
  double bytes = 0.0;
  for (const fs::path& file : files()) bytes += static_cast<double>(fs::file_size(file));
  note("bytes a program", bytes / static_cast<double>(first.counts.stored));
}

TEST_F(Binaries, ThatAreDamagedAreCompiledAgain) {
  damage([](std::string bytes) {
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    return bytes;
  });
}

TEST_F(Binaries, ThatAreCutOffAreCompiledAgain) {
  std::size_t length = 0;
  damage([&](const std::string& bytes) {
    length = (length + 37) % bytes.size();  // within the header, and within the binary
    return bytes.substr(0, length);
  });
}

/// A file that is whole by its own hash. @param content format, of 8 digits, and binary
std::string wholeFile(const std::string& bytes, const std::string& content) {
  const std::string magic = bytes.substr(0, bytes.find('\n') + 1);
  return magic + sha256Hex(std::as_bytes(std::span(content))) + content;
}

TEST_F(Binaries, ThatTheDriverDoesNotTakeAreCompiledAgain) {
  damage([](const std::string& bytes) {
    const std::string format = bytes.substr(bytes.find('\n') + 1 + 64, 8);
    return wholeFile(bytes, format + std::string(1000, 'x'));
  });
}

TEST_F(Binaries, OfAnUnknownFormatAreCompiledAgain) {
  damage([](const std::string& bytes) { return wholeFile(bytes, "deadbeef" + bytes.substr(89)); });
}

TEST_F(Binaries, OfAnotherSourceOrDriverHaveAnotherName) {
  const ProgramBinaries binaries(folder_);
  EXPECT_NE(binaries.nameOf("a"), binaries.nameOf("b"));
  EXPECT_NE(binaries.nameOf("a"), ProgramBinaries().nameOf("a")) << "without a driver's strings";
  EXPECT_EQ(binaries.nameOf("a").size(), 64U);
}

TEST_F(Binaries, InAFolderThatCannotBeWrittenAreLeftOut) {
  const Run without = draw({});
  std::ofstream(folder_) << "a file stands there";
  // Not even root writes to the second and third.
  for (const fs::path& folder :
       {folder_ / "shaders", fs::path("/proc/self"), fs::path("/dev/null/shaders")}) {
    const Run run = draw(ProgramBinaries(folder));
    EXPECT_EQ(run.images, without.images) << folder;
    EXPECT_EQ(run.counts.stored, 0U) << folder;
    EXPECT_EQ(run.counts.lost, 1U) << folder << ": tried once and no more";
  }
}

/// While it lives, no file grows beyond so many bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(Binaries, OnAFullDiskLeaveNothingHalfWritten) {
  const Run without = draw({});
  Run run;
  {
    const FullDisk full(100);
    run = draw(ProgramBinaries(folder_));
  }
  EXPECT_EQ(run.images, without.images);
  EXPECT_EQ(run.counts.stored, 0U);
  EXPECT_EQ(run.counts.lost, 1U);
  EXPECT_TRUE(files().empty());
}

TEST_F(Binaries, KeepToTheirBoundAndLoseTheOldest) {
  (void)draw(ProgramBinaries(folder_));
  std::vector<fs::path> all = files();
  std::uint64_t sum = 0;
  for (const fs::path& file : all) sum += fs::file_size(file);
  // From the first to the last an hour older each.
  auto time = fs::file_time_type::clock::now();
  for (const fs::path& file : all) fs::last_write_time(file, time -= std::chrono::hours(1));
  std::ofstream(folder_ / "mine.txt") << "of somebody else";
  ProgramBinaries half(folder_, sum / 2);
  half.trim();
  std::uint64_t left = 0;
  bool gone = false;
  for (const fs::path& file : all) {
    if (fs::exists(file)) {
      EXPECT_FALSE(gone) << "an older file stayed";
      left += fs::file_size(file);
    } else {
      gone = true;
    }
  }
  EXPECT_LE(left, sum / 2);
  EXPECT_GT(left, 0U);
  EXPECT_TRUE(fs::exists(folder_ / "mine.txt"));
}

TEST_F(GlTest, ProgramsOfABatchAreLinkedTogether) {
  gl::ProgramCache programs(dataFolder("shaders"));
  std::vector<std::pair<std::size_t, std::size_t>> steps;
  programs.onProgress([&](std::size_t done, std::size_t total) { steps.push_back({done, total}); });
  std::vector<GLuint> ids;
  {
    gl::ProgramCache::Batch batch(programs);
    for (const char* file : {"oit/reserve.comp", "oit/extent.comp", "oit/reserve.comp"}) {
      ids.push_back(programs.get({{file}, {}, {}}));
    }
    EXPECT_TRUE(steps.empty());
    GLint linked = GL_TRUE;
    glGetProgramiv(ids[0], GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_FALSE);
    batch.finish();
  }
  EXPECT_EQ(ids[0], ids[2]);
  EXPECT_EQ(steps,
            (std::vector<std::pair<std::size_t, std::size_t>>{{1, 4}, {2, 4}, {3, 4}, {4, 4}}));
  for (const GLuint id : ids) {
    GLint linked = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE);
  }
}

TEST_F(GlTest, ABatchWithAFaultyShaderNamesItAndLeavesTheOthersUsable) {
  const fs::path folder = fs::temp_directory_path() /
                          ("macula_faulty_" + std::to_string(fs::hash_value(fs::current_path())));
  fs::create_directories(folder);
  const std::string head = "layout(local_size_x = 1) in;\n";
  std::ofstream(folder / "right.comp") << head << "void main() {}\n";
  std::ofstream(folder / "wrong.comp") << head << "void main() { return 1; }\n";
  gl::ProgramCache programs(folder);
  try {
    gl::ProgramCache::Batch batch(programs);
    (void)programs.get({{"right.comp"}, {}, {}});
    (void)programs.get({{"wrong.comp"}, {}, {}});
    batch.finish();
    ADD_FAILURE() << "linked";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("shader wrong.comp does not compile: "));
  }
  EXPECT_THROW((void)programs.get({{"wrong.comp"}, {}, {}}), std::runtime_error);
  const GLuint right = programs.get({{"right.comp"}, {}, {}});
  GLint linked = GL_FALSE;
  glGetProgramiv(right, GL_LINK_STATUS, &linked);
  EXPECT_EQ(linked, GL_TRUE);
  debugLog().clear();  // the compiler's own messages
  fs::remove_all(folder);
}

TEST_F(GlTest, ABatchThatIsGivenUpForgetsItsPrograms) {
  gl::ProgramCache programs(dataFolder("shaders"));
  const gl::ProgramKey key{{"oit/reserve.comp"}, {}, {}};
  {
    gl::ProgramCache::Batch batch(programs);
    (void)programs.get(key);
  }
  GLint linked = GL_FALSE;
  glGetProgramiv(programs.get(key), GL_LINK_STATUS, &linked);
  EXPECT_EQ(linked, GL_TRUE);
}

}  // namespace
}  // namespace macula::test
