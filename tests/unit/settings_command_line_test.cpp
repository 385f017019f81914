// The registry on a CLI11 command line, beside a subcommand's own options.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/settings/command_line.h"
#include "temporary_path.h"

namespace macula::settings {
namespace {

class CommandLineTest : public testing::Test {
 protected:
  void SetUp() override {
    registry_.add({.key = "oit.kAve",
                   .alias = "k-ave",
                   .unit = "fragments/pixel",
                   .help = "Average budget of a pixel",
                   .group = "Transparency"},
                  kAve_, {.min = 0, .minExclusive = true, .max = 4096});
    registry_.add({.key = "oit.fill", .help = "Hand surplus on"}, fill_);
    registry_.addChoice({.key = "oit.method", .alias = "method", .help = "Method"}, method_,
                        {"blend", "ab-sbuffer", "kb-variable"});
    registry_.add({.key = "background", .help = "Linear background"}, background_);
    app_.require_subcommand(1);
    replay_ = app_.add_subcommand("replay", "Replay");
    replay_->add_option("scene", scene_, "Scene")->required();
    replay_->add_option("--frames", frames_, "Frames");
    replay_->add_option("--gaze", gaze_, "Gaze");
    addOptions(*replay_, registry_);
    replay_->callback([this] { applyOptions(*replay_, registry_); });
    app_.add_subcommand("compare", "Compare");
  }

  void run(const std::vector<std::string>& arguments) {
    EXPECT_TRUE(parseCommandLine(app_, arguments));
  }
  std::string messageOf(const std::vector<std::string>& arguments) {
    try {
      parseCommandLine(app_, arguments);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  double kAve_ = 8.0;
  bool fill_ = false;
  std::string method_ = "kb-variable";
  glm::vec3 background_{0.0F};
  Registry registry_;
  CLI::App app_{"Macula", "macula"};
  CLI::App* replay_ = nullptr;
  std::string scene_;
  std::string gaze_;
  int frames_ = 1;
};

TEST_F(CommandLineTest, AliasAndKeyBothSet) {
  run({"replay", "layers-64", "--k-ave", "4", "--frames", "3", "--oit.fill", "on"});
  EXPECT_EQ(kAve_, 4.0);
  EXPECT_TRUE(fill_);
  EXPECT_EQ(scene_, "layers-64");
  EXPECT_EQ(frames_, 3);
  run({"replay", "--oit.kAve=2.5", "--method=blend", "layers-64", "--background", "0,0.5,1"});
  EXPECT_EQ(kAve_, 2.5);
  EXPECT_EQ(method_, "blend");
  EXPECT_EQ(background_, glm::vec3(0.0F, 0.5F, 1.0F));
}

TEST_F(CommandLineTest, NegativeNumbersReachTheRangeCheck) {
  const std::string wanted =
      "--k-ave: '-1' is out of range; oit.kAve takes a number > 0 and <= 4096 (fragments/pixel)";
  EXPECT_EQ(messageOf({"replay", "s", "--k-ave", "-1"}), wanted);
  EXPECT_EQ(messageOf({"replay", "s", "--k-ave=-1"}), wanted);
  EXPECT_EQ(messageOf({"replay", "s", "--oit.kAve", "-1"}), wanted);
  EXPECT_EQ(messageOf({"replay", "s", "--k-ave", "-.5"}).substr(0, 14), "--k-ave: '-.5'");
  run({"replay", "s", "--background", "-1,0,0", "--gaze", "-0.5,0.5"});
  EXPECT_EQ(background_.r, -1.0F);
  EXPECT_EQ(gaze_, "-0.5,0.5");
}

TEST_F(CommandLineTest, LastOneOnTheLineWins) {
  run({"replay", "s", "--k-ave", "4", "--oit.kAve", "5"});
  EXPECT_EQ(kAve_, 5.0);
  run({"replay", "s", "--set", "oit.kAve=6", "--k-ave", "7", "--set", "method=blend"});
  EXPECT_EQ(kAve_, 7.0);
  EXPECT_EQ(method_, "blend");
  run({"replay", "s", "--k-ave", "7", "--set", "k-ave=6", "--set", "oit.kAve=9"});
  EXPECT_EQ(kAve_, 9.0);
}

TEST_F(CommandLineTest, TomlComesBeforeTheLine) {
  const std::string path = macula::test::temporaryPath("command_line.toml");
  writeFileAtomically(path, "[oit]\nkAve = 3\nmethod = 'blend'\n");
  run({"replay", "s", "--k-ave", "4", "--config", path});
  EXPECT_EQ(kAve_, 4.0);
  EXPECT_EQ(method_, "blend");
  EXPECT_EQ(messageOf({"replay", "s", "--config", path + "x"}),
            path + "x: no such file; check the path");
  std::filesystem::remove(path);
}

TEST_F(CommandLineTest, UnknownOptionNamesTheNearestOfAll) {
  EXPECT_EQ(messageOf({"replay", "s", "--k-avg", "4"}),
            "unknown option '--k-avg'; the nearest is '--k-ave'; see macula replay --help");
  EXPECT_EQ(
      messageOf({"replay", "s", "--oit.metod=4"}),
      "unknown option '--oit.metod'; the nearest is '--oit.method'; see macula replay --help");
  EXPECT_EQ(messageOf({"replay", "s", "--frame", "4"}),
            "unknown option '--frame'; the nearest is '--frames'; see macula replay --help");
  EXPECT_EQ(messageOf({"replay", "--frame", "4"}),
            "unknown option '--frame'; the nearest is '--frames'; see macula replay --help");
  EXPECT_EQ(messageOf({"--hepl"}),
            "unknown option '--hepl'; the nearest is '--help'; see macula --help");
  EXPECT_NE(messageOf({"replay", "s", "-x"}).find("unknown option '-x'"), std::string::npos);
  EXPECT_LT(messageOf({"replay", "s", "--" + std::string(100000, 'x')}).size(), 250U);
}

TEST_F(CommandLineTest, OtherMistakesAreOneLineToo) {
  EXPECT_EQ(messageOf({"repaly", "s"}),
            "unknown subcommand 'repaly'; the nearest is 'replay'; see macula --help");
  EXPECT_EQ(messageOf({"replay", "s", "extra"}),
            "unexpected argument 'extra'; see macula replay --help");
  EXPECT_EQ(messageOf({"replay", "s", "--set", "oit.kAvg=4"}),
            "--set oit.kAvg: unknown setting 'oit.kAvg'; the nearest is 'oit.kAve'");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"replay"},
                                                    {"replay", "s", "--k-ave"},
                                                    {"replay", "s", "--set"},
                                                    {"replay", "s", "--frames", "x"},
                                                    {"replay", "s", "--k-ave", ""}}) {
    const std::string message = messageOf(arguments);
    EXPECT_NE(message, "no error");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(kAve_, 8.0);
}

TEST_F(CommandLineTest, HelpShowsUnitRangeDefaultAndGroup) {
  const std::string help = replay_->help();
  EXPECT_NE(help.find("Transparency:"), std::string::npos) << help;
  EXPECT_NE(help.find("--k-ave,--oit.kAve NUMBER"), std::string::npos) << help;
  EXPECT_NE(help.find("Average budget of a pixel (fragments/pixel; > 0 and <= 4096; default 8)"),
            std::string::npos)
      << help;
  EXPECT_NE(help.find("one of blend, ab-sbuffer, kb-variable; default kb-variable"),
            std::string::npos)
      << help;
  EXPECT_NE(help.find("--config FILE.toml"), std::string::npos) << help;
}

TEST_F(CommandLineTest, HelpIsNoError) {
  testing::internal::CaptureStdout();
  EXPECT_FALSE(parseCommandLine(app_, std::vector<std::string>{"replay", "--help"}));
  EXPECT_NE(testing::internal::GetCapturedStdout().find("--k-ave"), std::string::npos);
}

TEST_F(CommandLineTest, ArgvLeavesOutTheProgramName) {
  const char* const argv[] = {"macula", "replay", "s", "--k-ave", "3"};
  EXPECT_TRUE(parseCommandLine(app_, 5, argv));
  EXPECT_EQ(kAve_, 3.0);
}

}  // namespace
}  // namespace macula::settings
