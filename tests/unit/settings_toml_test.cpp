// Settings from TOML text and files.
#include <gtest/gtest.h>

#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/settings/toml_file.h"
#include "temporary_path.h"

namespace macula::settings {
namespace {

class TomlTest : public testing::Test {
 protected:
  void SetUp() override {
    registry_.add({.key = "oit.kAve", .alias = "k-ave"}, kAve_,
                  {.min = 0, .minExclusive = true, .max = 4096});
    registry_.add({.key = "oit.layers"}, layers_, {.min = 1, .max = 1024});
    registry_.add({.key = "oit.fill"}, fill_);
    registry_.addChoice({.key = "oit.method", .alias = "method"}, method_, {"blend", "peel"});
    registry_.addNumberChoice({.key = "ssaa"}, ssaa_, {1, 2, 4});
    registry_.add({.key = "background"}, background_, {.min = 0});
  }

  std::string messageOf(const std::string& text) {
    try {
      applyTomlText(registry_, text, "x.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  double kAve_ = 8.0;
  int layers_ = 16;
  bool fill_ = false;
  std::string method_ = "blend";
  int ssaa_ = 1;
  glm::vec3 background_{0.0F};
  Registry registry_;
};

TEST_F(TomlTest, TableDottedKeyAndAliasMeanTheSame) {
  applyTomlText(registry_, "[oit]\nkAve = 4\nlayers = 8\nfill = true\nmethod = \"peel\"\n", "x");
  EXPECT_EQ(kAve_, 4.0);
  EXPECT_EQ(layers_, 8);
  EXPECT_TRUE(fill_);
  EXPECT_EQ(method_, "peel");
  applyTomlText(registry_, "oit.kAve = 2.5\nssaa = 2\n", "x");
  EXPECT_EQ(kAve_, 2.5);
  EXPECT_EQ(ssaa_, 2);
  applyTomlText(registry_, "k-ave = 3\nmethod = 'blend'\n", "x");
  EXPECT_EQ(kAve_, 3.0);
  EXPECT_EQ(method_, "blend");
  applyTomlText(registry_, "oit = { kAve = 7 }", "x");
  EXPECT_EQ(kAve_, 7.0);
}

TEST_F(TomlTest, BooleansAreThoseOfTheCommandLine) {
  for (const char* on : {"true", "\"on\"", "'true'", "1", "'1'"}) {
    fill_ = false;
    applyTomlText(registry_, std::string("oit.fill = ") + on, "x");
    EXPECT_TRUE(fill_) << on;
  }
  for (const char* off : {"false", "\"off\"", "'false'", "0", "'0'"}) {
    fill_ = true;
    applyTomlText(registry_, std::string("oit.fill = ") + off, "x");
    EXPECT_FALSE(fill_) << off;
  }
  EXPECT_EQ(
      messageOf("oit.fill = 2"),
      "x.toml:1: oit.fill: '2' is neither on nor off; oit.fill takes true or false, \"on\" or "
      "\"off\", 1 or 0");
}

TEST_F(TomlTest, WordsWithoutQuotesAreToldHowToBeWritten) {
  const auto endsWith = [&](const std::string& text, const std::string& end) {
    const std::string message = messageOf(text);
    EXPECT_TRUE(message.starts_with("x.toml:2:")) << message;
    EXPECT_TRUE(message.ends_with(end)) << message;
  };
  endsWith("ssaa = 2\noit.fill = on\n", "; write true");
  endsWith("ssaa = 2\noit.fill = False # no", "; write false");
  endsWith("ssaa = 2\noit = { fill = yes }", "; write true");
  endsWith("ssaa = 2\noit.method = peel", "; text stands in quotes, \"peel\"");
  endsWith("ssaa = 2\r\noit.method = kb-atomic\r\n", "; text stands in quotes, \"kb-atomic\"");
  for (const char* other : {"oit.fill = ", "ssaa = 2x", "oit.fill = on'", "= on", "[on"}) {
    EXPECT_EQ(messageOf(other).find("; write"), std::string::npos) << messageOf(other);
  }
}

TEST_F(TomlTest, ColourIsTextOrArray) {
  applyTomlText(registry_, "background = [0, 0.5, 1]", "x");
  EXPECT_EQ(background_, glm::vec3(0.0F, 0.5F, 1.0F));
  applyTomlText(registry_, "background = '1,2,3'", "x");
  EXPECT_EQ(background_, glm::vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(messageOf("background = [0, -1, 0]"),
            "x.toml:1: background: '0,-1,0' is out of range; background takes R,G,B, each >= 0");
  for (const char* bad : {"[0, 0]", "[0, 0, 0, 0]", "[0, 0, 'x']", "[0, 0, 1e300]", "[0, 0, nan]",
                          "[[0], 0, 0]", "'0,0'"}) {
    EXPECT_NE(messageOf(std::string("background = ") + bad), "no error") << bad;
  }
  EXPECT_EQ(background_, glm::vec3(1.0F, 2.0F, 3.0F));
}

TEST_F(TomlTest, ErrorsNameFileAndLine) {
  EXPECT_EQ(messageOf("# comment\n[oit]\nkAve = -1\n"),
            "x.toml:3: oit.kAve: '-1' is out of range; oit.kAve takes a number > 0 and <= 4096");
  EXPECT_EQ(messageOf("\n[oit]\nkAvg = 1\n"),
            "x.toml:3: unknown setting 'oit.kAvg'; the nearest is 'oit.kAve'");
  EXPECT_EQ(messageOf("ssaa = 2\noit.layers = 2.0\n"),
            "x.toml:2: oit.layers: '2' is not a whole number; oit.layers takes a whole number from "
            "1 to 1024");
  EXPECT_EQ(messageOf("oit.kAve = '4'\n"),
            "x.toml:1: oit.kAve: '4' is not a number; oit.kAve takes a number > 0 and <= 4096");
  EXPECT_EQ(messageOf("oit.kAve = [4]\n"),
            "x.toml:1: oit.kAve: is a TOML array; oit.kAve takes a number > 0 and <= 4096");
  EXPECT_EQ(messageOf("oit.kAve = {}\n"),
            "x.toml:1: oit.kAve: is a TOML table; oit.kAve takes a number > 0 and <= 4096");
  EXPECT_EQ(messageOf("[oit]\n"), "no error");
  EXPECT_EQ(messageOf("k-ave = 1\noit.kAve = 2\n").substr(0, 9), "x.toml:2:");
  EXPECT_EQ(messageOf("oit.kAve = 1979-05-27\n"),
            "x.toml:1: oit.kAve: is a TOML date or time; oit.kAve takes a number > 0 and <= 4096");
}

TEST_F(TomlTest, NotFiniteNumbersAreRefused) {
  for (const char* text : {"oit.kAve = nan", "oit.kAve = inf", "oit.kAve = -inf"}) {
    EXPECT_NE(messageOf(text), "no error") << text;
  }
  EXPECT_EQ(kAve_, 8.0);
}

TEST_F(TomlTest, MalformedTextNamesItsPlace) {
  EXPECT_EQ(messageOf("ssaa = 2\noit.kAve = \n").substr(0, 10), "x.toml:2:1");
  EXPECT_EQ(messageOf("[oit\n").substr(0, 8), "x.toml:1");
  EXPECT_NE(messageOf("oit.kAve = 1\noit.kAve = 2\n"), "no error");
  EXPECT_NE(messageOf(std::string("\x00\xFF\xFE", 3)), "no error");
  EXPECT_EQ(messageOf(""), "no error");
  EXPECT_EQ(messageOf("[[oit]]\nkAve = 1\n").substr(0, 8), "x.toml:1");
}

TEST_F(TomlTest, DeepAndLargeTextIsRefusedBeforeItCosts) {
  std::string deep = "a";
  for (int i = 0; i < 200000; ++i) deep += ".a";
  const std::string refusal = "x.toml:2: more than 256 dots; shorten the key, or break the list";
  EXPECT_TRUE(messageOf("\n" + deep + " = 1").starts_with(refusal));
  EXPECT_TRUE(messageOf("\n['x'." + deep + "]").starts_with(refusal));
  EXPECT_NE(messageOf("\"\"\"\\\"\"\"\"." + deep + " = 1"), "no error");
  EXPECT_NE(messageOf("ssaa = " + std::string(100000, '[')), "no error");
  EXPECT_NE(messageOf(std::string(2 << 20, '#')).find("more than"), std::string::npos);
}

TEST_F(TomlTest, TheDeepestTextThatPassesIsFreedWithoutHarm) {
  std::string key = "a";
  for (int i = 0; i < 255; ++i) key += ".a";
  std::string text = "[" + key + "]\n" + key + " = ";
  // 7 arrays and as many tables of 256 within one another, and the number: 15 of 16 values.
  for (int i = 0; i < 7; ++i) text += "[\n{ " + key + " = ";
  text += "1";
  for (int i = 0; i < 7; ++i) text += " } ]";
  EXPECT_NE(messageOf(text).find("unknown setting"), std::string::npos) << messageOf(text);
  const std::string nested = std::string(17, '[') + std::string(17, ']');
  EXPECT_NE(messageOf("ssaa = " + nested).find("depth of 16"), std::string::npos);
}

TEST_F(TomlTest, LettersBeyondAsciiBelongInQuotes) {
  const std::string letter = "\xCA\x9B";  // U+029B, which toml++ 3.3 tests for blanks undefinedly
  const std::string message = messageOf("\na" + letter + " = 1");
  EXPECT_TRUE(message.starts_with("x.toml:2:2: ")) << message;
  EXPECT_TRUE(message.ends_with("expected '=', saw '" + letter + "'")) << message;
  EXPECT_NE(messageOf("\"" + letter + "\" = 1").find("unknown setting"), std::string::npos);
  EXPECT_NE(messageOf("a = \"\"\"\\ \n " + letter + "\"\"\"").find("unknown setting"),
            std::string::npos);
  EXPECT_EQ(messageOf("# " + letter + "\nssaa = 2"), "no error");
  EXPECT_EQ(messageOf("\xEF\xBB\xBFssaa = 2"), "no error");
}

TEST_F(TomlTest, SignsWhereNoneCanStandAreRefusedWithTheirLine) {
  for (const char* text :
       {"ssaa = 1\"a\"", "ssaa = 1.\"a\"", "a\"b\" = 1", "ssaa = \"a\"\"b\"", "a = [1\"\"]",
        "a = { b = 1'x' }", "a = 0=\"b\"", "a = 0[\"b\"]", "a = 0{}", "a{ = 1", "a[0] = 1"}) {
    const std::string message = messageOf(std::string("\n") + text + "\nssaa = 2\n");
    EXPECT_TRUE(message.starts_with("x.toml:2:")) << text << " " << message;
  }
}

// Texts that break an assertion of toml++, which knows no place: it is looked for.
TEST_F(TomlTest, HeadingsWithoutANameAndBracketsThatDoNotMatchAreRefused) {
  for (const char* text : {"[#", "[=]", "[.a]", "[\ra]", "[[,a]]", "[[[a]]]", "a = [}", "a = [1,}",
                           "a = { b = 1, c = [}"}) {
    const std::string message = messageOf(std::string("\n") + text + "\nssaa = 2\n[");
    EXPECT_EQ(message.substr(0, 22), "x.toml:2: is no TOML; ") << text << " " << message;
  }
  for (const char* text : {"[\n", "[ \n", "[\r\n", "[[\n", "a = [1}", "a = { b = 1 ]"}) {
    const std::string message = messageOf(std::string("\n") + text);
    EXPECT_TRUE(message.starts_with("x.toml:2:")) << text << " " << message;
  }
  EXPECT_NE(messageOf("[]"), "no error");
  EXPECT_NE(messageOf("["), "no error");
  EXPECT_EQ(messageOf("ssaa = 2\n[ \"oit\" ]\n"), "no error");
}

TEST_F(TomlTest, QuotesWhereTextMayBeginAreTaken) {
  std::string note;
  registry_.add({.key = "note"}, note);
  applyTomlText(registry_, "\"note\" = \"\"\"a\"\"\"\"\"\n'oit' . \"kAve\" = 2", "x");
  EXPECT_EQ(note, "a\"\"");
  EXPECT_EQ(kAve_, 2.0);
  applyTomlText(registry_, "[\"oit\"]\n'kAve' = 3", "x");
  EXPECT_EQ(kAve_, 3.0);
  applyTomlText(registry_, "\"oit\" = { \"kAve\" = 4, 'method' = \"peel\" }\nnote = ''", "x");
  EXPECT_EQ(kAve_, 4.0);
  EXPECT_EQ(method_, "peel");
  const toml::table table =
      parseToml("a = [\n 'x', # y'\n \"z\",\n]\nb = [{ 'c' = ['d'] }, 'e']", "x");
  EXPECT_EQ(table["a"].as_array()->size(), 2U);
  EXPECT_EQ(table["b"].as_array()->size(), 2U);
}

TEST_F(TomlTest, DotsInTextCommentsAndNumbersAreNoKeyParts) {
  const std::string dots(100, '.');
  EXPECT_EQ(messageOf("# " + dots + "'\nssaa = 2 # " + dots + "\n"), "no error");
  EXPECT_NE(messageOf("oit.method = \"" + dots + "\\\"" + dots + "\"").find("is not known"),
            std::string::npos);
  EXPECT_NE(messageOf("oit.method = '''" + dots + "\n'" + dots + "'''").find("is not known"),
            std::string::npos);
  EXPECT_EQ(messageOf("background = [0.1, 0.1,\n 0.1]"), "no error");
}

TEST_F(TomlTest, File) {
  const std::string path = macula::test::temporaryPath("settings.toml");
  writeFileAtomically(path, "oit.kAve = 0\n");
  EXPECT_THROW(applyTomlFile(registry_, path), InputError);
  try {
    applyTomlFile(registry_, path);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path + ":1: oit.kAve: '0'", 0), 0U) << error.what();
  }
  std::filesystem::remove(path);
  EXPECT_THROW(applyTomlFile(registry_, path), InputError);
}

}  // namespace
}  // namespace macula::settings
