// Errors, names, hashes and files of engine/core.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/nearest.h"
#include "engine/core/plural.h"
#include "engine/core/sha256.h"
#include "engine/core/shell.h"

namespace macula {
namespace {

namespace fs = std::filesystem;

/// An empty folder of this test's own.
class FileTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("macula_core_test_" + std::to_string(::getpid()));
};

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string sha256Of(const std::string& text) {
  return sha256Hex(std::as_bytes(std::span(text.data(), text.size())));
}

TEST(OneLine, ReplacesBreaksAndControlCharacters) {
  EXPECT_EQ(oneLine("a\nb\tc\x1B[0m\x7F"), "a b c [0m");
  EXPECT_EQ(oneLine("trailing \r\n"), "trailing");
  EXPECT_EQ(oneLine("caf\xC3\xA9"), "caf\xC3\xA9");
}

TEST(InputErrorTest, MessageIsOneLine) {
  EXPECT_EQ(messageOf([] { failInput("{}: bad\nvalue {}", "file", 3); }), "file: bad value 3");
}

TEST(NearestName, FindsLeastEditDistance) {
  const std::vector<std::string> names = {"oit.kAve", "oit.method", "lod.r"};
  EXPECT_EQ(nearestName("oit.kave", names), "oit.kAve");
  EXPECT_EQ(nearestName("oit.metod", names), "oit.method");
  EXPECT_EQ(nearestName("r", names), "lod.r");
}

TEST(NearestName, WhatBeginsWithTheNameGoesBeforeWhatIsShort) {
  const std::vector<std::string> names = {"off", "yang2008", "yang2008b"};
  EXPECT_EQ(nearestName("yang", names), "yang2008");
  EXPECT_EQ(nearestName("YANG2", names), "yang2008");
  EXPECT_EQ(nearestName("of", names), "off");
}

TEST(Plural, TheNounFollowsTheNumber) {
  EXPECT_EQ(counted(0, "frame"), "0 frames");
  EXPECT_EQ(counted(1, "frame"), "1 frame");
  EXPECT_EQ(counted(2, "frame"), "2 frames");
  EXPECT_EQ(counted(1, "image hash", "image hashes"), "1 image hash");
  EXPECT_EQ(counted(3, "image hash", "image hashes"), "3 image hashes");
  EXPECT_EQ(nounFor(1, "is", "are"), "is");
}

TEST(Shell, WordsAreReadBackAsTheyWere) {
  EXPECT_EQ(shellCommand({"macula", "replay", "a b.glb", "--set", "k=1", ""}),
            "macula replay 'a b.glb' --set k=1 ''");
  EXPECT_EQ(shellQuoted("it's"), "'it'\\''s'");
}

TEST(NearestName, TakesFirstOfEqualsAndNothingOfNone) {
  const std::vector<std::string> names = {"ab", "ac"};
  EXPECT_EQ(nearestName("a", names), "ab");
  EXPECT_EQ(nearestName("a", std::vector<std::string>{}), "");
}

// The examples of FIPS 180-4's companion document: one block, no byte, two blocks.
TEST(Sha256, MatchesPublishedExamples) {
  EXPECT_EQ(sha256Of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_F(FileTest, WritesAndReadsBytesBack) {
  const std::string bytes("a\0\r\n\xFF", 5);
  writeFileAtomically(folder_ / "x.bin", bytes);
  EXPECT_EQ(readTextFile(folder_ / "x.bin"), bytes);
  writeFileAtomically(folder_ / "x.bin", "shorter");
  EXPECT_EQ(readTextFile(folder_ / "x.bin"), "shorter");
  EXPECT_EQ(names(), std::vector<std::string>{"x.bin"});
}

TEST_F(FileTest, FailedWriteLeavesTheOldFileAlone) {
  writeFileAtomically(folder_ / "x.png", "old");
  const auto failing = [](const fs::path& temporary) {
    EXPECT_EQ(temporary.extension(), ".png");
    std::ofstream(temporary) << "half";
    throw std::runtime_error("disk full");
  };
  EXPECT_THROW(writeFileAtomically(folder_ / "x.png", failing), std::runtime_error);
  EXPECT_EQ(readTextFile(folder_ / "x.png"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"x.png"});
}

TEST_F(FileTest, ErrorsNameThePath) {
  const std::string missing = (folder_ / "missing.txt").string();
  EXPECT_EQ(messageOf([&] { (void)readTextFile(missing); }),
            missing + ": no such file; check the path");
  EXPECT_EQ(messageOf([&] { (void)readTextFile(folder_); }),
            folder_.string() + ": is a folder; name a file in it");
  const std::string nowhere = (folder_ / "no" / "x.txt").string();
  EXPECT_NE(messageOf([&] { writeFileAtomically(nowhere, "x"); }).find(nowhere), std::string::npos);
}

TEST_F(FileTest, OutputFolderIsMadeAndEmpty) {
  makeOutputFolder(folder_ / "a" / "b");
  EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b"));
  makeOutputFolder(folder_ / "a" / "b");  // a second time is no error
}

TEST_F(FileTest, OutputFolderOverAFileIsRefused) {
  writeFileAtomically(folder_ / "file", "x");
  const std::string below = (folder_ / "file" / "out").string();
  EXPECT_NE(messageOf([&] { makeOutputFolder(below); }).find(below + ": the output folder"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { makeOutputFolder(folder_ / "file"); }).find("the output folder"),
            std::string::npos);
}

TEST(DataFolder, MissingOneIsNamed) {
  EXPECT_NE(messageOf([] { (void)dataFolder("no-such-folder"); }).find("'no-such-folder'"),
            std::string::npos);
}

TEST(ModuleFile, MissingOneIsNamedWithItsMend) {
  const std::string message = messageOf([] { (void)moduleFile("no-such-module.so"); });
  EXPECT_NE(message.find("lib/macula/no-such-module.so: "), std::string::npos) << message;
  EXPECT_NE(message.find("MACULA_MODULES"), std::string::npos) << message;
}

/// $MACULA_MODULES is a folder of the test's own, and again what it was afterwards.
class ChosenModuleTest : public FileTest {
 protected:
  ChosenModuleTest() {
    if (const char* before = std::getenv(kVariable)) before_ = before;
    ::setenv(kVariable, folder_.c_str(), 1);
  }
  ~ChosenModuleTest() override {
    if (before_) {
      ::setenv(kVariable, before_->c_str(), 1);
    } else {
      ::unsetenv(kVariable);
    }
  }

 private:
  static constexpr const char* kVariable = "MACULA_MODULES";
  std::optional<std::string> before_;
};

TEST_F(ChosenModuleTest, ChosenFolderIsTheOnlyOne) {
  const std::string message = messageOf([] { (void)moduleFile("unit_tests"); });  // beside this one
  EXPECT_EQ(message.rfind((folder_ / "unit_tests").string() + ": ", 0), 0U) << message;
  writeFileAtomically(folder_ / "unit_tests", "x");
  EXPECT_EQ(moduleFile("unit_tests"), folder_ / "unit_tests");
}

}  // namespace
}  // namespace macula
