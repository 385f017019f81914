// What the transparency passes of one frame agree on.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/gl/program.h"
#include "passes/oit/learned/network_layout.h"
#include "passes/oit/methods.h"
#include "passes/oit/ordering.h"
#include "passes/oit/resources.h"
#include "passes/oit/settings.h"

namespace macula::passes {

/// Bytes of a link of a list.
inline constexpr std::uint64_t kLinkBytes = 4;

/// What follows from settings, size and device. The predicates hold for settings that
/// checkCombination() accepts; where one implies another, its comment says so, and a unit test
/// checks it for every accepted combination.
struct OitPlan {
  const Method* method = nullptr;
  SyncMode sync = SyncMode::Spinlock;
  OitSettings options = {};
  std::uint32_t slots = 1;                        ///< of the fragment pool that this frame may use
  std::uint32_t poolSlots = 1;                    ///< of the fragment pool
  std::uint32_t layers = 1;                       ///< slots a pixel where they are constant
  std::optional<std::uint64_t> budgetBytes = {};  ///< null for methods without a budget
  ImportanceSettings importance = {};
  const network::Network* network = nullptr;  ///< where one is used
  float layerLimit = 1.0F;                    ///< N_limit in use
  std::uint32_t seed = 1;
  bool factorMaps = false;          ///< importance factors are shown
  std::uint32_t largestLayers = 0;  ///< largest k(p) of the last frame
  /// Transparency may be drawn at a reduced rate: depth and colour are there for both.
  bool resizable = false;
  glm::ivec2 imageSize{0};    ///< samples of the image
  glm::ivec2 size{0};         ///< samples, or texels, at which this frame draws transparency
  bool historyValid = false;  ///< what the last frame left is of this size, without a cut

  /// This frame draws transparency at a reduced rate, into a buffer of its own. Implies resizable.
  [[nodiscard]] bool reduced() const { return resizable && size != imageSize; }
  /// Samples of the image a texel of transparency, per axis; 1 at full rate.
  [[nodiscard]] glm::vec2 pitch() const { return glm::vec2(imageSize) / glm::vec2(size); }

  // Storage and per-pixel ordering
  /// Fragments are kept nearest first, under per-pixel ordering.
  [[nodiscard]] bool sorted() const { return method->sorts(); }
  /// Each pixel has a spin lock. Implies sorted().
  [[nodiscard]] bool usesLocks() const { return sorted() && sync == SyncMode::Spinlock; }
  /// Fragments are 8-byte keys with their colour inside, so that colours need no array. Implies
  /// sorted().
  [[nodiscard]] bool packed() const { return options.fragmentBytes == 8; }
  [[nodiscard]] std::uint64_t fragmentBytes() const {
    return static_cast<std::uint64_t>(options.fragmentBytes);
  }

  // Tails
  /// Fragments that get no slot are merged into one layer. Implies method->hasBudget(), and exactly
  /// one of tailInSlot() and denseTail().
  [[nodiscard]] bool hasTail() const { return options.tail == Tail::Mean; }
  /// The tail is a pixel's own last slot. Implies sorted().
  [[nodiscard]] bool tailInSlot() const { return hasTail() && sorted(); }
  /// The tail is a target of its own, for methods whose keys stand before colours are known.
  [[nodiscard]] bool denseTail() const { return hasTail() && !sorted(); }
  /// A pixel's slots become a tail when more fragments come than it has slots, because their number
  /// was not known before. Implies tailInSlot().
  [[nodiscard]] bool dynamicTail() const {
    return tailInSlot() && (method->allocation.constant || predictsCounts());
  }
  /// The allocation empties tails, because it knows which pixels have one. Implies tailInSlot().
  [[nodiscard]] bool emptiesTails() const { return tailInSlot() && !dynamicTail(); }
  /// Slots that a tail takes: its sums need 16 bytes.
  [[nodiscard]] std::uint32_t tailSlots() const { return packed() ? 2U : 1U; }

  // Allocation
  /// Counts are reprojected from the last frame. Implies mapsImportance() and sharesByUtility(),
  /// and excludes culls(), packed() and usesNetwork().
  [[nodiscard]] bool predictsCounts() const { return options.count == CountSource::Predicted; }
  /// Slots go where their marginal utility is largest (utility/), not by a published formula.
  /// Implies method->sharesBudget().
  [[nodiscard]] bool sharesByUtility() const {
    return method->sharesBudget() &&
           (options.fill || options.importance != Predictor::Published || predictsCounts());
  }
  /// A map of importance is computed: that of Vasilakis 2017, or a network's. Implies
  /// method->followsImportance(), and excludes slices().
  [[nodiscard]] bool mapsImportance() const {
    return method->followsImportance() && options.importance == Predictor::Published;
  }
  /// The normal of the nearest fragment is persistent, for the next frame's Fresnel factor. Implies
  /// mapsImportance(), and excludes usesNetwork().
  [[nodiscard]] bool keepsFrontNormal() const { return mapsImportance() && !usesNetwork(); }
  /// Depth slices are summed before the capture. Implies sharesByUtility(), findsRange() and
  /// listsTiles().
  [[nodiscard]] bool slices() const {
    return method->followsImportance() && options.importance != Predictor::Published;
  }

  // Networks
  /// A network is evaluated. Implies listsTiles(), and exactly one of learnsUtility() and
  /// gathersColors().
  [[nodiscard]] bool usesNetwork() const { return gathersColors() || learnsUtility(); }
  /// The network corrects the predicted utility of slots. Implies slices() and tailInSlot().
  [[nodiscard]] bool learnsUtility() const { return options.importance == Predictor::Learned; }
  /// The count pass sums colours for the thesis's network. Implies mapsImportance() and
  /// findsRange().
  [[nodiscard]] bool gathersColors() const { return method->learnsImportance(); }
  [[nodiscard]] NetworkModel networkModel() const {
    return gathersColors() ? NetworkModel::Thesis : NetworkModel::Learned;
  }

  /// The tiles that transparency covers are listed, for passes whose work per tile is expensive.
  [[nodiscard]] bool listsTiles() const { return usesNetwork() || slices(); }
  /// Samples a side of a listed tile. Without a network any will do: with 4 each thread, which
  /// works out the Lagrange multiplier, serves up to 16 pixels, and demand takes three quarters of
  /// the time.
  [[nodiscard]] int listedTile() const { return usesNetwork() ? importance.networkTile : 4; }
  /// The number of a pixel's fragments by which slots are shared.
  [[nodiscard]] const frame::Resource& countResource() const {
    return predictsCounts() ? kPredictedCount : kFragmentCount;
  }
  /// The nearest and farthest depth of each pixel are found with its count.
  [[nodiscard]] bool findsRange() const { return slices() || culls() || gathersColors(); }
  /// Fragments are counted for the report, after the frame's time has been taken, because the
  /// method counts none or predicts them.
  [[nodiscard]] bool countsForReport() const {
    return method->insertion.counted && (!method->counts() || predictsCounts());
  }
  /// Fragments behind the k-th occupied depth interval are rejected early. Implies findsRange() and
  /// method->hasBudget(), and excludes hasTail().
  [[nodiscard]] bool culls() const { return options.cull == Cull::Occupancy; }
};

/// What a plan is made from.
struct PlanInputs {
  const OitSettings& settings;
  const gl::Capabilities& device;
  const OrderedCheck& ordered;
  std::uint64_t samples;  ///< width times height of the frame in samples
};

/// Sets method, options, per-pixel ordering, slots and budget. A pool that grew stays for as long
/// as its method does.
/// @throws InputError where the device or the budget cannot do what is asked for
void planMethod(OitPlan& plan, const PlanInputs& in);

/// Sets the network, and how many depth slices it reads.
/// @throws InputError where its file is not a network for the plan's method
void planNetwork(OitPlan& plan, LoadedNetwork& loaded);

/// Slots of one frame, once its size is known.
/// @param share of the budget's slots that a quality control leaves it, above 0, up to 1
void planFrameSlots(OitPlan& plan, float share);

/// Defines that specialise the resolve for the plan's method; also part of those of the capture.
[[nodiscard]] gl::Defines definesOf(const OitPlan& plan);
/// Defines and extensions of the capture, without those of the lighting.
[[nodiscard]] gl::Defines captureDefines(const OitPlan& plan);
[[nodiscard]] std::vector<std::string> captureExtensions(const OitPlan& plan);

}  // namespace macula::passes
