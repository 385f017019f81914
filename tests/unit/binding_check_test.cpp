// What shaders bind against the table of their pass, without GL.
#include "engine/frame/binding_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace macula::frame {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Resource kFloats{"floats", GL_R32F, SizeRule::Display, ByteClass::Other, Initial::Zero};
constexpr Resource kWords{"words", GL_R32UI, SizeRule::Display, ByteClass::Other, Initial::Zero};
constexpr Resource kSampled{"sampled", GL_RGBA16F, SizeRule::DisplaySamples, ByteClass::Other,
                            Initial::Zero};
constexpr Resource kSums{"sums", 0, SizeRule::Declared, ByteClass::Other, Initial::Zero};

const ShaderBinding kReadsFloats{BindPoint::Texture, 8, GL_SAMPLER_2D, 0, "count"};
const ShaderBinding kStoresWords{BindPoint::Image, 0, GL_UNSIGNED_INT_IMAGE_2D, 0, "ranges"};
const ShaderBinding kAddsSums{BindPoint::Storage, 4, 0, 32, "Totals"};

using Programs = std::vector<std::vector<ShaderBinding>>;

PassDeclaration table() {
  PassDeclaration d;
  d.texture(8, kFloats);
  d.step();
  d.image(0, kWords, Access::Write);
  d.storage(4, kSums, Access::ReadWrite);
  d.bytes(kSums, 32);
  return d;
}

TEST(BindingCheck, AcceptsATableThatNamesWhatItsProgramsUse) {
  EXPECT_THAT(compareBindings("a", table(), Programs{{kReadsFloats}, {kStoresWords, kAddsSums}}),
              IsEmpty());
}

TEST(BindingCheck, FindsARowTooFew) {
  PassDeclaration d;
  d.texture(8, kFloats);
  EXPECT_THAT(
      compareBindings("a", d, Programs{{kReadsFloats, kStoresWords, kAddsSums}}),
      ElementsAre("pass 'a': a shader uses ranges at image unit 0, and no row binds it",
                  "pass 'a': a shader uses Totals at storage binding 4, and no row binds it"));
}

TEST(BindingCheck, FindsARowTooMany) {
  EXPECT_THAT(compareBindings("a", table(), Programs{{kStoresWords}, {kAddsSums}}),
              ElementsAre("pass 'a': floats is bound at texture unit 8, and no shader uses it"));
  PassDeclaration resting = table();
  resting.color(1, kFloats, Access::Write).when(false);
  EXPECT_THAT(compareBindings("a", resting, Programs{{kReadsFloats, kStoresWords, kAddsSums}}),
              ElementsAre("pass 'a': floats is bound at output 1, and no shader uses it"))
      << "a row that rests in this frame counts";
}

TEST(BindingCheck, FindsTheWrongUnit) {
  ShaderBinding moved = kReadsFloats;
  moved.unit = 9;
  EXPECT_THAT(compareBindings("a", table(), Programs{{moved, kStoresWords, kAddsSums}}),
              ElementsAre("pass 'a': a shader uses count at texture unit 9, and no row binds it",
                          "pass 'a': floats is bound at texture unit 8, and no shader uses it"));
}

TEST(BindingCheck, FindsTheWrongKind) {
  const auto problems = [](const Resource& r, GLenum type) {
    PassDeclaration d;
    d.texture(8, r);
    return compareBindings("a", d, Programs{{{BindPoint::Texture, 8, type, 0, "input"}}});
  };
  EXPECT_THAT(problems(kFloats, GL_SAMPLER_2D), IsEmpty());
  EXPECT_THAT(problems(kWords, GL_UNSIGNED_INT_SAMPLER_2D), IsEmpty());
  EXPECT_THAT(problems(kSampled, GL_SAMPLER_2D_MULTISAMPLE), IsEmpty());
  EXPECT_THAT(problems(kFloats, GL_UNSIGNED_INT_SAMPLER_2D),
              ElementsAre("pass 'a': floats at texture unit 8 is not what input takes it for",
                          "pass 'a': floats is bound at texture unit 8, and no shader uses it"));
  EXPECT_THAT(problems(kSampled, GL_SAMPLER_2D), testing::SizeIs(2));
  EXPECT_THAT(problems(kFloats, GL_SAMPLER_CUBE), testing::SizeIs(2));
}

TEST(BindingCheck, AcceptsAlternativesOfWhichEachHasItsProgram) {
  PassDeclaration d;
  d.image(0, kWords, Access::Write).when(true);
  d.image(0, kFloats, Access::Write).when(false);
  const ShaderBinding floats{BindPoint::Image, 0, GL_IMAGE_2D, 0, "target"};
  EXPECT_THAT(compareBindings("a", d, Programs{{kStoresWords}, {floats}}), IsEmpty());
  EXPECT_THAT(compareBindings("a", d, Programs{{kStoresWords}}),
              ElementsAre("pass 'a': floats is bound at image unit 0, and no shader uses it"));
}

TEST(BindingCheck, FindsABufferThatIsTooSmall) {
  ShaderBinding large = kAddsSums;
  large.bytes = 64;
  EXPECT_THAT(compareBindings("a", table(), Programs{{kReadsFloats, kStoresWords, large}}),
              ElementsAre("pass 'a': sums has 32 bytes and block Totals needs 64"));
}

}  // namespace
}  // namespace macula::frame
