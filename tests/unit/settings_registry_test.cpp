// Registering settings, setting them from text and values, and their errors.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "engine/core/error.h"
#include "engine/settings/registry.h"

namespace macula::settings {
namespace {

enum class Curve : std::uint8_t { None, Filmic };

struct Fields {
  double kAve = 8.0;
  float exposure = 0.35F;
  int layers = 16;
  std::uint32_t seed = 1;
  std::uint64_t frames = 0;
  bool fill = false;
  std::string method = "kb-variable";
  int tail = 1;
  Curve tonemap = Curve::Filmic;
  int ssaa = 1;
  std::filesystem::path environment;
  glm::vec3 background{0.0F};
  std::array<float, 3> tint{1.0F, 1.0F, 1.0F};
};

class RegistryTest : public testing::Test {
 protected:
  void SetUp() override {
    registry_.add({.key = "oit.kAve",
                   .alias = "k-ave",
                   .unit = "fragments/pixel",
                   .help = "Average budget of a pixel"},
                  fields_.kAve, {.min = 0, .minExclusive = true, .max = 4096});
    registry_.add({.key = "exposure"}, fields_.exposure,
                  {.min = 0, .max = 1, .maxExclusive = true});
    registry_.add({.key = "oit.layers", .alias = "layers"}, fields_.layers,
                  {.min = 1, .max = 1024});
    registry_.add({.key = "seed"}, fields_.seed);
    registry_.add({.key = "frames"}, fields_.frames);
    registry_.add({.key = "oit.fill"}, fields_.fill);
    registry_.addChoice({.key = "oit.method", .alias = "method"}, fields_.method,
                        {"blend", "ab-sbuffer", "kb-variable"});
    registry_.addChoice({.key = "oit.tail"}, fields_.tail, {"none", "mean"});
    registry_.addChoice({.key = "tonemap"}, fields_.tonemap, {"none", "filmic"});
    registry_.addNumberChoice({.key = "ssaa"}, fields_.ssaa, {1, 2, 4});
    registry_.add({.key = "environment"}, fields_.environment);
    registry_.add({.key = "background"}, fields_.background, {.min = 0});
    registry_.add({.key = "tint", .group = "Colour"}, fields_.tint);
  }

  std::string messageOf(const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string messageOf(const char* name, const char* text) {
    return messageOf([&] { registry_.setText(name, text, "here"); });
  }

  Fields fields_;
  Registry registry_;
};

TEST_F(RegistryTest, SetsFieldsOfEveryType) {
  registry_.setText("k-ave", "2.5", "t");
  registry_.setText("exposure", "0.5", "t");
  registry_.setText("layers", "3", "t");
  registry_.setText("seed", "4294967295", "t");
  registry_.setText("frames", "9223372036854775807", "t");
  registry_.setText("oit.fill", "on", "t");
  registry_.setText("method", "blend", "t");
  registry_.setText("oit.tail", "none", "t");
  registry_.setText("tonemap", "none", "t");
  registry_.setText("ssaa", "4", "t");
  registry_.setText("environment", "a b.hdr", "t");
  registry_.setText("background", "0,0.5,1", "t");
  registry_.setText("tint", "1,2,-3", "t");
  EXPECT_EQ(fields_.kAve, 2.5);
  EXPECT_EQ(fields_.exposure, 0.5F);
  EXPECT_EQ(fields_.layers, 3);
  EXPECT_EQ(fields_.seed, 4294967295U);
  EXPECT_EQ(fields_.frames, 9223372036854775807U);
  EXPECT_TRUE(fields_.fill);
  EXPECT_EQ(fields_.method, "blend");
  EXPECT_EQ(fields_.tail, 0);
  EXPECT_EQ(fields_.tonemap, Curve::None);
  EXPECT_EQ(fields_.ssaa, 4);
  EXPECT_EQ(fields_.environment, "a b.hdr");
  EXPECT_EQ(fields_.background, glm::vec3(0.0F, 0.5F, 1.0F));
  EXPECT_EQ(fields_.tint, (std::array<float, 3>{1.0F, 2.0F, -3.0F}));
}

TEST_F(RegistryTest, RefusedValueLeavesTheFieldAndNamesAll) {
  EXPECT_EQ(messageOf("k-ave", "-1"),
            "here: '-1' is out of range; oit.kAve takes a number > 0 and <= 4096 "
            "(fragments/pixel)");
  EXPECT_EQ(messageOf("k-ave", "abc"),
            "here: 'abc' is not a finite number; oit.kAve takes a number > 0 and <= 4096 "
            "(fragments/pixel)");
  EXPECT_EQ(messageOf("layers", "1.5"),
            "here: '1.5' is not a whole number; oit.layers takes a whole number from 1 to 1024");
  EXPECT_EQ(messageOf("method", "kb-varable"),
            "here: 'kb-varable' is not known (nearest: 'kb-variable'); oit.method takes one of "
            "blend, ab-sbuffer, kb-variable");
  EXPECT_EQ(messageOf("ssaa", "3"), "here: '3' is out of range; ssaa takes one of 1, 2, 4");
  EXPECT_EQ(messageOf("oit.fill", "maybe"),
            "here: 'maybe' is neither on nor off; oit.fill takes true or false, \"on\" or \"off\", "
            "1 or 0");
  EXPECT_EQ(messageOf("background", "0,0"),
            "here: '0,0' is not three finite numbers; background takes R,G,B, each >= 0");
  EXPECT_EQ(fields_.kAve, 8.0);
  EXPECT_EQ(fields_.layers, 16);
  EXPECT_EQ(fields_.method, "kb-variable");
  EXPECT_EQ(fields_.ssaa, 1);
}

TEST_F(RegistryTest, BoundsAreChecked) {
  for (const char* bad : {"0", "-0", "4096.5", "nan", "inf", "1e999", ""}) {
    EXPECT_NE(messageOf("k-ave", bad), "no error") << bad;
  }
  EXPECT_EQ(messageOf("k-ave", "4096"), "no error");
  for (const char* bad : {"-1", "4294967296"}) EXPECT_NE(messageOf("seed", bad), "no error") << bad;
  EXPECT_NE(messageOf("frames", "-1"), "no error");
  EXPECT_NE(messageOf("background", "0,-1,0"), "no error");
}

TEST_F(RegistryTest, RoundingToFloatDoesNotCrossAnExclusiveBound) {
  EXPECT_NE(messageOf("exposure", "0.99999999999"), "no error");  // would be 1.0F
  EXPECT_NE(messageOf("exposure", "1e300"), "no error");
  EXPECT_EQ(fields_.exposure, 0.35F);
}

TEST_F(RegistryTest, UnknownNameSaysTheNearest) {
  EXPECT_EQ(messageOf("oit.kAvg", "1"),
            "here: unknown setting 'oit.kAvg'; the nearest is 'oit.kAve'");
  EXPECT_EQ(messageOf("metod", "1"), "here: unknown setting 'metod'; the nearest is 'method'");
  EXPECT_LT(messageOf(std::string(100000, 'x').c_str(), "1").size(), 200U);
}

TEST_F(RegistryTest, Assignment) {
  registry_.setAssignment("oit.kAve=4", "--set");
  EXPECT_EQ(fields_.kAve, 4.0);
  registry_.setAssignment("environment=a=b", "--set");
  EXPECT_EQ(fields_.environment, "a=b");
  EXPECT_EQ(messageOf([&] { registry_.setAssignment("oit.kAve=-1", "--set"); }),
            "--set oit.kAve: '-1' is out of range; oit.kAve takes a number > 0 and <= 4096 "
            "(fragments/pixel)");
  EXPECT_EQ(messageOf([&] { registry_.setAssignment("oit.kAve", "--set"); }),
            "--set: 'oit.kAve' has no '='; write it as key=value");
  EXPECT_NE(messageOf([&] { registry_.setAssignment("=1", "--set"); }), "no error");
}

TEST_F(RegistryTest, EntriesTellWhatAPanelNeeds) {
  const Entry& kAve = registry_.at("k-ave", "t");
  EXPECT_EQ(kAve.type(), Type::Real);
  EXPECT_EQ(kAve.group(), "oit");
  EXPECT_EQ(kAve.unit(), "fragments/pixel");
  EXPECT_EQ(kAve.option(), "--k-ave");
  EXPECT_EQ(kAve.range().max, 4096.0);
  EXPECT_EQ(kAve.defaultValue(), Value{8.0});
  EXPECT_TRUE(kAve.isDefault());
  EXPECT_EQ(registry_.find("tint")->group(), "Colour");
  EXPECT_EQ(registry_.find("tint")->option(), "--tint");
  EXPECT_EQ(registry_.find("ssaa")->choices(), (std::vector<std::string>{"1", "2", "4"}));
  EXPECT_EQ(registry_.find("tonemap")->get(), Value{std::string("filmic")});
  EXPECT_EQ(registry_.find(""), nullptr);
  EXPECT_EQ(registry_.entries().size(), 13U);
}

TEST_F(RegistryTest, SetsFromValues) {
  Entry& kAve = registry_.at("k-ave", "t");
  kAve.set(std::int64_t{4});
  EXPECT_EQ(fields_.kAve, 4.0);
  EXPECT_FALSE(kAve.isDefault());
  EXPECT_THROW(kAve.set(std::string("4")), InputError);
  EXPECT_THROW(kAve.set(true), InputError);
  EXPECT_THROW(registry_.at("layers", "t").set(2.0), InputError);
  const glm::vec3 infinite(std::numeric_limits<float>::infinity(), 0.0F, 0.0F);
  EXPECT_THROW(registry_.at("background", "t").set(infinite), InputError);
  registry_.reset();
  EXPECT_EQ(fields_.kAve, 8.0);
}

TEST_F(RegistryTest, BooleansAreTakenAsFilesWriteThem) {
  Entry& fill = registry_.at("oit.fill", "t");
  for (const Value& on : {Value{true}, Value{std::string("on")}, Value{std::string("true")},
                          Value{std::string("1")}, Value{std::int64_t{1}}}) {
    fill.set(false);
    fill.set(on);
    EXPECT_EQ(fill.get(), Value{true}) << formatValue(on);
  }
  for (const Value& off : {Value{false}, Value{std::string("off")}, Value{std::string("false")},
                           Value{std::string("0")}, Value{std::int64_t{0}}}) {
    fill.set(true);
    fill.set(off);
    EXPECT_EQ(fill.get(), Value{false}) << formatValue(off);
  }
  for (const Value& bad : {Value{std::int64_t{2}}, Value{std::int64_t{-1}}, Value{1.0},
                           Value{std::string("yes")}, Value{std::string("")}}) {
    EXPECT_THROW(fill.set(bad), InputError) << formatValue(bad);
  }
}

TEST_F(RegistryTest, APercentageIsRefusedWithTheShareToWrite) {
  double part = 0.5;
  registry_.add({.key = "part", .share = true}, part, {.min = 0, .minExclusive = true, .max = 1});
  EXPECT_EQ(messageOf("part", "90"),
            "here: '90' is out of range; part takes a number > 0 and <= 1; write 0.9 for 90 %");
  EXPECT_EQ(messageOf("part", "12.5 %"),
            "here: '12.5 %' is not a finite number; part takes a number > 0 and <= 1; write 0.125 "
            "for 12.5 %");
  EXPECT_EQ(messageOf("part", "0.5%").substr(0, 13), "here: '0.5%' ");
  EXPECT_NE(messageOf("part", "0.5%").find("write 0.005 for 0.5 %"), std::string::npos);
  // Neither a percentage nor a share, or rather a share that is too large.
  for (const char* bad : {"101", "-3", "0", "0%", "1.5", "%", "x%", "nan"}) {
    EXPECT_EQ(messageOf("part", bad).find("write"), std::string::npos) << bad;
  }
  // No share.
  EXPECT_EQ(messageOf("ssaa", "50").find("write"), std::string::npos);
  EXPECT_EQ(part, 0.5);
}

class RivalsTest : public testing::Test {
 protected:
  void SetUp() override {
    registry_.add({.key = "oit.kAve", .alias = "k-ave", .unit = "fragments/sample"}, average_);
    registry_.add({.key = "oit.memoryMiB", .alias = "oit-memory", .unit = "MiB"}, memory_);
    registry_.addRivals("oit.kAve", "oit.memoryMiB");
  }

  std::string check() {
    try {
      registry_.checkRivals();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  double average_ = 4.0;
  double memory_ = 0.0;
  Registry registry_;
};

TEST_F(RivalsTest, OnlyBothTogetherAreRefused) {
  EXPECT_EQ(check(), "no error");
  registry_.setText("oit.memoryMiB", "8", "--oit-memory");
  EXPECT_EQ(check(), "no error") << "the other holds its default";
  registry_.setText("oit.kAve", "4", "x.toml:3: oit.kAve");
  EXPECT_EQ(check(),
            "x.toml:3: oit.kAve and --oit-memory cannot hold together; drop oit.kAve to keep 8 "
            "MiB, or --oit-memory to keep 4 fragments/sample");
  registry_.setText("oit.memoryMiB", "0", "--oit-memory");
  EXPECT_EQ(check(), "no error") << "0 means by the other";
  registry_.reset();
  registry_.setText("oit.memoryMiB", "8", "--oit-memory");
  EXPECT_EQ(check(), "no error") << "what was reset is no longer given";
  EXPECT_THROW(registry_.addRivals("oit.kAve", "nothing"), std::logic_error);
}

TEST_F(RivalsTest, TheHiddenOneIsFound) {
  Entry& average = registry_.at("k-ave", "t");
  Entry& memory = registry_.at("oit-memory", "t");
  EXPECT_EQ(registry_.rivalOf(average), nullptr);
  memory.set(8.0);
  EXPECT_EQ(registry_.rivalOf(average), &memory);
  EXPECT_EQ(registry_.rivalOf(memory), nullptr) << "the average is its default";
  average.set(2.0);
  EXPECT_EQ(registry_.rivalOf(memory), &average);
  memory.set(0.0);
  EXPECT_EQ(registry_.rivalOf(memory), nullptr);
  EXPECT_EQ(registry_.rivalOf(average), nullptr);
}

TEST_F(RegistryTest, JsonIsFlatAndTyped) {
  const nlohmann::json json = registry_.toJson();
  EXPECT_EQ(json.size(), 13U);
  EXPECT_EQ(json["oit.kAve"], 8.0);
  EXPECT_EQ(json["exposure"].dump(), "0.35");
  EXPECT_EQ(json["oit.layers"], 16);
  EXPECT_EQ(json["oit.fill"], false);
  EXPECT_EQ(json["oit.tail"], "mean");
  EXPECT_EQ(json["ssaa"], 1);
  EXPECT_EQ(json["background"].dump(), "[0.0,0.0,0.0]");
}

TEST_F(RegistryTest, WrongRegistrationIsALogicError) {
  int extra = 5;
  EXPECT_THROW(registry_.add({.key = "seed"}, extra), std::logic_error);
  EXPECT_THROW(registry_.add({.key = "other", .alias = "k-ave"}, extra), std::logic_error);
  EXPECT_THROW(registry_.add({.key = ""}, extra), std::logic_error);
  EXPECT_THROW(registry_.add({.key = "a=b"}, extra), std::logic_error);
  EXPECT_THROW(registry_.add({.key = "a."}, extra), std::logic_error);
  EXPECT_THROW(registry_.add({.key = "small"}, extra, {.max = 4}), std::logic_error);
  EXPECT_THROW(registry_.addChoice({.key = "index"}, extra, {"a", "b"}), std::logic_error);
  EXPECT_THROW(registry_.addNumberChoice({.key = "number"}, extra, {1, 2}), std::logic_error);
}

TEST(RegistryEffect, IsTheSettingsOwnOrThatOfItsGroup) {
  Registry registry;
  int a = 0;
  int b = 0;
  int c = 0;
  int d = 0;
  registry.add({.key = "gaze.before"}, a);
  registry.setGroupEffect("gaze", Effect::ReopensGaze);
  registry.add({.key = "gaze.after"}, b);
  registry.add({.key = "gaze.own", .effect = Effect::Immediate}, c);
  registry.add({.key = "other", .group = "gaze"}, d);
  EXPECT_EQ(registry.find("gaze.before")->effect(), Effect::DropsHistory);
  EXPECT_EQ(registry.find("gaze.after")->effect(), Effect::ReopensGaze);
  EXPECT_EQ(registry.find("gaze.own")->effect(), Effect::Immediate);
  EXPECT_EQ(registry.find("other")->effect(), Effect::ReopensGaze);
}

}  // namespace
}  // namespace macula::settings
