// The one reader of tables: the same rules and words for TOML and for JSON.
#include "engine/settings/typed_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/settings/toml_file.h"

namespace macula::settings {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <typename Function>
std::string messageOf(Function&& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The same document twice.
class TypedReaderTest : public testing::TestWithParam<bool> {
 protected:
  TypedReader reader() {
    return isToml() ? TypedReader(DataNode(toml_), "x") : TypedReader(DataNode(json_), "x");
  }
  static bool isToml() { return GetParam(); }
  /// Where a line of the TOML document is, as messages begin.
  static std::string line(int number) {
    return isToml() ? "x:" + std::to_string(number) + ": " : "x: ";
  }

  const toml::table toml_ = parseToml(R"(name = "n"
flag = "on"
count = 3
share = 30
list = ["a", "b"]
inner = { width = 2.5, colour = [0, 0.5, 1] }
rows = [{ id = "one" }, { id = "two", extra = 1 }]
)",
                                      "x");
  const nlohmann::json json_ = nlohmann::json::parse(
      R"({"name": "n", "flag": "on", "count": 3, "share": 30, "list": ["a", "b"],
          "inner": {"width": 2.5, "colour": [0, 0.5, 1]},
          "rows": [{"id": "one"}, {"id": "two", "extra": 1}]})");
};

TEST_P(TypedReaderTest, ReadsEveryType) {
  TypedReader r = reader();
  EXPECT_EQ(r.get<std::string>("name"), "n");
  EXPECT_TRUE(r.get<bool>("flag"));
  EXPECT_EQ(r.get<int>("count", {.min = 1, .max = 3}), 3);
  EXPECT_EQ(r.get<double>("count"), 3.0);
  EXPECT_EQ(r.get<float>("share"), 30.0F);
  EXPECT_THAT(r.get<std::vector<std::string>>("list"), ElementsAre("a", "b"));
  EXPECT_THAT(r.getTexts("name"), ElementsAre("n"));
  EXPECT_EQ(r.get<Value>("count"), Value(std::int64_t{3}));
  TypedReader inner = r.getTable("inner");
  EXPECT_EQ(inner.get<double>("width"), 2.5);
  EXPECT_EQ(inner.get<glm::vec3>("colour"), glm::vec3(0.0F, 0.5F, 1.0F));
  inner.finish();
  auto rows = r.tables("rows");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].getChoice("id", {"one", "two"}), 0U);
  rows[0].finish();
  r.finish();
}

TEST_P(TypedReaderTest, WhatIsMissingIsLeftAloneOrNamed) {
  TypedReader r = reader();
  int kept = 7;
  r.take("other", kept);
  EXPECT_EQ(kept, 7);
  EXPECT_FALSE(r.find<int>("other"));
  EXPECT_TRUE(r.table("none").keys().empty());
  EXPECT_TRUE(r.tables("none").empty());
  EXPECT_EQ(messageOf([&] { (void)r.get<int>("other"); }), line(1) + "'other' is missing; add it");
  TypedReader none = r.table("none");
  EXPECT_THAT(messageOf([&] { (void)none.get<int>("x"); }), HasSubstr("'none.x' is missing"));
  TypedReader inner = r.getTable("inner");
  EXPECT_THAT(messageOf([&] { (void)inner.get<int>("height"); }),
              HasSubstr("'inner.height' is missing"));
}

TEST_P(TypedReaderTest, AWrongValueIsShownWithWhatToGive) {
  TypedReader r = reader();
  EXPECT_EQ(messageOf([&] { (void)r.get<int>("count", {.min = 4, .max = 9}, "mm"); }),
            line(3) + "'count' is 3; give a whole number from 4 to 9 (mm)");
  EXPECT_EQ(messageOf([&] { (void)r.get<double>("share", {.min = 0, .max = 1}); }),
            line(4) + "'share' is 30; give a finite number from 0 to 1; write 0.3 for 30 %");
  EXPECT_EQ(messageOf([&] { (void)r.get<int>("name"); }).substr(0, line(1).size() + 22),
            line(1) + "'name' is 'n'; give a ");
  EXPECT_EQ(messageOf([&] { (void)r.get<std::string>("list"); }),
            line(5) + "'list' is a list; give a text in quotes");
  EXPECT_EQ(messageOf([&] { (void)r.getTable("count"); }), line(3) + "'count' is 3; give a table");
  EXPECT_EQ(messageOf([&] {
              (void)r.getChoice("name", {"no", "yes"});
            }),
            line(1) + "'name' is 'n'; give one of no, yes (nearest: 'no')");
  EXPECT_THAT(messageOf([&] { (void)r.get<std::vector<std::int64_t>>("list"); }),
              HasSubstr("'list' is 'a'; give a whole number"));
}

TEST_P(TypedReaderTest, AnUnknownKeyIsRefusedWithItsNearest) {
  TypedReader r = reader();
  for (const char* key : {"name", "flag", "count", "share", "list", "inner"}) (void)r.has(key);
  (void)r.has("rowz");
  EXPECT_EQ(messageOf([&] { r.finish(); }), line(7) + "'rows' is not known; the nearest is 'rowz'");
  auto rows = r.tables("rows");
  (void)rows[1].get<std::string>("id");
  EXPECT_EQ(messageOf([&] { rows[1].finish(); }),
            line(7) + "'extra' is not known; the nearest is 'id'");
}

INSTANTIATE_TEST_SUITE_P(TomlAndJson, TypedReaderTest, testing::Bool(),
                         [](const auto& kind) { return kind.param ? "Toml" : "Json"; });

TEST(TypedReader, JsonHasNumbersThatAreNotFiniteAsTexts) {
  const nlohmann::json json{{"a", "nan"}, {"b", "-inf"}, {"c", 1e300}, {"d", nullptr}, {"e", ""}};
  TypedReader r(DataNode(json), "f.jsonl: line 2", "restore it");
  EXPECT_TRUE(std::isnan(r.anyNumber("a")));
  EXPECT_EQ(r.anyFloat("b"), -HUGE_VALF);
  EXPECT_EQ(messageOf([&] { (void)r.anyFloat("c"); }),
            "f.jsonl: line 2: 'c' is too large for a number of 32 bits");
  EXPECT_EQ(messageOf([&] { (void)r.get<double>("a"); }),
            "f.jsonl: line 2: 'a' is 'nan'; give a finite number");
  EXPECT_EQ(r.textOrNull("d"), "");
  EXPECT_EQ(r.textOrNull("e"), "");
  EXPECT_EQ(messageOf([&] { (void)r.get<std::string>("e"); }),
            "f.jsonl: line 2: 'e' is ''; give a text in quotes");
  EXPECT_EQ(messageOf([&] { (void)r.get<int>("z"); }),
            "f.jsonl: line 2: 'z' is missing; restore it");
  EXPECT_THAT(messageOf([] { (void)parseJsonObject("[1]", "f", "restore it"); }),
              HasSubstr("f: is no JSON object; restore it"));
}

}  // namespace
}  // namespace macula::settings
