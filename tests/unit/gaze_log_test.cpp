// Canonical gaze CSV: what is read, what is refused with which words, and the way back to text.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/core/file.h"
#include "gaze_log_cases.h"

namespace macula::gaze {
namespace {

GazeLog parse(const std::string& text, const std::string& format = "auto") {
  std::istringstream in(text);
  return readGazeLog(in, "log.csv", {.format = format});
}

std::string errorOf(const std::string& text, const std::string& format = "auto") {
  return errorOfLog(text, {.format = format});
}

void expectSameSamples(const GazeLog& a, const GazeLog& b) {
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const GazeSample& p = a.samples[i];
    const GazeSample& q = b.samples[i];
    EXPECT_EQ(p.timeSeconds, q.timeSeconds) << i;
    EXPECT_EQ(p.valid, q.valid) << i;
    EXPECT_EQ(std::isnan(p.position.x), std::isnan(q.position.x)) << i;
    if (!std::isnan(p.position.x)) {
      EXPECT_EQ(p.position, q.position) << i;
    }
    EXPECT_EQ(p.confidence, q.confidence) << i;
    EXPECT_EQ(p.pupilMillimetres, q.pupilMillimetres) << i;
  }
}

TEST(GazeCsv, ReadsEveryColumnInAnyOrder) {
  const GazeLog log = parse(
      "# made by hand\nvalid,x,y,time_s,pupil_mm,confidence\n1,0.25,-0.5,10,3.5,0.9\n"
      "0,,,10.5,,\n\n# between\n0,0.25,nan,11,,\n",
      "macula-csv");
  EXPECT_EQ(log.format, "macula-csv");
  // The last row gives half a place: as the last one it counts as cut off.
  EXPECT_EQ(log.counters.truncatedRows, 1U);
  ASSERT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.startSeconds, 10.0);
  EXPECT_EQ(log.samples[0].timeSeconds, 0.0);
  EXPECT_EQ(log.samples[0].position, glm::dvec2(0.25, -0.5));
  EXPECT_TRUE(log.samples[0].valid);
  EXPECT_EQ(log.samples[0].confidence, 0.9F);
  EXPECT_EQ(log.samples[0].pupilMillimetres, 3.5F);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.5);
  EXPECT_FALSE(log.samples[1].valid);
  EXPECT_TRUE(std::isnan(log.samples[1].position.x));
  EXPECT_FALSE(log.samples[1].confidence.has_value());
  EXPECT_EQ(log.notes, (std::vector<std::string>{"made by hand", "between"}));
  EXPECT_EQ(log.coordinates.unit, "0..1");
}

TEST(GazeCsv, ByteOrderMarkAndCarriageReturnsAreDropped) {
  const GazeLog log = parse("\xEF\xBB\xBFtime_s,x,y,valid\r\n0,0.1,0.2,1\r\n0.5,0.3,0.4,1\r\n");
  ASSERT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.samples[1].position, glm::dvec2(0.3, 0.4));
}

TEST(GazeCsv, KeepsCoordinatesOfLostSamples) {
  const GazeLog log = parse("time_s,x,y,valid\n0,0.1,0.2,0\n");
  EXPECT_EQ(log.samples.at(0).position, glm::dvec2(0.1, 0.2));
  EXPECT_FALSE(log.samples.at(0).valid);
}

TEST(GazeCsv, LastRowThatWasCutOffIsCountedAndNoSample) {
  for (const char* const rest : {"0.2,0.5", "0.2,0.5,0.5,", "0.", "0.2,0.5,0.5,x\n", "0.2\n\n"}) {
    const GazeLog log = parse(std::string("time_s,x,y,valid\n0,0.1,0.2,1\n") + rest);
    EXPECT_EQ(log.samples.size(), 1U) << rest;
    EXPECT_EQ(log.counters.truncatedRows, 1U) << rest;
  }
  // A complete row without a line end is a sample.
  EXPECT_EQ(parse("time_s,x,y,valid\n0,0.1,0.2,1\n0.1,0.5,0.5,1").samples.size(), 2U);
}

TEST(GazeCsv, DuplicateAndBackwardTimesAreCounted) {
  const GazeLog log = parse(
      "time_s,x,y,valid\n0,0.1,0.1,1\n0.2,0.2,0.1,1\n0.2,0.3,0.1,1\n0.1,0.4,0.1,1\n0.15,0.5,0.1,1\n"
      "0.2,0.6,0.1,1\n0.3,0.7,0.1,1\n");
  EXPECT_EQ(log.samples.size(), 7U);
  EXPECT_EQ(log.counters.duplicateTimes, 2U);
  EXPECT_EQ(log.counters.backwardTimes, 2U);
}

TEST(GazeCsv, MistakesAreNamedWithLineAndMend) {
  const std::string head = "time_s,x,y,valid\n0,0.1,0.2,1\n";
  const std::string tail = "\n1,0.1,0.2,1\n";
  EXPECT_EQ(errorOf(head + "abc,0.1,0.2,1" + tail),
            "log.csv: line 3: time_s is 'abc'; write seconds");
  EXPECT_EQ(errorOf(head + "1e300,0.1,0.2,1" + tail),
            "log.csv: line 3: time_s is '1e300'; write seconds");
  EXPECT_EQ(errorOf(head + "0.5,0.1,0.2,2" + tail), "log.csv: line 3: valid is '2'; write 0 or 1");
  EXPECT_EQ(errorOf(head + "0.5,,0.2,1" + tail),
            "log.csv: line 3: x is ''; write a number (or make valid 0 and leave x and y empty)");
  EXPECT_EQ(
      errorOf(head + "0.5,0.1,nan,0" + tail),
      "log.csv: line 3: y is 'nan'; write a number (or make valid 0 and leave x and y empty)");
  EXPECT_EQ(errorOf(head + "0,5,0,1,0,2,1" + tail),
            "log.csv: line 3: 7 cells under a header of 4; write '.' as decimal mark, ',' between");
  EXPECT_EQ(errorOf("time_s,x,y,valid,confidence\n0,0.1,0.2,1,1.5\n1,0.1,0.2,1,1\n"),
            "log.csv: line 2: confidence is '1.5'; write 0..1 or nothing");
  EXPECT_EQ(errorOf("time_s,x,y,valid,pupil_mm\n0,0.1,0.2,1,-1\n1,0.1,0.2,1,1\n"),
            "log.csv: line 2: pupil_mm is '-1'; write millimetres or nothing");
}

TEST(GazeCsv, HeaderMistakesAreNamed) {
  EXPECT_EQ(errorOf("time_s,x,y,vald\n0,0,0,1\n"),
            "log.csv: line 1: unknown column 'vald'; the nearest is 'valid'");
  EXPECT_EQ(errorOf("time_s,x,valid\n0,0,1\n"), "log.csv: line 1: column 'y' is missing; add it");
  EXPECT_EQ(errorOf("time_s,x,x,y,valid\n0,0,0,0,1\n"),
            "log.csv: line 1: column 'x' stands twice; keep one");
}

TEST(GazeLogFile, WhatIsNoGazeLogIsRefusedInOneLine) {
  EXPECT_EQ(errorOf(""), "log.csv: line 1: the file is empty; give a gaze log");
  EXPECT_EQ(errorOf("\n  \n"), "log.csv: line 1: the file is empty; give a gaze log");
  EXPECT_EQ(errorOf("time_s,x,y,valid\n"),
            "log.csv: line 1: no gaze sample follows the header; record or export again");
  EXPECT_TRUE(errorOf("\n\nid,name\n1,bob\n")
                  .starts_with("log.csv: line 3: not the first line of a gaze log; give one of "
                               "macula-csv (time_s,x,y,valid), tobii-studio "));
  EXPECT_EQ(
      errorOf("1\t2\t3\n4\t5\t6\n"),
      "log.csv: line 1: numbers without a header; a BIDS recording needs its JSON, as NAME.json "
      "beside NAME.tsv, or give --gaze.sidecar FILE.json");
  EXPECT_EQ(errorOf(std::string(200000, 'a')),
            "log.csv: line 1: longer than 65536 bytes, so not a gaze log; check the file");
  EXPECT_EQ(errorOf("time_s,x,y,valid\n0,0.5,0.5,1\n" + std::string(70000, '7')),
            "log.csv: line 3: longer than 65536 bytes, so not a gaze log; check the file");
  EXPECT_EQ(errorOf("time_s,x,y,valid\n0,0,0,1\n", "macula-cvs"),
            "gaze format 'macula-cvs' is unknown; the nearest is 'macula-csv'");
  EXPECT_EQ(errorOf("time_s,x,y,valid\n0,0,0,1\n", "tobii-studio"),
            "log.csv: line 1: gaze.format says tobii-studio, but the file is macula-csv; leave it "
            "out, or give macula-csv");
  EXPECT_EQ(errorOf("a,b\n1,2\n", "tobii-studio"),
            "log.csv: line 1: column 'GazePointX' is missing; export it too");
  EXPECT_EQ(errorOf("ID,NAME\nA,B\n", "eyelink"),
            "log.csv: line 2: no gaze sample follows the header; record or export again, or leave "
            "out gaze.format where it is not eyelink");
  EXPECT_EQ(errorOf("time_s,x,y,valid\n1\n2\n"),
            "log.csv: line 2: 1 cell under a header of 4; write '.' as decimal mark, ',' between");
}

TEST(GazeLogFile, WhatIsSomethingElseIsCalledByItsName) {
  const std::string binary = "log.csv: binary data, not a gaze log; export the gaze as CSV or TSV";
  const std::string scene =
      "log.csv: a glTF scene, not a gaze log; give it in place of SCENE, and a log as --gaze";
  EXPECT_EQ(errorOf(std::string("\0\x01\x02\xFF\n\0\n", 7)), binary);
  EXPECT_EQ(errorOf(std::string("\x7F") + "ELF\x02\x01\x01"), binary);
  EXPECT_EQ(errorOf(std::string("\x7F") + "ELF\x02\x01\x01", "tobii-sdk"), binary);
  EXPECT_EQ(errorOf(std::string("glTF\2\0\0\0", 8)), scene);
  EXPECT_EQ(errorOf("{\n  \"asset\": {\"version\": \"2.0\"}}"), scene);
  const auto begins = [](const std::string& text, const std::string& start) {
    EXPECT_TRUE(errorOf(text).starts_with("log.csv: " + start)) << errorOf(text);
  };
  begins("{\"Columns\": []}", "JSON, not a gaze log; ");
  begins("SR_RESEARCH_COMBINED_FILE\n", "an EyeLink EDF, not text; convert it with edf2asc");
  begins("PK\x03\x04zip", "a ZIP archive or a spreadsheet (.xlsx); ");
  begins("<REC TIME=\"1\" />\n", "XML or HTML");
  begins("# a path\ntime_s,x,y,z,target_x,target_y,target_z\n0,1,1,1,0,0,0\n",
         "line 2: a camera path, not a gaze log; give it as --camera");
  begins("RECORDING_SESSION_LABEL\tTIMESTAMP\n", "line 1: an EyeLink Data Viewer report");
  begins("## [BeGaze]\nTime\tType\tTrial\tL POR X [px]\n", "line 2: an SMI BeGaze export");
  begins("session_id,time,left_gaze_x\n", "line 1: gaze of PsychoPy's ioHub");
  begins("n,x,y,lx,ly,clx\n", "line 1: GazeBaseVR");
}

TEST(GazeCsv, SemicolonsAndDecimalCommasOfASpreadsheet) {
  const GazeLog log = parse("time_s;x;y;valid\n0;0,25;0,5;1\n0,02;0,75;0,5;1\n");
  ASSERT_EQ(log.samples.size(), 2U);
  expectPlace(log.samples[0], 0.25, 0.5);
  EXPECT_EQ(log.samples[1].timeSeconds, 0.02);
}

TEST(GazeLogFile, PathsThatCannotBeReadAreRefused) {
  const auto errorOfPath = [](const std::filesystem::path& path) -> std::string {
    try {
      (void)readGazeLog(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(errorOfPath("no/such.csv"), "no/such.csv: no such gaze log; check the path");
  EXPECT_EQ(errorOfPath("/tmp"), "/tmp: is a folder; name a gaze log in it");
  EXPECT_EQ(errorOfPath("/dev/zero"), "/dev/zero: is not a regular file; save the gaze log to one");
}

TEST(CanonicalCsv, WritesTheDocumentedTextAndReadsItBack) {
  const std::string text =
      "# by hand\ntime_s,x,y,valid,confidence,pupil_mm\n0,0.1,0.30000000000000004,1,0.9,3.5\n"
      "0.008333,,,0,0,\n1e-07,-1.5,2,1,,3.25\n0.02,0.1,0.2,0,,\n";
  const GazeLog log = parse(text);
  EXPECT_EQ(canonicalCsv(log), text);
  expectSameSamples(log, parse(canonicalCsv(log)));
}

TEST(CanonicalCsv, ControlCharactersInCommentsBecomeSpaces) {
  const GazeLog log = parse("#\x16 a\tb\x01\ntime_s,x,y,valid\n0,0.5,0.25,1\n");
  EXPECT_EQ(log.notes, std::vector<std::string>{"a b"});
  EXPECT_EQ(canonicalCsv(log), "# a b\ntime_s,x,y,valid\n0,0.5,0.25,1\n");
}

TEST(CanonicalCsv, LeavesOutColumnsThatNoSampleHas) {
  GazeLog log;
  log.samples.push_back({.timeSeconds = 0.0,
                         .position = {0.5, 0.25},
                         .valid = true,
                         .confidence = std::nullopt,
                         .pupilMillimetres = std::nullopt});
  EXPECT_EQ(canonicalCsv(log), "time_s,x,y,valid\n0,0.5,0.25,1\n");
}

TEST(GazeReadme, ItsExampleIsAGazeLog) {
  const std::string page = readTextFile(MACULA_SOURCE_DIR "/engine/gaze/README.md");
  const std::string fence = "```csv\n";
  const std::size_t begin = page.find(fence) + fence.size();
  ASSERT_NE(page.find(fence), std::string::npos);
  const GazeLog log = parse(page.substr(begin, page.find("```", begin) - begin));
  EXPECT_EQ(log.format, "macula-csv");
  EXPECT_EQ(assess(log).samples, 4U);
  EXPECT_EQ(assess(log).lost, 1U);
  EXPECT_EQ(log.counters.truncatedRows, 0U);
}

TEST(GazeQuality, HandWorked) {
  // Every 0.1 s; lost at 0, 0.3 and 0.4; nothing from 0.6 to 1.2; x = 1 is the pixel past the edge.
  const GazeLog log = parse(
      "time_s,x,y,valid\n5,,,0\n5.1,0.5,0.5,1\n5.2,1,0.5,1\n5.3,,,0\n5.4,,,0\n5.5,0.5,-0.1,1\n"
      "5.2,0.5,0.5,1\n5.6,0,0.999,1\n6.2,0.5,0.5,1\n6.3,,,0\n");
  const GazeQuality quality = assess(log);
  EXPECT_EQ(quality.samples, 10U);
  EXPECT_EQ(quality.lost, 4U);
  EXPECT_EQ(quality.offScreen, 2U);
  EXPECT_NEAR(quality.rateHz, 10.0, 1e-9);
  EXPECT_NEAR(quality.durationSeconds, 1.3, 1e-12);
  EXPECT_NEAR(quality.longestDropoutSeconds, 0.5, 1e-9);
}

TEST(GazeQuality, LostFromStartToEnd) {
  const GazeLog log = parse("time_s,x,y,valid\n0,,,0\n0.5,,,0\n1,,,0\n");
  EXPECT_NEAR(assess(log).longestDropoutSeconds, 1.5, 1e-12);
  EXPECT_EQ(assess(parse("time_s,x,y,valid\n3,0.5,0.5,1\n")).rateHz, 0.0);
}

}  // namespace
}  // namespace macula::gaze
