// Which options of transparency go together, and the messages about those that do not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "oit_combinations.h"
#include "passes/oit/settings.h"

namespace macula::passes {
namespace {

struct Refused {
  OitSettings settings;
  std::string_view place;   ///< the setting that is named
  std::string_view reason;  ///< part of the text
};

const std::vector<Refused>& refused() {
  static const std::vector<Refused> kRefused{
      {{.method = "ab-sbuffer", .tail = Tail::Mean}, "oit.tail:", "leaves nothing out in order"},
      {{.method = "ab-list", .tail = Tail::Mean}, "oit.tail:", "use a k-buffer"},
      {{.method = "peel", .tail = Tail::Mean}, "oit.tail:", "use a k-buffer"},
      {{.method = "wboit", .tail = Tail::Mean}, "oit.tail:", "use a k-buffer"},
      {{.method = "kb-stencil", .tail = Tail::Mean}, "oit.tail:", "rejected by the stencil test"},
      {{.tail = Tail::Mean, .cull = Cull::Occupancy}, "oit.cull:", "never reach the tail"},
      {{.method = "kb-fixed", .importance = Predictor::Error}, "oit.importance:", "the same k"},
      {{.method = "kb-plus", .importance = Predictor::Transmittance}, "oit.importance:", "kb-plus"},
      {{.method = "kb-fixed", .fill = true, .tail = Tail::Mean, .importance = Predictor::Learned},
       "oit.importance:",
       "the same k"},
      {{.importance = Predictor::Learned}, "oit.importance:", "add --oit.fill on --oit.tail mean"},
      {{.fill = true, .importance = Predictor::Learned}, "oit.importance:", "before a tail"},
      {{.tail = Tail::Mean, .importance = Predictor::Learned},
       "oit.importance:",
       "budget that is filled"},
      {{.method = "kb-learned", .importance = Predictor::Transmittance},
       "oit.importance:",
       "kb-learned takes importance from the thesis's network"},
      {{.method = "kb-learned", .importance = Predictor::Error},
       "oit.importance:",
       "use kb-variable for others"},
      {{.method = "kb-learned", .fill = true, .tail = Tail::Mean, .importance = Predictor::Learned},
       "oit.importance:",
       "use kb-variable for others"},
      {{.method = "kb-learned", .tail = Tail::Mean, .cull = Cull::Occupancy},
       "oit.cull:",
       "never reach the tail"},
      {{.method = "kb-fixed", .fill = true}, "oit.fill:", "no budget that pixels share"},
      {{.method = "kb-atomic", .fill = true}, "oit.fill:", "use kb-variable or kb-plus"},
      {{.method = "ab-array", .fill = true}, "oit.fill:", "ab-array"},
      {{.method = "kb-plus", .tail = Tail::Mean, .count = CountSource::Predicted},
       "oit.count:",
       "only kb-variable"},
      {{.tail = Tail::Mean, .importance = Predictor::Error, .count = CountSource::Predicted},
       "oit.count:",
       "depth slices"},
      {{.fill = true,
        .tail = Tail::Mean,
        .importance = Predictor::Learned,
        .count = CountSource::Predicted},
       "oit.count:",
       "depth slices"},
      {{.method = "kb-learned", .count = CountSource::Predicted},
       "oit.count:",
       "the network of kb-learned reads what a count pass sums; use --oit.count drawn"},
      {{.tail = Tail::Mean, .fragmentBytes = 8, .count = CountSource::Predicted},
       "oit.count:",
       "16 bytes"},
      {{.cull = Cull::Occupancy, .count = CountSource::Predicted}, "oit.count:", "culling needs"},
      {{.method = "kb-racy", .sync = "spinlock"},
       "oit.sync:",
       "kb-fixed without per-pixel ordering"},
      {{.method = "kb-atomic", .sync = "spinlock"}, "oit.sync:", "need no per-pixel ordering"},
      {{.method = "kb-stencil", .sync = "ordered"}, "oit.sync:", "need no per-pixel ordering"},
      {{.method = "blend", .sync = "ordered"}, "oit.sync:", "need no per-pixel ordering"},
      {{.method = "peel", .sync = "none"}, "oit.sync:", "need no per-pixel ordering"},
      {{.method = "ab-sbuffer", .sync = "none"}, "oit.sync:", "atomic counters"},
      {{.method = "ab-list", .sync = "none"}, "oit.sync:", "atomic counters"},
      {{.method = "ab-sbuffer", .cull = Cull::Occupancy}, "oit.cull:", "use a k-buffer"},
      {{.method = "peel", .cull = Cull::Occupancy}, "oit.cull:", "use a k-buffer"},
      {{.method = "kb-atomic", .fragmentBytes = 8}, "oit.fragmentBytes:", "sorted k-buffer"},
      {{.method = "kb-stencil", .fragmentBytes = 8}, "oit.fragmentBytes:", "sorted k-buffer"},
      {{.method = "ab-sbuffer", .fragmentBytes = 8}, "oit.fragmentBytes:", "sorted k-buffer"},
  };
  return kRefused;
}

TEST(Combinations, RefusedOnesSayWhy) {
  for (const Refused& row : refused()) {
    try {
      checkCombination(row.settings);
      ADD_FAILURE() << "accepted: " << test::combinationName(row.settings) << ", " << row.reason;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(std::string(row.place)));
      EXPECT_THAT(error.what(), testing::HasSubstr(std::string(row.reason)));
    }
  }
}

TEST(Combinations, AcceptedOnesPass) {
  const std::vector<OitSettings> accepted{
      {},
      {.method = "blend"},
      {.method = "wboit"},
      {.method = "peel"},
      {.method = "ab-array", .sync = "spinlock"},
      {.method = "ab-list", .sync = "ordered"},
      {.method = "ab-sbuffer", .sync = "interlock"},
      {.method = "kb-racy", .sync = "none"},
      {.method = "kb-racy", .tail = Tail::Mean, .fragmentBytes = 8},
      {.method = "kb-stencil", .cull = Cull::Occupancy},
      {.method = "kb-atomic", .tail = Tail::Mean},
      {.method = "kb-fixed", .sync = "none", .tail = Tail::Mean, .fragmentBytes = 8},
      {.method = "kb-fixed", .cull = Cull::Occupancy},
      {.method = "kb-plus", .fill = true, .tail = Tail::Mean},
      {.fill = true, .importance = Predictor::Error, .fragmentBytes = 8},
      {.fill = true, .tail = Tail::Mean, .importance = Predictor::Transmittance},
      {.tail = Tail::Mean, .count = CountSource::Predicted},
      {.count = CountSource::Predicted},
      {.fill = true, .tail = Tail::Mean, .importance = Predictor::Learned},
      {.fill = true, .tail = Tail::Mean, .importance = Predictor::Learned, .fragmentBytes = 8},
      {.method = "kb-learned", .fill = true, .tail = Tail::Mean, .fragmentBytes = 8},
      {.method = "kb-learned", .sync = "none", .cull = Cull::Occupancy},
  };
  for (const OitSettings& settings : accepted) {
    EXPECT_NO_THROW(checkCombination(settings)) << test::combinationName(settings);
  }
}

TEST(Combinations, EveryMethodTakesItsDefaults) {
  for (const Method& method : methods()) {
    EXPECT_NO_THROW(checkCombination({.method = std::string(method.id)})) << method.id;
  }
}

}  // namespace
}  // namespace macula::passes
