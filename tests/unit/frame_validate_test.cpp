// The order of a frame is checked without GL.
#include "engine/frame/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace macula::frame {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<Resource> kShown{Resource::DisplayColor};

DeclaredPass pass(std::string_view name, std::vector<Touch> touches) {
  return {name, std::move(touches)};
}

TEST(Validate, AcceptsAChainThatEndsInAResult) {
  const std::vector<DeclaredPass> passes{
      pass("a", {{Resource::Normal, Use::ColorTarget, Access::Write}}),
      pass("b", {{Resource::Normal, Use::Texture, Access::Read},
                 {Resource::DisplayColor, Use::Image, Access::Write}})};
  EXPECT_THAT(validate(passes, kShown), IsEmpty());
}

TEST(Validate, RefusesAReadThatNobodyWrote) {
  const std::vector<DeclaredPass> passes{
      pass("b", {{Resource::Normal, Use::Texture, Access::Read}})};
  EXPECT_THAT(validate(passes, kShown),
              ElementsAre("pass 'b' reads normal, which no earlier pass writes"));
}

TEST(Validate, AcceptsAReadOfWhatIsClearedWhenUnwritten) {
  const std::vector<DeclaredPass> passes{
      pass("b", {{Resource::Depth, Use::Texture, Access::Read}})};
  EXPECT_THAT(validate(passes, kShown), IsEmpty());
}

TEST(Validate, RefusesAWriterThatNobodyReads) {
  const std::vector<DeclaredPass> passes{
      pass("a", {{Resource::Normal, Use::ColorTarget, Access::Write}})};
  EXPECT_THAT(validate(passes, kShown),
              ElementsAre("pass 'a' writes normal, which nobody reads afterwards"));
}

TEST(Validate, RefusesAResultThatIsOverwrittenUnread) {
  const std::vector<DeclaredPass> passes{
      pass("a", {{Resource::DisplayColor, Use::Image, Access::Write}}),
      pass("b", {{Resource::DisplayColor, Use::Image, Access::Write}})};
  EXPECT_THAT(validate(passes, kShown),
              ElementsAre("pass 'b' overwrites display colour of pass 'a', which nobody has read"));
}

TEST(Validate, RefusesDuplicates) {
  const Touch write{Resource::DisplayColor, Use::Image, Access::Write};
  const Touch modify{Resource::DisplayColor, Use::Image, Access::Modify};
  EXPECT_THAT(validate(std::vector{pass("a", {write}), pass("a", {modify})}, kShown),
              ElementsAre("pass 'a' stands twice in the frame"));
  EXPECT_THAT(validate(std::vector{pass("a", {write, write})}, kShown),
              testing::Contains(HasSubstr("declares display colour twice")));
}

TEST(Validate, RefusesHistoryThatIsAlreadyOverwritten) {
  const std::vector<DeclaredPass> passes{
      pass("writer", {{Resource::FrontNormal, Use::Image, Access::Write}}),
      pass("reader", {{Resource::FrontNormal, Use::Texture, Access::ReadHistory}})};
  EXPECT_THAT(validate(passes, kShown),
              testing::Contains(HasSubstr("pass 'writer' has already overwritten")));
}

}  // namespace
}  // namespace macula::frame
