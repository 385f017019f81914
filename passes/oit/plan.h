// What the transparency passes of one frame agree on.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "engine/frame/resource.h"
#include "engine/gl/program.h"
#include "passes/oit/methods.h"
#include "passes/oit/network_layout.h"
#include "passes/oit/settings.h"
#include "passes/oit/sync.h"

namespace macula::passes {

/// Bytes of one stored fragment: 32-bit depth, 32-bit id, premultiplied RGBA16F.
inline constexpr std::uint64_t kFragmentBytes = 16;
/// Bytes of a link of a list.
inline constexpr std::uint64_t kLinkBytes = 4;
/// Bytes of one pixel of the dense tail: sum of tau c, sum of tau.
inline constexpr std::uint64_t kDenseTailBytes = 16;

/// What follows from settings, size and machine.
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
  /// Transparency may be drawn at less than full rate: depth and colour are there for both.
  bool resizable = false;
  glm::ivec2 imageSize{0};    ///< samples of the image
  glm::ivec2 size{0};         ///< samples, or texels, at which this frame draws transparency
  bool historyValid = false;  ///< and what the last one left is of this size, without a cut

  /// This frame draws transparency at less than full rate, apart from the image.
  [[nodiscard]] bool resized() const { return resizable && size != imageSize; }
  /// Opaque depth at the samples of transparency.
  [[nodiscard]] frame::Resource depth() const {
    return resized() ? frame::Resource::ResizedDepth : frame::Resource::Depth;
  }
  /// What is drawn into: where it is resized, over nothing instead of the image.
  [[nodiscard]] frame::Resource color() const {
    return resized() ? frame::Resource::ResizedColor : frame::Resource::HdrColor;
  }
  /// What captured fragments are tested against.
  [[nodiscard]] frame::Resource testedDepth() const {
    return culls() ? frame::Resource::CullDepth : depth();
  }

  [[nodiscard]] bool sorted() const { return method->insertion == Insertion::Sorted; }
  /// Whether each pixel has a spin lock.
  [[nodiscard]] bool usesLocks() const { return sorted() && sync == SyncMode::Spinlock; }
  [[nodiscard]] bool hasTail() const { return options.tail == Tail::Mean; }
  /// The tail is a pixel's own last slot; else, for kb-atomic, a target of its own.
  [[nodiscard]] bool tailInSlot() const { return hasTail() && sorted(); }
  [[nodiscard]] bool denseTail() const { return hasTail() && !sorted(); }
  /// A pixel's slots become a tail when more fragments come than it has slots, because their number
  /// was not known before.
  [[nodiscard]] bool dynamicTail() const {
    return tailInSlot() && (method->allocation == Allocation::Constant || predictsCounts());
  }
  [[nodiscard]] bool predictsCounts() const { return options.count == CountSource::Predicted; }
  /// Fragments are 8-byte keys with their colour inside, so that colours need no array.
  [[nodiscard]] bool packed() const { return options.fragmentBytes == 8; }
  [[nodiscard]] std::uint64_t fragmentBytes() const {
    return static_cast<std::uint64_t>(options.fragmentBytes);
  }
  /// Slots that a tail takes: its sums need 16 bytes.
  [[nodiscard]] std::uint32_t tailSlots() const { return packed() ? 2U : 1U; }
  /// Slots are shared out by price (shaders/lib/bids.glsl), not by the published formula.
  [[nodiscard]] bool auctions() const {
    return method->counts() && method->hasBudget() &&
           (options.fill || options.importance != Predictor::Published || predictsCounts());
  }
  /// A map of importance is computed: that of Vasilakis 2017, or a network's.
  [[nodiscard]] bool mapsImportance() const {
    return method->allocation == Allocation::ImportanceMap &&
           options.importance == Predictor::Published;
  }
  /// A network says what pixels need.
  [[nodiscard]] bool usesNetwork() const {
    return method->learnsImportance() || options.importance == Predictor::Learned;
  }
  /// What a pixel bids by is what the network says.
  [[nodiscard]] bool learnsBids() const { return options.importance == Predictor::Learned; }
  [[nodiscard]] NetworkModel networkModel() const {
    return method->learnsImportance() ? NetworkModel::Thesis : NetworkModel::Learned;
  }
  /// The count pass gathers colours, too.
  [[nodiscard]] bool gathersColors() const { return method->learnsImportance(); }
  /// Whether the front-most normal is kept for the next frame's Fresnel factor.
  [[nodiscard]] bool keepsFrontNormal() const { return mapsImportance() && !usesNetwork(); }
  /// Depth slices are summed before the capture.
  [[nodiscard]] bool slices() const {
    return method->allocation == Allocation::ImportanceMap &&
           options.importance != Predictor::Published;
  }
  /// The tiles that transparency covers are listed, for passes whose work would be in vain
  /// elsewhere.
  [[nodiscard]] bool listsTiles() const { return usesNetwork() || slices(); }
  /// Samples a side of a listed tile. Without a network any will do: of 4 the price, which each
  /// thread works out, is shared by up to 16 pixels, and bids take three quarters of the time.
  [[nodiscard]] int listedTile() const { return usesNetwork() ? importance.networkTile : 4; }
  /// Where slots are shared out by.
  [[nodiscard]] frame::Resource countResource() const {
    return predictsCounts() ? frame::Resource::PredictedCount : frame::Resource::FragmentCount;
  }
  /// The nearest and farthest depth of each pixel are found with its count.
  [[nodiscard]] bool findsRange() const { return slices() || culls() || gathersColors(); }
  [[nodiscard]] bool culls() const { return options.cull == Cull::Occupancy; }
};

/// Slots and bytes for a budgeted method.
/// @param samples width times height of the frame in samples
/// @throws InputError where the budget holds no fragment
void planBudget(OitPlan& plan, std::uint64_t samples);

/// Slots a sample or texel where they are constant: what the pool gives those of this frame.
[[nodiscard]] std::uint32_t layersOf(const OitPlan& plan);

/// Defines that specialise the shaders of the plan's method.
[[nodiscard]] gl::Defines definesOf(const OitPlan& plan);
/// Defines for how fragments of one pixel take turns.
[[nodiscard]] gl::Defines syncDefines(const OitPlan& plan);

}  // namespace macula::passes
