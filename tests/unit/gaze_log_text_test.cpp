// What lies below the formats: packed and encoded bytes, lines, cells, exact times.
#include <gtest/gtest.h>
#include <zlib.h>

#include <vector>

#include "engine/gaze/cells.h"
#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

const std::string kText = "time_s,x,y,valid\r\n0,0.25,0.5,1\r\n0.5,0.75,0.5,1\r\n";

/// Latin-1 as UTF-16, with or without a byte order mark.
std::string utf16(const std::string& text, bool bigEndian, bool mark) {
  std::string bytes;
  const auto unit = [&](unsigned code) {
    const char high = static_cast<char>(code >> 8U);
    const char low = static_cast<char>(code & 0xFFU);
    bytes += bigEndian ? std::string{high, low} : std::string{low, high};
  };
  if (mark) unit(0xFEFF);
  for (const char c : text) unit(static_cast<unsigned char>(c));
  return bytes;
}

std::string gzip(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string input = text;
  std::vector<Bytef> out(text.size() + 1000);
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  const std::size_t size = out.size() - stream.avail_out;
  deflateEnd(&stream);
  return {reinterpret_cast<const char*>(out.data()), size};
}

void expectText(const std::string& bytes) {
  const GazeLog log = parseLog(bytes);
  ASSERT_EQ(log.samples.size(), 2U);
  expectPlace(log.samples[0], 0.25, 0.5);
  expectPlace(log.samples[1], 0.75, 0.5);
}

TEST(GazeLogText, Utf16InEitherOrderWithAndWithoutMark) {
  for (const bool bigEndian : {false, true}) {
    expectText(utf16(kText, bigEndian, true));
    expectText(utf16(kText, bigEndian, false));
  }
}

TEST(GazeLogText, Utf16BeyondLatinBecomesUtf8) {
  // U+00E4, U+4E2D, U+1D11E as a surrogate pair, and half a pair.
  std::string bytes("\xFF\xFE#\0 \0\xE4\0\x2D\x4E\x34\xD8\x1E\xDD\x34\xD8\n\0", 18);
  bytes += utf16("time_s,x,y,valid\n0,0.25,0.5,1\n", false, false);
  const GazeLog log = parseLog(bytes);
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_EQ(log.notes[0], "\xC3\xA4\xE4\xB8\xAD\xF0\x9D\x84\x9E\xEF\xBF\xBD");
}

TEST(GazeLogText, HalfAUnitAtTheEndIsACutOffRow) {
  std::string bytes = utf16(kText + "1,0.5,0.", false, true);
  bytes.pop_back();
  const GazeLog log = parseLog(bytes);
  EXPECT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.counters.truncatedRows, 1U);
}

TEST(GazeLogText, ATimeCenturiesAwayIsASlipInAnyFormat) {
  // Found by the fuzzer: such a sample could be written as CSV and not be read again.
  const std::string header = "n,x,y,val,dP,lab,xT,yT\n0,1,1,0,3,1,1,1\n";
  const GazeLog cut = parseLog(header + "255555555155510,-5,0,0,0,1,1,1\n");
  EXPECT_EQ(cut.samples.size(), 1U);
  EXPECT_EQ(cut.counters.truncatedRows, 1U);
  EXPECT_EQ(errorOfLog(header + "255555555155510,-5,0,0,0,1,1,1\n2,1,1,0,3,1,1,1\n"),
            "log.csv: line 3: its time lies 8097 years from the first sample; correct it");
}

TEST(GazeLogText, ADecimalCommaBetweenCommasIsNoShiftOfColumns) {
  EXPECT_EQ(errorOfLog("n,x,y,val,dP\n0,0,5,0,7,0,3,1\n1,1,1,0,3\n"),
            "log.csv: line 2: 8 cells under a header of 5; export the log again, with '.' as "
            "decimal mark");
}

TEST(GazeLogText, ANumberSignInACellIsNoComment) {
  const std::string header =
      "ParticipantName\tRecordingTimestamp\tValidityLeft\tValidityRight\tGazePointX\tGazePointY\t"
      "MediaWidth\tMediaHeight\n";
  const GazeLog log = parseLog(header + "#2\t1\t0\t0\t400\t300\t800\t600\n");
  EXPECT_EQ(log.samples.size(), 1U);
  EXPECT_TRUE(log.notes.empty());
}

TEST(GazeLogText, PixelsOfUnknownSizeAreAskedForWhereAFormatHasNone) {
  LogOptions options;
  options.unit = GazeUnit::Pixels;
  const std::string text = "TIME,BPOGX,BPOGY,BPOGV\n0,50,40,1\n";
  EXPECT_NE(errorOfLog(text, options).find("give --gaze.screen WIDTHxHEIGHT"), std::string::npos)
      << errorOfLog(text, options);
  options.screen = "100x80";
  const GazeLog log = parseLog(text, options);
  expectPlace(log.samples.at(0), 0.5, 0.5);
}

TEST(GazeLogText, GzipOfOneAndOfSeveralMembers) {
  expectText(gzip(kText));
  expectText(gzip(kText.substr(0, 25)) + gzip(kText.substr(25)));
  expectText(gzip(utf16(kText, false, true)));
  expectText(gzip(kText) + std::string(100, '\0'));
}

TEST(GazeLogText, GzipThatIsCutOffOrDamagedIsAnError) {
  const std::string packed = gzip(kText);
  EXPECT_EQ(errorOfLog(packed.substr(0, packed.size() - 10)),
            "log.csv: the gzip data is cut off; copy the file again");
  std::string damaged = packed;
  damaged[packed.size() / 2] = static_cast<char>(~damaged[packed.size() / 2]);
  EXPECT_NE(errorOfLog(damaged).find("the gzip data is"), std::string::npos);
}

TEST(GazeLogText, ManyCarriageReturnsBeforeALineFeed) {
  expectText("time_s,x,y,valid\r\r\n0,0.25,0.5,1\r\r\n0.5,0.75,0.5,1\r\r\n");
}

TEST(GazeLogText, LinesAcrossTheReadersBuffer) {
  // 100,000 rows: more than any buffer, and every row is checked.
  std::string text = "time_s,x,y,valid\n";
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + ",0.5,0.25,1\n";
  const GazeLog log = parseLog(text);
  ASSERT_EQ(log.samples.size(), 100000U);
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    ASSERT_EQ(log.samples[i].timeSeconds, static_cast<double>(i));
  }
}

TEST(GazeLogText, CommentsThatAreNoUtf8AreRepaired) {
  const std::string mark = "\xEF\xBF\xBD";
  const GazeLog log = parseLog("# caf\xE9\n" + kText);
  EXPECT_EQ(log.notes.at(0), "caf" + mark);
  EXPECT_EQ(repairedUtf8("a\xC3\xA4\xE4\xB8\xAD\xF0\x9D\x84\x9E"),
            "a\xC3\xA4\xE4\xB8\xAD\xF0\x9D\x84\x9E");
  // Overlong, a surrogate, beyond the last code point, a lone continuation, cut off.
  EXPECT_EQ(repairedUtf8("\xC0\x80"), mark + mark);
  EXPECT_EQ(repairedUtf8("\xED\xA0\x80"), mark + mark + mark);
  EXPECT_EQ(repairedUtf8("\xF4\x90\x80\x80"), mark + mark + mark + mark);
  EXPECT_EQ(repairedUtf8("\x80z"), mark + "z");
  EXPECT_EQ(repairedUtf8("\xE4\xB8"), mark + mark);
}

TEST(GazeLogCells, TicksKeepEveryDigit) {
  EXPECT_EQ(parseTicks("1700000000123456789", 0), 1700000000123456789);
  EXPECT_EQ(parseTicks("1700000000.123456789", 9), 1700000000123456789);
  EXPECT_EQ(parseTicks("1408660.5", 3), 1408660500);
  EXPECT_EQ(parseTicks("1408660,5", 3), 1408660500);
  EXPECT_EQ(parseTicks("-0.0015", 3), -2);
  EXPECT_EQ(parseTicks("0.0004", 3), 0);
  EXPECT_EQ(parseTicks(".5", 1), 5);
  EXPECT_EQ(parseTicks("12.", 1), 120);
  EXPECT_EQ(parseTicks("1.5e3", 0), 1500);
  for (const char* const bad : {"", ".", "-", "1:00", "nan", "inf", "1e30", "99999999999999999999",
                                "4000000000000000001", "1 2", "+1"}) {
    EXPECT_EQ(parseTicks(bad, 0), std::nullopt) << bad;
  }
  EXPECT_EQ(parseTicks("4000000000", 9), kLargestTicks);
  EXPECT_EQ(parseTicks("4000000001", 9), std::nullopt);
}

TEST(GazeLogCells, QuotesAndParenthesesHoldSeparators) {
  std::vector<std::string_view> cells;
  const char* const row = "\"(0.1, 0.2)\",(3, 4), \"a,b\" ,,5";
  splitQuotedCells(row, ',', cells);
  EXPECT_EQ(cells, (std::vector<std::string_view>{"(0.1, 0.2)", "(3, 4)", "a,b", "", "5"}));
  const auto pair = parsePair("(0.5, -1e-3)");
  ASSERT_TRUE(pair.has_value());
  EXPECT_EQ(pair->first, 0.5);
  EXPECT_EQ(pair->second, -1e-3);
  for (const char* const bad : {"(nan, nan)", "(1)", "1, 2", "(1, 2", "()", ""}) {
    EXPECT_FALSE(parsePair(bad).has_value()) << bad;
  }
}

TEST(GazeLogCells, NumbersWithEitherMark) {
  EXPECT_EQ(parseNumber("0,25"), 0.25);
  EXPECT_EQ(parseNumber("-1e-3"), -1e-3);
  for (const char* const bad : {"1,2,3", "1.2.3", "", "nan", "inf", "1 ", "0x10", "1,2x"}) {
    EXPECT_FALSE(parseNumber(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace macula::gaze
