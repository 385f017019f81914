// The order of a frame is checked without GL.
#include "engine/frame/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace macula::frame {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Resource kScratch{"scratch", GL_R32F, SizeRule::Display, ByteClass::Other,
                            Initial::Undefined};
constexpr Resource kCleared{"cleared", GL_R32F, SizeRule::Display, ByteClass::Other, Initial::Zero};
constexpr Resource kShown{"shown", GL_RGBA8, SizeRule::Output, ByteClass::Other,
                          Initial::Undefined};
constexpr Resource kList{"list", 0, SizeRule::Declared, ByteClass::Other, Initial::Undefined};

const std::vector<const Resource*> kResults{&kShown};

/// A pass whose table `rows` fills in.
template <typename Rows>
DeclaredPass pass(std::string_view name, Rows rows) {
  DeclaredPass declared{name, {}};
  rows(declared.table);
  return declared;
}

TEST(Validate, AcceptsAChainThatEndsInAResult) {
  const std::vector<DeclaredPass> passes{
      pass("a", [](PassDeclaration& d) { d.color(0, kScratch, Access::Write); }),
      pass("b", [](PassDeclaration& d) {
        d.texture(0, kScratch);
        d.image(0, kShown, Access::Write);
      })};
  EXPECT_THAT(validate(passes, kResults), IsEmpty());
}

TEST(Validate, RefusesAReadThatNoPassWrote) {
  const std::vector<DeclaredPass> passes{
      pass("b", [](PassDeclaration& d) { d.texture(0, kScratch); })};
  EXPECT_THAT(validate(passes, kResults),
              ElementsAre("pass 'b' reads scratch, which no earlier pass writes"));
}

TEST(Validate, FollowsTheStepsOfAPass) {
  const auto table = [](bool cleared) {
    return std::vector{pass("b", [cleared](PassDeclaration& d) {
      d.update(kScratch).when(cleared);
      d.step();
      d.image(0, kScratch, Access::ReadWrite);
      d.image(1, kShown, Access::Write);
      d.step();
      d.texture(0, kScratch);
    })};
  };
  EXPECT_THAT(validate(table(true), kResults), IsEmpty());
  EXPECT_THAT(validate(table(false), kResults),
              ElementsAre("pass 'b' reads scratch, which no earlier pass writes"))
      << "a row that rests writes nothing";
}

TEST(Validate, AcceptsAReadOfWhatIsClearedWhenUnwritten) {
  const std::vector<DeclaredPass> passes{
      pass("b", [](PassDeclaration& d) { d.texture(0, kCleared); })};
  EXPECT_THAT(validate(passes, kResults), IsEmpty());
}

TEST(Validate, RefusesAWriteThatNoPassReads) {
  const std::vector<DeclaredPass> passes{
      pass("a", [](PassDeclaration& d) { d.color(0, kScratch, Access::Write); })};
  EXPECT_THAT(validate(passes, kResults),
              ElementsAre("pass 'a' writes scratch, which no pass reads afterwards"));
}

TEST(Validate, RefusesAResultThatIsOverwrittenUnread) {
  const auto write = [](PassDeclaration& d) { d.image(0, kShown, Access::Write); };
  EXPECT_THAT(validate(std::vector{pass("a", write), pass("b", write)}, kResults),
              ElementsAre("pass 'b' overwrites shown of pass 'a', which no pass has read"));
}

TEST(Validate, RefusesDuplicates) {
  const auto write = [](PassDeclaration& d) { d.image(0, kShown, Access::ReadWrite); };
  EXPECT_THAT(validate(std::vector{pass("a", write), pass("a", write)}, kResults),
              Contains("pass 'a' stands twice in the frame"));
  const auto twice = [](PassDeclaration& d) {
    d.image(0, kShown, Access::Write);
    d.image(1, kShown, Access::Write);
  };
  EXPECT_THAT(validate(std::vector{pass("a", twice)}, kResults),
              Contains("pass 'a' declares shown twice in one step"));
  const auto crowded = [](PassDeclaration& d) {
    d.image(0, kShown, Access::Write);
    d.image(0, kCleared, Access::Read);
  };
  EXPECT_THAT(validate(std::vector{pass("a", crowded)}, kResults),
              Contains("pass 'a' binds shown and cleared at one unit"));
}

TEST(Validate, AcceptsAlternativesAtOneUnit) {
  const auto table = [](PassDeclaration& d) {
    d.texture(0, kCleared).when(true);
    d.texture(0, kScratch).when(false);
    d.image(0, kShown, Access::Write);
  };
  EXPECT_THAT(validate(std::vector{pass("a", table)}, kResults), IsEmpty());
}

TEST(Validate, RefusesHistoryThatIsAlreadyOverwritten) {
  const std::vector<DeclaredPass> passes{
      pass("writer", [](PassDeclaration& d) { d.image(0, kCleared, Access::Write); }),
      pass("reader", [](PassDeclaration& d) { d.texture(0, kCleared, Access::ReadHistory); })};
  EXPECT_THAT(validate(passes, kResults),
              Contains(HasSubstr("pass 'writer' has already overwritten")));
}

TEST(Validate, RefusesWhatIsInvalidated) {
  const std::vector<DeclaredPass> passes{
      pass("a", [](PassDeclaration& d) { d.image(0, kScratch, Access::Write); }),
      pass("b", [](PassDeclaration& d) { d.image(0, kScratch, Access::ReadInvalidate); }),
      pass("c", [](PassDeclaration& d) { d.texture(0, kScratch); })};
  EXPECT_THAT(validate(passes, kResults),
              ElementsAre("pass 'c' reads scratch, which no earlier pass writes"));
}

TEST(Validate, WantsOneSizeOfWhatIsDeclared) {
  const auto table = [](std::size_t bytes) {
    return [bytes](PassDeclaration& d) {
      d.storage(0, kList, Access::ReadWrite);
      if (bytes > 0) d.bytes(kList, bytes);
    };
  };
  const std::vector<const Resource*> results{&kList};
  EXPECT_THAT(validate(std::vector{pass("a", table(0))}, results),
              Contains("pass 'a' declares list, whose size no pass states"));
  EXPECT_THAT(validate(std::vector{pass("a", table(4)), pass("b", table(8))}, results),
              Contains("pass 'b' states another size of list than an earlier pass"));
}

TEST(Validate, RefusesABufferBoundAsATexture) {
  const auto table = [](PassDeclaration& d) {
    d.image(0, kList, Access::Write);
    d.bytes(kList, 4);
  };
  const std::vector<const Resource*> results{&kList};
  EXPECT_THAT(validate(std::vector{pass("a", table)}, results),
              ElementsAre("pass 'a' binds list as what it is not"));
}

}  // namespace
}  // namespace macula::frame
