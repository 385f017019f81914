// Files: the container, the URIs, the shared real and malformed ones.
#include "engine/scene/gltf_loader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/core/file.h"
#include "engine/scene/gltf_uri.h"
#include "engine/scene/scene_info.h"
#include "tests/unit/gltf_builder.h"

namespace macula::scene {
namespace {

namespace fs = std::filesystem;
using test::errorOf;
using test::GltfBuilder;
using test::warns;

const fs::path kData = fs::path(MACULA_SOURCE_DIR) / ".." / "shared" / "data";

#define SKIP_WITHOUT(path)                                             \
  if (!fs::exists(path)) {                                             \
    GTEST_SKIP() << (path).string() << " is absent; nothing compared"; \
  }

std::string messageOfText(const std::string& file) {
  return errorOf([&] { return GltfBuilder::loadText(file); });
}

// A folder of its own for each test, removed afterwards.
class GltfFiles : public ::testing::Test {
 protected:
  GltfFiles()
      : folder_(fs::temp_directory_path() /
                (std::string("macula-gltf-") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~GltfFiles() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  fs::path folder_;
};

TEST(GltfUri, PercentDecodingFollowsRfc3986) {
  EXPECT_EQ(gltf::percentDecode("a%20b%2Fc"), "a b/c");
  EXPECT_EQ(gltf::percentDecode("%"), "%");
  EXPECT_EQ(gltf::percentDecode("%4"), "%4");
  EXPECT_EQ(gltf::percentDecode("%zz"), "%zz");
  EXPECT_EQ(gltf::percentDecode("%41"), "A");
}

TEST(GltfUri, Base64FollowsRfc4648) {
  const auto text = [](std::string_view encoded) {
    const std::vector<std::byte> bytes = gltf::base64Decode(encoded).value();
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  // The test vectors of RFC 4648, section 10.
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("Zg=="), "f");
  EXPECT_EQ(text("Zm8="), "fo");
  EXPECT_EQ(text("Zm9v"), "foo");
  EXPECT_EQ(text("Zm9vYmE="), "fooba");
  EXPECT_EQ(text("Zm9vYmFy"), "foobar");
  EXPECT_EQ(text("Zm8"), "fo");
  EXPECT_FALSE(gltf::base64Decode("Zm9`").has_value());
}

TEST_F(GltfFiles, UnreadableFilesAreNamed) {
  EXPECT_SAYS(errorOf([&] { return loadGltf(folder_ / "none.glb"); }), "none.glb: no such file");
  EXPECT_SAYS(errorOf([&] { return loadGltf(folder_); }), "is a folder");
  EXPECT_SAYS(errorOf([&] { return loadGltf(write("empty.glb", "")); }),
              "empty.glb: the file is empty");
  EXPECT_SAYS(errorOf([&] { return loadGltf(write("image.glb", "\x89PNG\r\n\x1a\n")); }),
              "image.glb: is neither a .glb nor");
  EXPECT_SAYS(errorOf([&] { return loadGltf("/dev/null"); }), "no regular file");
}

TEST_F(GltfFiles, ContentDecidesNotTheName) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  EXPECT_EQ(loadGltf(write("binary.gltf", builder.glb())).instances.size(), 1U);
  EXPECT_EQ(loadGltf(write("text.glb", R"({"asset":{"version":"2.0"}})")).instances.size(), 0U);
  EXPECT_EQ(loadGltf(folder_ / "binary.gltf").name, "binary");
}

TEST_F(GltfFiles, ExternalBuffersAreFoundByDecodedUri) {
  const std::string text = R"({"asset":{"version":"2.0"},
    "buffers":[{"uri":"my%20points.bin","byteLength":36}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]})";
  const fs::path file = write("a.gltf", text);
  EXPECT_SAYS(errorOf([&] { return loadGltf(file); }), "my%20points.bin' is missing");
  static_cast<void>(write("my points.bin", std::string(35, '\0')));
  EXPECT_SAYS(errorOf([&] { return loadGltf(file); }),
              "buffer 0: has 35 bytes where byteLength asks for 36");
  static_cast<void>(write("my points.bin", std::string(36, '\0')));
  EXPECT_EQ(describe(loadGltf(file)).triangles, 1U);
  EXPECT_SAYS(messageOfText(text), "embed it");
}

TEST(GltfContainer, MalformedBinariesAreRefused) {
  const auto u32 = GltfBuilder::u32;
  EXPECT_SAYS(messageOfText("glTF"), "inside its header");
  EXPECT_SAYS(messageOfText("glTF" + u32(1) + u32(12)), "container version 1");
  EXPECT_SAYS(messageOfText("glTF" + u32(2) + u32(400)), "says 400 bytes and 12 are there");
  EXPECT_SAYS(messageOfText("glTF" + u32(2) + u32(20) + u32(4) + u32(0x4E4F534A)),
              "chunk of 4 bytes has only 0");
  EXPECT_SAYS(messageOfText("glTF" + u32(2) + u32(20) + u32(0) + u32(0x4E4F534A)), "no object");
  EXPECT_SAYS(messageOfText("{\"asset\":"), "JSON cannot be read");
  EXPECT_SAYS(messageOfText(R"({"asset":{"version":"1.0"}})"), "convert the file");
  EXPECT_SAYS(messageOfText(std::string(100000, '[')), "neither");
  const std::string deep = "{\"a\":" + std::string(100000, '[');
  EXPECT_SAYS(messageOfText(deep), "JSON cannot be read");
  EXPECT_SAYS(messageOfText(deep + std::string(100000, ']') + "}"), "nested more than 256 deep");
  EXPECT_EQ(messageOfText(R"({"asset":{"version":"2.0"},"a":)" + std::string(255, '[') +
                          std::string(255, ']') + "}"),
            "");
}

TEST(GltfContainer, BuffersDoNotCopyTheBinaryChunk) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  builder.binary.resize(std::size_t{1} << 20U);
  // 20,000 buffers of 1 MiB: copies would take 20 GiB.
  for (int i = 0; i < 20'000; ++i) {
    builder.root["buffers"].push_back({{"byteLength", builder.binary.size()}});
  }
  std::string text = builder.root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string chunks =
      GltfBuilder::chunk(0x4E4F534A, text) + GltfBuilder::chunk(0x004E4942, builder.binary);
  const Scene scene = GltfBuilder::loadText("glTF" + GltfBuilder::u32(2) +
                                            GltfBuilder::u32(12 + chunks.size()) + chunks);
  EXPECT_EQ(describe(scene).triangles, 1U);
}

TEST(GltfContainer, RequiredExtensionsMustBeKnown) {
  GltfBuilder builder;
  builder.root["extensionsUsed"] = {"KHR_materials_unlit", "VENDOR_paint"};
  builder.root["extensionsRequired"] = {"KHR_materials_unlit"};
  const Scene scene = builder.load();
  EXPECT_EQ(scene.unsupportedExtensions, std::vector<std::string>{"VENDOR_paint"});
  builder.root["extensionsRequired"] = {"KHR_materials_unlit", "VENDOR_paint"};
  EXPECT_SAYS(messageOfText(builder.glb()), "test: requires VENDOR_paint, which");
}

TEST(GltfData, CountsAreThoseOfTheManifest) {
  SKIP_WITHOUT(kData / "gltf");
  const SceneInfo tokyo = describe(loadGltf(kData / "gltf/LittlestTokyo.glb"));
  EXPECT_EQ(tokyo.triangles, 141802U);
  EXPECT_EQ(tokyo.draws, 71U);
  EXPECT_EQ(tokyo.blendTriangles, 567U);
  EXPECT_EQ(tokyo.maskTriangles, 6741U);
  EXPECT_EQ(tokyo.textures, 4);

  const SceneInfo dish = describe(loadGltf(kData / "gltf/IridescentDishWithOlives.glb"));
  EXPECT_EQ(dish.triangles, 24448U);
  EXPECT_EQ(dish.transmissionTriangles, 5632U);
  EXPECT_EQ(dish.transparentTriangles, 5632U);
  EXPECT_EQ(dish.maskTriangles, 1536U);
  EXPECT_EQ(dish.textures, 11);

  const SceneInfo coats = describe(loadGltf(kData / "gltf/ClearcoatTest.glb"));
  EXPECT_EQ(coats.triangles, 37116U);
  EXPECT_EQ(coats.blendTriangles, 2060U);
  EXPECT_EQ(coats.unsupportedExtensions, std::vector<std::string>{"KHR_materials_clearcoat"});

  const Scene lamp = loadGltf(kData / "gltf/AnisotropyBarnLamp/AnisotropyBarnLamp.gltf");
  EXPECT_EQ(describe(lamp).triangles, 10203U);
  EXPECT_EQ(describe(lamp).transmissionTriangles, 1504U);
  EXPECT_TRUE(warns(lamp, "normalbump.ktx2"));

  EXPECT_EQ(describe(loadGltf(kData / "gltf/many-cubes-in-gltf/many-cubes.gltf")).draws, 501U);
}

TEST(GltfData, SkinnedFilesStandUpright) {
  SKIP_WITHOUT(kData / "gltf");
  // The rest pose of the fox is 79 units tall and 155 long; unskinned data lie otherwise.
  const Bounds fox = boundsOf(loadGltf(kData / "gltf/Fox/Fox.glb"));
  EXPECT_NEAR(fox.max.y - fox.min.y, 79.0F, 1.0F);
  EXPECT_NEAR(fox.max.z - fox.min.z, 154.7F, 1.0F);
}

TEST(GltfData, EveryFileLoadsOrSaysWhyNot) {
  SKIP_WITHOUT(kData / "gltf");
  int seen = 0;
  int refused = 0;
  for (const char* folder : {"gltf", "gltf-bad"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kData / folder)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
      const std::string message = errorOf([&] { return loadGltf(file); });
      ++seen;
      if (message.empty()) continue;
      ++refused;
      EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_NE(message.find("; "), std::string::npos) << "no fix: " << message;
    }
  }
  EXPECT_GE(seen, 60);
  EXPECT_GE(refused, 20);
}

TEST(GltfData, RequiredExtensionOfARealFileIsNamed) {
  SKIP_WITHOUT(kData / "gltf");
  EXPECT_SAYS(errorOf([&] { return loadGltf(kData / "gltf/ACMEBox-in-gltf/ACMEBox.gltf"); }),
              "ACME_gizmo");
}

TEST(GltfData, TruncatedBinariesAreRefusedEverywhere) {
  const fs::path file = kData / "gltf/Fox/Fox.glb";
  SKIP_WITHOUT(file);
  const std::string bytes = readTextFile(file);
  for (const std::size_t size :
       {std::size_t{1}, std::size_t{4}, std::size_t{11}, std::size_t{12}, std::size_t{19},
        std::size_t{20}, std::size_t{1000}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_FALSE(messageOfText(bytes.substr(0, size)).empty()) << "cut to " << size;
  }
  // The same with the header made to agree, so that what is behind it is looked at.
  for (std::size_t size = 13; size < bytes.size(); size += 997) {
    const std::string cut =
        bytes.substr(0, 8) + GltfBuilder::u32(size) + bytes.substr(12, size - 12);
    EXPECT_FALSE(messageOfText(cut).empty()) << "cut to " << size;
  }
}

}  // namespace
}  // namespace macula::scene
