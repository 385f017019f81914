// Recordings on disk: what a sudden end leaves behind, and what is no recording.
#include "engine/recording/reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/recording/parse.h"
#include "engine/recording/scene_source.h"
#include "engine/recording/text.h"
#include "engine/recording/writer.h"
#include "tests/unit/recording_builder.h"

namespace macula::recording {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder that goes with the test.
class RecordingFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / fmt::format("macula-recording-{}", ::getpid());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

std::string linesOf(std::uint64_t frames) {
  std::string text;
  for (std::uint64_t i = 0; i < frames; ++i) appendFrameLine(someFrame(i), text);
  return text;
}

Recording framesOf(const std::string& text) {
  std::istringstream in(text);
  return parseFrames(in, "frames.jsonl");
}

/// The message about a text that replaces another in the second of three lines.
std::string messageFor(const std::string& good, const std::string& bad) {
  std::string text = linesOf(3);
  const std::size_t at = text.find(good, text.find('\n'));
  if (at == std::string::npos) return "nothing to replace";
  text.replace(at, good.size(), bad);
  try {
    (void)framesOf(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(RecordingFolder, EachLineIsThereAsSoonAsItIsWritten) {
  RecordingWriter writer(folder_, someSession());
  EXPECT_TRUE(isRecording(folder_));
  EXPECT_TRUE(readRecording(folder_).frames.empty());
  for (std::uint64_t i = 0; i < 4; ++i) {
    writer.frame(someFrame(i));
    const Recording read = readRecording(folder_);  // the writer is still open
    ASSERT_EQ(read.frames.size(), i + 1);
    EXPECT_EQ(read.truncatedLines, 0U);
    expectSame(read.frames.back(), someFrame(i));
    gaze::GazeSample sample;
    sample.timeSeconds = static_cast<double>(i);
    writer.raw(sample);
    EXPECT_THAT(readTextFile(folder_ / kGazeFile), HasSubstr(fmt::format("\n{},,,0,,\n", i)));
  }
  EXPECT_EQ(readRecording(folder_).session.scene, someSession().scene);
}

TEST_F(RecordingFolder, ARecordingIsNeverWrittenOver) {
  for (const char* name : {kSessionFile, kFramesFile, kGazeFile}) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / name) << "mine";
    try {
      RecordingWriter(folder_, someSession());
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("holds a recording already; choose a new folder"));
    }
    EXPECT_EQ(readTextFile(folder_ / name), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
    fs::remove_all(folder_);
  }
}

TEST_F(RecordingFolder, AFullDiskIsAnErrorAndLeavesWhatWasRecorded) {
  RecordingWriter writer(folder_, someSession());
  // A limit for files stands in for a disk: what is over it is refused.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::uint64_t written = 0;
  std::string message;
  try {
    for (; written < 100; ++written) writer.frame(someFrame(written));
  } catch (const InputError& error) {
    message = error.what();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, HasSubstr("what was recorded so far can be replayed"));
  EXPECT_GT(written, 3U);
  const Recording read = readRecording(folder_);
  EXPECT_EQ(read.frames.size(), written);
  EXPECT_EQ(read.truncatedLines, 1U);
}

TEST_F(RecordingFolder, ASceneFileThatChangedIsNamed) {
  fs::create_directories(folder_);
  const fs::path file = folder_ / "scene.glb";
  std::ofstream(file) << "one";
  const SceneSource source = sourceOf(file.string());
  EXPECT_EQ(source.file, file.string());
  EXPECT_EQ(checkedScene(source), file.string());
  EXPECT_EQ(sourceOf("layers-4").file, "");
  EXPECT_EQ(checkedScene(sourceOf("layers-4")), "layers-4");
  std::ofstream(file) << "two";
  EXPECT_THROW((void)checkedScene(source), InputError);
  fs::remove(file);
  EXPECT_THROW((void)checkedScene(source), InputError);
}

TEST(RecordingReader, ALineThatWasCutOffIsDroppedAndCounted) {
  const std::string whole = linesOf(2);
  const std::string text = linesOf(3);
  for (std::size_t end = whole.size(); end <= text.size(); ++end) {
    const Recording read = framesOf(text.substr(0, end));
    const bool all = end == text.size();
    ASSERT_EQ(read.frames.size(), all ? 3U : 2U) << end;
    ASSERT_EQ(read.truncatedLines, all || end == whole.size() ? 0U : 1U) << end;
    expectSame(read.frames[1], someFrame(1));
  }
  EXPECT_EQ(framesOf("").truncatedLines, 0U);
  EXPECT_EQ(framesOf("{").truncatedLines, 1U);
}

TEST(RecordingReader, AnyOtherDamageIsNamedWithItsLine) {
  const auto message = [](const char* good, const char* bad) { return messageFor(good, bad); };
  EXPECT_EQ(message("\"cut\":false", "\"cut\":2"),
            "frames.jsonl: line 2: 'cut' is 2; give true or false, \"on\" or \"off\", 1 or 0");
  for (const char* off : {"0", "\"off\""}) {
    EXPECT_EQ(message("\"cut\":false", (std::string("\"cut\":") + off).c_str()), "no error") << off;
  }
  EXPECT_THAT(message("{", ""), HasSubstr("frames.jsonl: line 2: byte 8: is no JSON"));
  EXPECT_THAT(message("\"r\":1", "\"r\":1,\"leverz\":{}"),
              HasSubstr("line 2: 'leverz' is not known; the nearest is"));
  EXPECT_THAT(message("\"radius\"", "\"radios\""), HasSubstr("'gaze.radius' is missing"));
  EXPECT_THAT(message("\"index\":1", "\"index\":5"),
              HasSubstr("line 2: frame 5 stands where 1 should"));
  EXPECT_THAT(message("\"none\"", "\"nine\""), HasSubstr("'reset' is 'nine'"));
  EXPECT_THAT(message("\"width\":640", "\"width\":641"), HasSubstr("without a 'reset'"));
  EXPECT_THAT(message("\"width\":640", "\"width\":0"), HasSubstr("'width'"));
  EXPECT_THAT(message("\"width\":640", "\"width\":20000"),
              HasSubstr("'width' is 20000; give a whole number from 1 to 16384 (pixels)"));
  EXPECT_THAT(message("\"width\":640", "\"width\":-1"), HasSubstr("'width'"));
  EXPECT_THAT(message("\"time_s\":0.016", "\"time_s\":\"inf\""), HasSubstr("'time_s'"));
  EXPECT_THAT(message("\"vfov\":", "\"vfov\":4e9,\"x\":"), HasSubstr("'camera.vfov'"));
  EXPECT_THAT(message("\"up\":[0,1,0]", "\"up\":[0,1]"), HasSubstr("'camera.up'"));
  EXPECT_THAT(message("\"up\":[0,1,0]", "\"up\":[0,1,1e99]"),
              HasSubstr("'camera.up' is too large"));
  EXPECT_THAT(message("\"up\":[0,1,0]", "\"up\":[0,1,1e999]"), HasSubstr("line 2: holds a number"));
  EXPECT_THAT(message("\"x\":0.3", "\"x\":1.5"),
              HasSubstr("'gaze.x' is 1.5; give a finite number from 0 to 1"));
  EXPECT_THAT(message("\"state\":\"ok\"", "\"state\":\"okay\""), HasSubstr("(nearest: 'ok')"));
  EXPECT_THAT(message("\"age_s\":0", "\"age_s\":-1"), HasSubstr("'gaze.age_s'"));
  EXPECT_THAT(message("\"r\":1", "\"r\":0.5"), HasSubstr("'r' is 0.5; give a finite number >= 1"));
  EXPECT_THAT(message("\"r\":1", "\"r\":1,\"settings\":{\"a\":null}"), HasSubstr("'settings.a'"));
  EXPECT_THAT(message("\"r\":1", "\"r\":1,\"image_sha256\":\"abc\""), HasSubstr("'image_sha256'"));
  EXPECT_EQ(message("\"cut\":false", "\"cut\":false"), "no error") << "the rest of the test fails";
}

TEST(RecordingReader, TheFirstFrameBeginsWithANewRenderer) {
  std::string text = linesOf(1);
  text.replace(text.find("restart"), 7, "scene");
  EXPECT_THROW((void)framesOf(text), InputError);
}

TEST(RecordingReader, ASchemaThatIsNotKnownNamesTheProgramThatKnowsIt) {
  std::string text = sessionText(someSession());
  text.replace(text.find("\"schema\": 1"), 11, "\"schema\": 2");
  try {
    (void)parseSession(text, "session.json");
    ADD_FAILURE() << "taken";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "session.json: schema 2 is not known, only 1; replay it with the program that "
                 "recorded it, 300cf30ad6fe");
  }
  EXPECT_THROW((void)parseSession("[]", "session.json"), InputError);
  EXPECT_THROW((void)parseSession("", "session.json"), InputError);
}

/// The text of the fenced blocks of the README with this language.
std::vector<std::string> blocksOf(const std::string& language) {
  const std::string text = readTextFile(MACULA_SOURCE_DIR "/engine/recording/README.md");
  const std::string fence = "```" + language + "\n";
  std::vector<std::string> blocks;
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

TEST(RecordingReadme, ItsExampleIsARecording) {
  const auto session = blocksOf("json");
  const auto frames = blocksOf("jsonl");
  const auto gaze = blocksOf("csv");
  ASSERT_TRUE(session.size() == 1 && frames.size() == 1 && gaze.size() == 1);
  EXPECT_EQ(parseSession(session[0], "README.md").scene.name, "gallery");
  const Recording read = framesOf(frames[0]);
  ASSERT_EQ(read.frames.size(), 3U);
  EXPECT_EQ(read.frames[1].settings.size(), 1U);
  EXPECT_EQ(read.frames[2].size, glm::ivec2(800, 600));
  EXPECT_TRUE(gaze[0].starts_with(kGazeHeader));
  // What is written is what the page shows.
  std::string again;
  for (const Frame& frame : read.frames) appendFrameLine(frame, again);
  EXPECT_EQ(again, frames[0]);
}

}  // namespace
}  // namespace macula::recording
