// NumPy files: their bytes, that they repeat, and what is refused.
#include "engine/dataset/npz.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"

#if MACULA_DATASET
#include <zip.h>
#endif

namespace macula::dataset {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// A folder that goes with the test.
class Npz : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / fmt::format("macula-npz-{}", ::getpid());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

  fs::path folder_;
};

const std::array kSix = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};

NpzWriter sample() {
  NpzWriter writer;
  writer.add("depth", {2, 3}, kSix);
  writer.add("layers", {2}, std::array<std::uint16_t, 2>{0x0102, 0xFFFF});
  writer.addText("about", "{}");
  return writer;
}

TEST_F(Npz, ShapeAndValuesMustAgree) {
  NpzWriter writer;
  EXPECT_THROW(writer.add("a", {2, 2}, kSix), std::invalid_argument);
  EXPECT_THROW(writer.add("a", {}, kSix), std::invalid_argument);
  EXPECT_THROW(writer.add("a", {6, 0}, kSix), std::invalid_argument);
  const std::size_t half = std::size_t{1} << 63U;  // 2 x 2^63 wraps around to 0
  EXPECT_THROW(writer.add("a", {2, half}, std::span<const float>()), std::invalid_argument);
  EXPECT_THROW(writer.add("a", std::vector<std::size_t>(33, 1), std::array{1.0F}),
               std::invalid_argument);
  writer.add("a", {3, 1, 2}, kSix);
  writer.add("none", {4, 0}, std::span<const float>());
}

TEST_F(Npz, NamesAreWordsAndStandOnce) {
  NpzWriter writer;
  for (const char* name : {"", "a b", "a/b", "../a", "a.npy", "caf\xC3\xA9"}) {
    EXPECT_THROW(writer.add(name, {6}, kSix), std::invalid_argument) << name;
  }
  writer.add("Depth_0", {6}, kSix);
  EXPECT_THROW(writer.add("Depth_0", {6}, kSix), std::invalid_argument);
  EXPECT_THROW(writer.addText("Depth_0", ""), std::invalid_argument);
}

TEST_F(Npz, AFileOfNothingIsAMistake) {
  EXPECT_THROW(NpzWriter().write(folder_ / "a.npz"), std::logic_error);
  EXPECT_THAT(names(), ElementsAre());
}

#if MACULA_DATASET

/// A file of the zip, as it stands there.
struct Stored {
  std::string bytes;
  std::uint16_t method = 0;
};

std::map<std::string, Stored> filesOf(const fs::path& path) {
  std::map<std::string, Stored> files;
  int code = 0;
  const std::unique_ptr<zip_t, void (*)(zip_t*)> zip(
      zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code), zip_discard);
  if (!zip) return files;
  for (zip_int64_t i = 0; i < zip_get_num_entries(zip.get(), 0); ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    zip_stat_t about;
    EXPECT_EQ(zip_stat_index(zip.get(), index, 0, &about), 0);
    std::string bytes(about.size, '\0');
    zip_file_t* file = zip_fopen_index(zip.get(), index, 0);
    EXPECT_EQ(zip_fread(file, bytes.data(), bytes.size()), static_cast<zip_int64_t>(about.size));
    EXPECT_EQ(zip_fclose(file), 0);
    files[about.name] = {bytes, about.comp_method};
  }
  return files;
}

/// A .npy taken apart after NumPy's NEP 1.
struct Npy {
  std::string dictionary;  ///< without the blanks behind it
  std::string values;
};

Npy parsed(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + length) % 64, 0U);
  const std::string header = bytes.substr(10, length);
  EXPECT_EQ(header.back(), '\n');
  const std::size_t end = header.find_last_not_of(" \n");
  return {header.substr(0, end + 1), bytes.substr(10 + length)};
}

TEST_F(Npz, HoldsEachArrayAsNpy) {
  NpzWriter writer = sample();
  writer.add("words", {}, std::array<std::uint32_t, 1>{0x01020304});
  writer.add("longs", {1, 1}, std::array<std::uint64_t, 1>{0x0102030405060708});
  writer.add("none", {0, 4}, std::span<const std::uint8_t>());
  writer.write(folder_ / "a.npz");
  const std::map<std::string, Stored> files = filesOf(folder_ / "a.npz");
  ASSERT_EQ(files.size(), 6U);

  const Npy depth = parsed(files.at("depth.npy").bytes);
  EXPECT_EQ(depth.dictionary, "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }");
  ASSERT_EQ(depth.values.size(), 24U);
  EXPECT_EQ(depth.values.substr(0, 8), std::string("\0\0\x80\x3F\0\0\0\x40", 8));

  const Npy layers = parsed(files.at("layers.npy").bytes);
  EXPECT_EQ(layers.dictionary, "{'descr': '<u2', 'fortran_order': False, 'shape': (2,), }");
  EXPECT_EQ(layers.values, "\x02\x01\xFF\xFF");

  const Npy words = parsed(files.at("words.npy").bytes);
  EXPECT_EQ(words.dictionary, "{'descr': '<u4', 'fortran_order': False, 'shape': (), }");
  EXPECT_EQ(words.values, "\x04\x03\x02\x01");

  const Npy longs = parsed(files.at("longs.npy").bytes);
  EXPECT_EQ(longs.dictionary, "{'descr': '<u8', 'fortran_order': False, 'shape': (1, 1), }");
  EXPECT_EQ(longs.values, "\x08\x07\x06\x05\x04\x03\x02\x01");

  const Npy none = parsed(files.at("none.npy").bytes);
  EXPECT_EQ(none.dictionary, "{'descr': '|u1', 'fortran_order': False, 'shape': (0, 4), }");
  EXPECT_EQ(none.values, "");

  const Npy about = parsed(files.at("about.npy").bytes);
  EXPECT_EQ(about.dictionary, "{'descr': '|u1', 'fortran_order': False, 'shape': (2,), }");
  EXPECT_EQ(about.values, "{}");
}

TEST_F(Npz, ValuesAreAlignedBehindAnyHeader) {
  NpzWriter writer;
  for (std::size_t sides = 0; sides <= 32; ++sides) {
    writer.add(fmt::format("sides{}", sides), std::vector<std::size_t>(sides, 1), std::array{1.0F});
  }
  writer.write(folder_ / "a.npz");
  const std::map<std::string, Stored> files = filesOf(folder_ / "a.npz");
  EXPECT_EQ(files.size(), 33U);
  for (const auto& [name, file] : files) {
    EXPECT_EQ(parsed(file.bytes).values, std::string("\0\0\x80\x3F", 4)) << name;
  }
}

TEST_F(Npz, IsDeflated) {
  NpzWriter writer;
  writer.add("zeros", {100000}, std::vector<float>(100000, 0.0F));
  writer.write(folder_ / "a.npz");
  EXPECT_EQ(filesOf(folder_ / "a.npz").at("zeros.npy").method, ZIP_CM_DEFLATE);
  EXPECT_LT(fs::file_size(folder_ / "a.npz"), 10000U);
}

/// Another time zone for the life of the object.
class TimeZone {
 public:
  explicit TimeZone(const char* zone) {
    if (const char* old = std::getenv("TZ")) old_ = old;
    ::setenv("TZ", zone, 1);
    ::tzset();
  }
  ~TimeZone() {
    if (old_.empty()) {
      ::unsetenv("TZ");
    } else {
      ::setenv("TZ", old_.c_str(), 1);
    }
    ::tzset();
  }
  TimeZone(const TimeZone&) = delete;
  TimeZone& operator=(const TimeZone&) = delete;

 private:
  std::string old_;
};

TEST_F(Npz, BytesRepeatInAnyTimeZone) {
  sample().write(folder_ / "a.npz");
  const std::string first = readTextFile(folder_ / "a.npz");
  for (const char* zone : {"UTC0", "AAA-13", "BBB+11", "CET-1CEST,M3.5.0,M10.5.0"}) {
    const TimeZone elsewhere(zone);
    sample().write(folder_ / "b.npz");
    EXPECT_EQ(readTextFile(folder_ / "b.npz"), first) << zone;
  }
  // Local header: 12:00:00 in the upper five bits of the time, then 1980-01-01.
  EXPECT_EQ(first.substr(10, 4), std::string("\x00\x60\x21\x00", 4));
}

TEST_F(Npz, ReplacesAndLeavesNothingElse) {
  NpzWriter other;
  other.add("old", {6}, kSix);
  other.write(folder_ / "a.npz");
  sample().write(folder_ / "a.npz");
  EXPECT_EQ(filesOf(folder_ / "a.npz").size(), 3U);
  EXPECT_THAT(names(), ElementsAre("a.npz"));
}

TEST_F(Npz, WhatCannotBeWrittenNamesThePath) {
  const std::string missing = (folder_ / "none" / "a.npz").string();
  EXPECT_THAT([&] { sample().write(missing); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(testing::StartsWith(missing + ": cannot be written ("),
                                 HasSubstr("check the folder and the space left"))));
  fs::create_directories(folder_ / "a.npz" / "full");
  EXPECT_THAT([&] { sample().write(folder_ / "a.npz"); },
              testing::ThrowsMessage<InputError>(HasSubstr("a.npz: cannot be written (")));
  EXPECT_THAT(names(), ElementsAre("a.npz"));
}

/// No file of this process grows beyond some bytes for the life of the object: a disk that is full.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{.rlim_cur = bytes, .rlim_max = old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit old_{};
  void (*handler_)(int);
};

TEST_F(Npz, AFullDiskLeavesTheOldFile) {
  sample().write(folder_ / "a.npz");
  const std::string before = readTextFile(folder_ / "a.npz");
  std::mt19937 random(1);  // noise, which deflate cannot shrink below the limit
  std::vector<std::uint32_t> noise(10000);
  for (std::uint32_t& value : noise) value = static_cast<std::uint32_t>(random());
  NpzWriter writer;
  writer.add("noise", {noise.size()}, noise);
  std::string message = "no error";
  {
    const SmallDisk disk(4096);
    try {
      writer.write(folder_ / "a.npz");
    } catch (const InputError& error) {
      message = error.what();
    }
  }
  EXPECT_THAT(message, HasSubstr("a.npz: cannot be written ("));
  EXPECT_THAT(names(), ElementsAre("a.npz"));
  EXPECT_EQ(readTextFile(folder_ / "a.npz"), before);
}

#else

TEST_F(Npz, WhereLeftOutWritingSaysSo) {
  EXPECT_THAT([&] { sample().write(folder_ / "a.npz"); },
              testing::ThrowsMessage<InputError>(HasSubstr("-DMACULA_DATASET=ON")));
  EXPECT_THAT(names(), ElementsAre());
}

#endif

}  // namespace
}  // namespace macula::dataset
