#include "engine/core/output_folder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "temporary_path.h"

namespace macula {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFolderTest : public testing::Test {
 protected:
  OutputFolderTest() { fs::create_directories(out_); }
  ~OutputFolderTest() override { fs::remove_all(root_); }

  void make(const fs::path& name, const std::string& text = "kept") const {
    fs::create_directories((out_ / name).parent_path());
    std::ofstream(out_ / name) << text;
  }
  /// A run that writes these files.
  void run(const std::string& subcommand, const std::vector<std::string>& names,
           bool force = false) const {
    OutputFolder output(out_, subcommand, force);
    output.begin();
    for (const std::string& name : names) writeFileAtomically(output.file(name), subcommand);
  }
  std::string refusalOf(const std::string& subcommand) const {
    try {
      const OutputFolder output(out_, subcommand, false);
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(out_)) {
      found.insert(entry.path().filename().string());
    }
    found.erase(kOutputManifest);
    return found;
  }

  fs::path root_ = test::temporaryPath("output");
  fs::path out_ = root_ / "out";
};

using Names = std::set<std::string>;

TEST_F(OutputFolderTest, MissingAndEmptyFoldersAreTaken) {
  EXPECT_EQ(refusalOf("replay"), "taken");
  fs::remove(out_);
  EXPECT_EQ(refusalOf("replay"), "taken");
  EXPECT_TRUE(fs::is_empty(out_)) << "nothing changes before begin()";
}

TEST_F(OutputFolderTest, OwnOutputIsReplaced) {
  run("replay", {"frame_00000.png", "frame_00001.png", "report.json"});
  make("notes.txt");
  run("replay", {"frame_00000.png", "report.json"});
  EXPECT_EQ(names(), (Names{"frame_00000.png", "report.json", "notes.txt"}));
  run("replay", {"report.json"});
  EXPECT_EQ(names(), (Names{"report.json", "notes.txt"}));
}

TEST_F(OutputFolderTest, NothingGoesBeforeTheFirstFile) {
  run("replay", {"frame_00000.png", "report.json"});
  OutputFolder output(out_, "replay", false);
  EXPECT_EQ(names(), (Names{"frame_00000.png", "report.json"}));
  EXPECT_EQ(output.file("frame_00000.png"), out_ / "frame_00000.png");
  EXPECT_EQ(names(), Names{});
}

TEST_F(OutputFolderTest, WhatAKilledRunLeftIsOwn) {
  {
    OutputFolder output(out_, "replay", false);
    output.begin();
    writeFileAtomically(output.file("frame_00000.png"), "image");
    (void)output.file("frame_00001.png");  // and killed before it was written
  }
  run("replay", {"report.json"});
  EXPECT_EQ(names(), Names{"report.json"});
}

TEST_F(OutputFolderTest, OtherFilesAreRefusedByName) {
  make("b.txt");
  make("a.txt");
  EXPECT_EQ(refusalOf("replay"),
            out_.string() +
                ": holds 'a.txt' and 1 more, which is not from 'macula replay'; choose another "
                "folder with --out, or add --force to write into it");
  run("replay", {"report.json"}, true);
  EXPECT_EQ(names(), (Names{"a.txt", "b.txt", "report.json"}));
  EXPECT_EQ(refusalOf("replay"), "taken") << "from now on it holds an output";
  run("replay", {});
  EXPECT_EQ(names(), (Names{"a.txt", "b.txt"}));
}

TEST_F(OutputFolderTest, OutputOfAnotherSubcommandIsRefusedAndNeverRemoved) {
  run("chart", {"results.csv"});
  EXPECT_THAT(refusalOf("replay"), HasSubstr("holds the output of 'macula chart'"));
  run("replay", {"report.json"}, true);
  EXPECT_EQ(names(), (Names{"results.csv", "report.json"}));
  EXPECT_THAT(refusalOf("chart"), HasSubstr("holds the output of 'macula replay'"));
}

TEST_F(OutputFolderTest, NamesThatLeadElsewhereAreNotFollowed) {
  make("../outside");
  make("inner/file");
  make("goal");
  fs::create_symlink("goal", out_ / "link");
  fs::create_directories(out_ / "folder");
  make(kOutputManifest, "macula replay\n../outside\n" + (root_ / "outside").string() +
                            "\ninner/file\n..\n.\n\nfolder\nlink\n" + kOutputManifest);
  run("replay", {});
  EXPECT_TRUE(fs::exists(root_ / "outside"));
  EXPECT_TRUE(fs::exists(out_ / "inner" / "file"));
  EXPECT_EQ(names(), (Names{"folder", "goal", "inner"})) << "of a link, only the link goes";
}

TEST_F(OutputFolderTest, OutputOfVersionsWithoutAManifestIsTakenAndStays) {
  const std::map<std::string, std::pair<std::string, std::string>> earlier{
      {"replay", {"report.json", R"({"schema": 1, "frames": []})"}},
      {"hold", {"results.json", R"({"schema": 1, "law": "macula"})"}},
      {"gaze study", {"results.json", R"({"schema": 1, "logs": []})"}},
      {"chart", {"points.jsonl", ""}},
      {"features", {"training/smoke.npz", ""}}};
  for (const auto& [subcommand, report] : earlier) {
    fs::remove_all(out_);
    make(report.first, report.second);
    EXPECT_EQ(refusalOf(subcommand), "taken") << subcommand;
    const std::string other = subcommand == "replay" ? "chart" : "replay";
    EXPECT_THAT(refusalOf(other), HasSubstr("holds the output of 'macula " + subcommand + "'"));
    run(subcommand, {});
    EXPECT_TRUE(fs::exists(out_ / report.first)) << subcommand;
  }
  fs::remove_all(out_);
  make("report.json", R"({"frames": []})");
  EXPECT_THAT(refusalOf("replay"), HasSubstr("holds 'report.json'"));
}

}  // namespace
}  // namespace macula
