// Parsing, formatting and ranges of single values.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "engine/settings/value.h"

namespace macula::settings {
namespace {

TEST(ParseBool, TakesSixWordsOnly) {
  for (const char* word : {"true", "on", "1"}) EXPECT_EQ(parseBool(word), true) << word;
  for (const char* word : {"false", "off", "0"}) EXPECT_EQ(parseBool(word), false) << word;
  for (const char* word : {"", "yes", "ON", "2", " on"}) EXPECT_FALSE(parseBool(word)) << word;
}

TEST(ParseInt, TakesWholeNumbers) {
  EXPECT_EQ(parseInt("42"), 42);
  EXPECT_EQ(parseInt(" -7 "), -7);
  EXPECT_EQ(parseInt("+7"), 7);
  EXPECT_EQ(parseInt("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
}

TEST(ParseInt, RefusesTheRest) {
  for (const char* text :
       {"", " ", "4.0", "4x", "0x10", "1e3", "9223372036854775808", "+-1", "++1", "--1", "nan"}) {
    EXPECT_FALSE(parseInt(text)) << text;
  }
}

TEST(ParseReal, TakesFiniteNumbers) {
  EXPECT_EQ(parseReal("0.25"), 0.25);
  EXPECT_EQ(parseReal("-1e3"), -1000.0);
  EXPECT_EQ(parseReal("+4"), 4.0);
}

TEST(ParseReal, RefusesTheRest) {
  for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1,5", "4 4", "0x1p3", "."}) {
    EXPECT_FALSE(parseReal(text)) << text;
  }
}

TEST(ParseColour, TakesThreeNumbers) {
  EXPECT_EQ(parseColour("0,0.5,1"), glm::vec3(0.0F, 0.5F, 1.0F));
  EXPECT_EQ(parseColour(" 1 , 2 , 3 "), glm::vec3(1.0F, 2.0F, 3.0F));
}

TEST(ParseColour, RefusesTheRest) {
  for (const char* text :
       {"", "1", "1,2", "1,2,3,4", "1,,3", "1,2,", ",,", "a,b,c", "0,0,nan", "0,0,1e39"}) {
    EXPECT_FALSE(parseColour(text)) << text;
  }
}

TEST(FormatValue, ReadsBackAsTheSameValue) {
  EXPECT_EQ(formatValue(true), "on");
  EXPECT_EQ(formatValue(std::int64_t{-3}), "-3");
  EXPECT_EQ(formatValue(4.0), "4");
  EXPECT_EQ(formatValue(0.1), "0.1");
  EXPECT_EQ(formatValue(glm::vec3(0.0F, 0.1F, 2.0F)), "0,0.1,2");
  EXPECT_EQ(parseReal(formatValue(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(ShortestDouble, HasTheTextOfTheFloat) {
  EXPECT_EQ(shortestDouble(0.35F), 0.35);
  EXPECT_EQ(shortestDouble(-1.0F / 3.0F), -0.33333334);
  EXPECT_EQ(shortestDouble(16777216.0F), 16777216.0);
}

TEST(RangeTest, BoundsAreInclusiveUnlessSaidOtherwise) {
  const Range closed{.min = 1.0, .max = 2.0};
  EXPECT_TRUE(closed.holds(1.0));
  EXPECT_TRUE(closed.holds(2.0));
  EXPECT_FALSE(closed.holds(0.999));
  const Range open{.min = 1.0, .minExclusive = true, .max = 2.0, .maxExclusive = true};
  EXPECT_FALSE(open.holds(1.0));
  EXPECT_FALSE(open.holds(2.0));
  EXPECT_TRUE(open.holds(1.5));
}

TEST(RangeTest, NeverHoldsWhatIsNotFinite) {
  const Range all;
  EXPECT_TRUE(all.holds(-1e300));
  EXPECT_FALSE(all.holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(all.holds(std::numeric_limits<double>::infinity()));
}

TEST(RangeTest, TextNamesTheBounds) {
  EXPECT_EQ(Range{}.text(), "");
  EXPECT_EQ((Range{.min = 1}.text()), ">= 1");
  EXPECT_EQ((Range{.min = 1, .max = 16}.text()), "from 1 to 16");
  EXPECT_EQ((Range{.min = 0, .minExclusive = true, .max = 4096}.text()), "> 0 and <= 4096");
  EXPECT_EQ((Range{.max = 1, .maxExclusive = true}.text()), "< 1");
}

}  // namespace
}  // namespace macula::settings
