// Image files: what is written comes back, and damaged files end in one line.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/image.h"
#include "engine/image/jpeg.h"

namespace macula::image {
namespace {

namespace fs = std::filesystem;

class ImageTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path put(const std::string& name, const std::string& bytes) const {
    writeFileAtomically(folder_ / name, bytes);
    return folder_ / name;
  }

  static std::string messageOf(const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  /// Reads and expects one line that begins with the path.
  static std::string refusal(const fs::path& path) {
    std::string message = messageOf([&] { (void)readImage(path); });
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0U) << message;
    return message.substr(std::min(message.size(), path.string().size() + 2));
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("macula_image_test_" + std::to_string(::getpid()));
};

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xFF));
  }
  return bytes;
}

/// CRC-32 of PNG, annex D.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
  }
  return ~crc;
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data +
         bigEndian(crc32(type + data));
}

/// A PNG with one stored (uncompressed) deflate block. `rows` includes the filter bytes.
std::string makePng(std::uint32_t width, std::uint32_t height, char bits, char colourType,
                    const std::string& rows) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char byte : rows) {
    a = (a + static_cast<std::uint8_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto length = static_cast<std::uint16_t>(rows.size());
  const auto low = [](std::uint16_t v) { return static_cast<char>(v & 0xFF); };
  const auto high = [](std::uint16_t v) { return static_cast<char>(v >> 8); };
  const auto complement = static_cast<std::uint16_t>(~length);
  std::string zlib = "\x78\x01\x01";
  zlib += {low(length), high(length), low(complement), high(complement)};
  zlib += rows + bigEndian((b << 16) | a);
  std::string header = bigEndian(width) + bigEndian(height);
  header += {bits, colourType, 0, 0, 0};
  return "\x89PNG\r\n\x1A\n" + chunk("IHDR", header) + chunk("IDAT", zlib) + chunk("IEND", "");
}

Image8 ramp(int channels) {
  Image8 image{16, 16, channels, {}};
  for (int i = 0; i < 256 * channels; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>((i * 37) % 256));
  }
  return image;
}

TEST_F(ImageTest, PngRoundTripKeepsEveryByte) {
  for (int channels = 1; channels <= 4; ++channels) {
    const Image8 written = ramp(channels);
    const fs::path path = folder_ / "round.png";
    writePng(path, written);
    const ImageF read = readImage(path);
    EXPECT_EQ(read.width, 16);
    EXPECT_EQ(read.height, 16);
    ASSERT_EQ(read.channels, channels);
    EXPECT_FALSE(read.linear);
    EXPECT_EQ(toImage8(read).pixels, written.pixels) << channels;
    EXPECT_EQ(read.pixels[1], static_cast<float>(written.pixels[1]) / 255.0F);
  }
}

TEST_F(ImageTest, ColoursUnderZeroAlphaSurvive) {
  const Image8 written{2, 1, 4, {200, 100, 50, 0, 10, 20, 30, 128}};
  writePng(folder_ / "alpha.png", written);
  EXPECT_EQ(toImage8(readImage(folder_ / "alpha.png")).pixels, written.pixels);
}

TEST_F(ImageTest, EqualImagesMakeEqualFilesWithoutADate) {
  writePng(folder_ / "a.png", ramp(3));
  writePng(folder_ / "b.png", ramp(3));
  const std::string png = readTextFile(folder_ / "a.png");
  EXPECT_EQ(png, readTextFile(folder_ / "b.png"));
  for (const char* mark : {"tIME", "tEXt", "iTXt"}) {
    EXPECT_EQ(png.find(mark), std::string::npos) << mark;
  }
  if (!hasExr()) return;
  const ImageF floats{2, 1, 3, {0.1F, 0.2F, 0.3F, 4.0F, 5.0F, 6.0F}, true};
  writeExr(folder_ / "a.exr", floats);
  writeExr(folder_ / "b.exr", floats);
  const std::string exr = readTextFile(folder_ / "a.exr");
  EXPECT_EQ(exr, readTextFile(folder_ / "b.exr"));
  EXPECT_NE(exr.find("1970:01:01"), std::string::npos);  // the format's writer insists on a date
}

TEST_F(ImageTest, ExrRoundTripKeepsEveryBit) {
  if (!hasExr()) GTEST_SKIP() << "this build has no EXR (MACULA_IMAGE_IO=OFF)";
  for (int channels = 1; channels <= 4; ++channels) {
    ImageF written{33, 17, channels, {}};
    for (int i = 0; i < 33 * 17 * channels; ++i) {
      written.pixels.push_back(std::sin(static_cast<float>(i)) * 1e6F);
    }
    written.pixels[0] = std::numeric_limits<float>::denorm_min();
    written.pixels[5] = std::numeric_limits<float>::infinity();
    writeExr(folder_ / "round.exr", written);
    const ImageF read = readImage(folder_ / "round.exr");
    EXPECT_TRUE(read.linear);
    ASSERT_EQ(read.channels, channels);
    EXPECT_EQ(read.pixels, written.pixels);
  }
}

TEST_F(ImageTest, WithoutExrTheBuildSaysSo) {
  if (hasExr()) GTEST_SKIP() << "this build has EXR (MACULA_IMAGE_IO=ON)";
  const ImageF image{1, 1, 1, {0.5F}};
  EXPECT_NE(messageOf([&] { writeExr(folder_ / "x.exr", image); }).find("MACULA_IMAGE_IO=ON"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "x.exr"));
  EXPECT_NE(refusal(put("y.exr", "\x76\x2F\x31\x01")).find("MACULA_IMAGE_IO=ON"),
            std::string::npos);
}

TEST_F(ImageTest, SixteenBitGreyIsNotCutToEight) {
  const ImageF image =
      readImage(put("grey16.png", makePng(2, 1, 16, 0, std::string("\0\x80\x01\xFF\xFF", 5))));
  EXPECT_EQ(image.channels, 1);
  EXPECT_EQ(image.pixels, (std::vector<float>{32769.0F / 65535.0F, 1.0F}));
}

// 2 x 1 pixels: (128, 64, 32) * 2^(129 - 136) and twice that.
TEST_F(ImageTest, RadianceHdr) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  const fs::path path = put("x.hdr", header + "\x80\x40\x20\x81\x80\x40\x20\x82");
  const ImageF image = readHdr(path);
  EXPECT_TRUE(image.linear);
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.pixels, (std::vector<float>{1.0F, 0.5F, 0.25F, 2.0F, 1.0F, 0.5F}));
  EXPECT_NE(refusal(put("cut.hdr", header + "\x80\x40")), "no error");
  EXPECT_NE(refusal(put("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 9 +X 999999999\n")),
            "no error");
}

TEST_F(ImageTest, RadianceRunLengths) {
  // 8 pixels coded a component at a time: R a run of 8, G 3 bytes and a run of 5, B and E runs.
  const std::string coded(
      "\x02\x02\x00\x08"
      "\x88\x80"
      "\x03\x10\x20\x40\x85\x80"
      "\x88\x00"
      "\x88\x81",
      16);
  // The older way: one pixel, then 1, 1, 1, 7 to repeat it.
  const std::string repeated("\x80\x40\x20\x81\x01\x01\x01\x07", 8);
  const std::string header = "#?RGBE\n\n-Y 2 +X 8\n";
  const ImageF image = readImage(put("runs.hdr", header + coded + repeated));
  ASSERT_EQ(image.pixels.size(), 48U);
  const std::vector<float> green = {0.125F, 0.25F, 0.5F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F};
  for (std::size_t x = 0; x < 8; ++x) {
    EXPECT_EQ(image.pixels[3 * x], 1.0F);
    EXPECT_EQ(image.pixels[3 * x + 1], green[x]);
    EXPECT_EQ(image.pixels[3 * x + 2], 0.0F);
    EXPECT_EQ(image.pixels[24 + 3 * x + 1], 0.5F);
  }
  const std::string whole = header + coded + repeated;
  for (std::size_t length = 1; length < whole.size(); ++length) {
    refusal(put("cut.hdr", whole.substr(0, length)));
  }
  for (const std::string& row : {std::string("\x01\x01\x01\x08", 4),          // repeats nothing
                                 std::string("\x02\x02\x00\x09\x88\x80", 6),  // another width
                                 std::string("\x02\x02\x00\x08\x89\x80", 6),  // a run too long
                                 std::string("\x02\x02\x00\x08\x00\x00", 6)}) {
    EXPECT_NE(refusal(put("bad.hdr", header + row + whole)).find("is damaged at byte"),
              std::string::npos);
  }
  EXPECT_NE(refusal(put("xyz.hdr", "#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd")), "");
  EXPECT_NE(refusal(put("turned.hdr", "#?RGBE\n\n+Y 1 +X 1\nabcd")), "");
}

TEST_F(ImageTest, HdrWantsALinearColourImage) {
  writePng(folder_ / "x.png", ramp(3));
  EXPECT_NE(messageOf([&] { (void)readHdr(folder_ / "x.png"); }).find("is a PNG"),
            std::string::npos);
  if (!hasExr()) return;
  writeExr(folder_ / "grey.exr", {1, 1, 1, {0.5F}, true});
  EXPECT_NE(messageOf([&] { (void)readHdr(folder_ / "grey.exr"); }).find("has 1 channel"),
            std::string::npos);
}

TEST_F(ImageTest, WhatIsNoImageIsRefused) {
  EXPECT_EQ(refusal(folder_ / "missing.png"), "no such file; check the path");
  EXPECT_EQ(refusal(folder_), "is no plain file; name an image");
  EXPECT_EQ(refusal(put("empty.png", "")), "is empty; give a PNG, EXR or HDR image");
  EXPECT_EQ(refusal(put("text.png", "hello")),
            "is no image that Macula reads; give a PNG, EXR or HDR image");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  EXPECT_EQ(refusal(folder_ / "pipe.png"), "is no plain file; name an image");
}

TEST_F(ImageTest, EveryTruncationIsRefused) {
  writePng(folder_ / "x.png", ramp(3));
  const std::string png = readTextFile(folder_ / "x.png");
  testing::internal::CaptureStderr();  // one line means one: the decoder must not print its own
  for (std::size_t length = 1; length < png.size(); length += 7) {
    refusal(put("cut.png", png.substr(0, length)));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (!hasExr()) return;
  writeExr(folder_ / "x.exr", {33, 40, 3, std::vector<float>(33 * 40 * 3, 0.7F), true});
  const std::string exr = readTextFile(folder_ / "x.exr");
  for (std::size_t length = 1; length < exr.size(); length += 11) {
    refusal(put("cut.exr", exr.substr(0, length)));
  }
}

TEST_F(ImageTest, EveryFlippedByteOfAPngIsRefused) {
  writePng(folder_ / "x.png", ramp(3));
  const std::string png = readTextFile(folder_ / "x.png");
  testing::internal::CaptureStderr();
  for (std::size_t at = 0; at < png.size(); at += 3) {
    std::string flipped = png;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x20);
    EXPECT_NE(refusal(put("flipped.png", flipped)), "") << at;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ImageTest, HeadersThatLieAreRefusedBeforeTheyCost) {
  const std::string rows("\0\0", 2);
  testing::internal::CaptureStderr();
  EXPECT_NE(refusal(put("huge.png", makePng(30000, 30000, 8, 6, rows))).find("cannot hold"),
            std::string::npos);
  EXPECT_EQ(refusal(put("wide.png", makePng(2000000000, 1, 8, 0, rows))),
            "is 2000000000 x 1 pixels; 1 x 1 to 32768 x 32768 can be read");
  EXPECT_EQ(refusal(put("none.png", makePng(0, 1, 8, 0, rows))),
            "is 0 x 1 pixels; 1 x 1 to 32768 x 32768 can be read");
  EXPECT_NE(refusal(put("type.png", makePng(1, 1, 8, 5, rows))), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ImageTest, UnwritablePathNamesItself) {
  const std::string path = (folder_ / "no" / "x.png").string();
  EXPECT_EQ(messageOf([&] { writePng(path, ramp(3)); }).rfind(path + ": cannot be written", 0), 0U);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(ImageTest, InconsistentImageIsAMistakeOfTheProgram) {
  EXPECT_THROW(writePng(folder_ / "x.png", {2, 2, 3, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(writePng(folder_ / "x.png", {0, 0, 3, {}}), std::invalid_argument);
  EXPECT_THROW(writeExr(folder_ / "x.exr", {1, 1, 5, std::vector<float>(5)}),
               std::invalid_argument);
}

TEST(ToImage8, ClampsAndRounds) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const ImageF image{6, 1, 1, {-1.0F, nan, 0.5F, 1.0F, 9.0F, 1.4F / 255.0F}};
  EXPECT_EQ(toImage8(image).pixels, (std::vector<std::uint8_t>{0, 0, 128, 255, 255, 1}));
}

TEST(Jpeg, IsOneFileOfItsSizeAndSmallerThanThePixels) {
  Image8 image{64, 32, 3, std::vector<std::uint8_t>(64 * 32 * 3, 128)};
  const std::string bytes = encodeJpeg(image, 92);
  EXPECT_TRUE(bytes.starts_with("\xFF\xD8\xFF"));
  EXPECT_TRUE(bytes.ends_with("\xFF\xD9"));
  const std::string frame("\xFF\xC0\0\x11\x08\0\x20\0\x40\x03", 10);  // 32 rows of 64, 3 channels
  EXPECT_NE(bytes.find(frame), std::string::npos);
  EXPECT_LT(bytes.size(), image.pixels.size());
  image.channels = 4;
  EXPECT_THROW((void)encodeJpeg(image, 92), std::invalid_argument);
}

}  // namespace
}  // namespace macula::image
