// FrameRenderer: what follows from settings, size and machine before a frame is drawn.
#include <algorithm>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "passes/frame_renderer.h"
#include "passes/oit/oit_pass.h"
#include "shared/lod_totals.h"
#include "shared/network.h"

namespace macula::passes {

using frame::Resource;

namespace {

/// First size of an exact method's pool, in slots a sample; it grows to what the frames need.
constexpr std::uint64_t kFirstSlotsPerSample = 2;

SyncMode syncByName(const std::string& name) {
  for (const SyncMode mode :
       {SyncMode::Interlock, SyncMode::Spinlock, SyncMode::Ordered, SyncMode::None}) {
    if (name == nameOf(mode)) return mode;
  }
  return SyncMode::Auto;
}

}  // namespace

void FrameRenderer::sizePool(std::uint32_t slots) {
  plan_.slots = plan_.poolSlots = std::max(1U, slots);
  // 16-byte fragments keep key and colour apart; packed ones are all key.
  resources_.setBufferBytes(Resource::FragmentKeys, plan_.slots * kFragmentBytes / 2);
  resources_.setBufferBytes(Resource::FragmentColors, plan_.slots * kFragmentBytes / 2);
  resources_.setBufferBytes(Resource::FragmentLinks, plan_.slots * kLinkBytes);
}

void FrameRenderer::planRoutedSamples() {
  // Bytes are promised, so only numbers of samples that the GPU really makes are used.
  int best = 0;
  int least = 0;
  for (const int samples : machine_.capabilities.routableSamples) {
    if (samples <= static_cast<int>(plan_.layers)) best = std::max(best, samples);
    if (least == 0 || samples < least) least = samples;
  }
  if (best == 0) {
    failInput(
        "kb-stencil keeps a fragment in each sample, and {} has {} a pixel at the least; "
        "the budget gives {}; raise --k-ave or --oit-memory, or use kb-fixed",
        machine_.capabilities.renderer, counted(static_cast<std::uint64_t>(least), "sample"),
        plan_.layers);
  }
  plan_.layers = static_cast<std::uint32_t>(best);
  resources_.setMultisamples(best);
}

void FrameRenderer::planMethod(std::uint64_t samples) {
  const Method* before = plan_.method;
  plan_.method = &methodById(settings_.oit.method);
  plan_.options = settings_.oit;
  plan_.layers = static_cast<std::uint32_t>(settings_.oit.layers);
  const SyncMode wish = syncByName(settings_.oit.sync);
  plan_.sync = plan_.method->isRacy() ? SyncMode::None
                                      : chooseSync(wish, machine_.capabilities, machine_.ordered);
  plan_.budgetBytes.reset();
  constexpr double kMebi = 1024.0 * 1024.0;
  if (plan_.method->hasBudget()) {
    planBudget(plan_, samples);
    if (plan_.method->insertion == Insertion::StencilRouted) planRoutedSamples();
    sizePool(plan_.slots);
  } else if (plan_.method->grows() && settings_.oit.memoryMiB > 0.0) {
    // A cap instead of growth: what does not fit is counted, and the frame is flagged inexact.
    const std::uint64_t each =
        kFragmentBytes + (plan_.method->insertion == Insertion::Linked ? kLinkBytes : 0);
    plan_.budgetBytes = static_cast<std::uint64_t>(settings_.oit.memoryMiB * kMebi);
    if (*plan_.budgetBytes < each) {
      failInput("--oit-memory of {} holds no fragment ({} bytes each); raise it, or 0",
                counted(*plan_.budgetBytes, "byte"), each);
    }
    sizePool(static_cast<std::uint32_t>(*plan_.budgetBytes / each));
  } else if (plan_.method->allocation == Allocation::Constant) {
    const std::uint64_t slots = plan_.layers * samples;
    if (slots > std::numeric_limits<std::uint32_t>::max()) {
      failInput(
          "{} for each of {} are more than can be addressed; lower "
          "--oit.layers or --size",
          counted(plan_.layers, "slot"), counted(samples, "sample"));
    }
    sizePool(static_cast<std::uint32_t>(slots));
  } else if (before != plan_.method || plan_.slots < samples * kFirstSlotsPerSample) {
    sizePool(static_cast<std::uint32_t>(samples * kFirstSlotsPerSample));
  }
}

void FrameRenderer::planNetwork() {
  plan_.network = nullptr;
  if (!plan_.usesNetwork()) return;
  if (plan_.learnsBids()) plan_.importance.slices = LEARNED_SLICES;
  const NetworkModel model = plan_.networkModel();
  const std::filesystem::path& chosen = settings_.oit.network;
  const std::filesystem::path file = chosen.empty() ? defaultNetworkFile(model) : chosen;
  if (!network_ || file != networkFile_ || network_->model != nameOf(model)) {
    network_ = readNetworkOf(model, file);
    networkFile_ = file;
  }
  plan_.network = &*network_;
  const glm::ivec2 size = inputs_.displaySize;
  const int tile = plan_.importance.networkTile;
  resources_.setFixedSize(Resource::NetworkOutput, (size + tile - 1) / tile);
}

void FrameRenderer::planTransparency() {
  plan_.size = lod_.transparencySize();
  plan_.historyValid = inputs_.historyValid && plan_.size == lastTransparencySize_;
  const Method& method = *plan_.method;
  // Of kb-stencil, whose slots are samples of the target, those not used lie idle.
  if (!method.hasBudget() || method.insertion == Insertion::StencilRouted) return;
  const auto share = static_cast<double>(inputs_.levers.layerShare);
  plan_.slots = std::max(1U, static_cast<std::uint32_t>(share * plan_.poolSlots));
  if (method.allocation != Allocation::Constant) return;
  // The same slots for the texels there are; one each, or what a tail takes, is the least.
  const std::uint32_t least = static_cast<std::uint32_t>(plan_.size.x) *
                              static_cast<std::uint32_t>(plan_.size.y) *
                              (plan_.tailInSlot() ? plan_.tailSlots() : 1U);
  plan_.slots = std::min(std::max(plan_.slots, least), plan_.poolSlots);
  plan_.layers = layersOf(plan_);
}

void FrameRenderer::allocate() {
  try {
    list_.prepare(inputs_, resources_, machine_.programs,
                  machine_.capabilities.maxStorageBlockBytes);
  } catch (...) {
    // No frame may be drawn with a pool that is larger than its memory: the next one plans anew.
    prepared_ = false;
    plan_.slots = 0;
    throw;
  }
}

void FrameRenderer::prepare() {
  inputs_.displaySize = inputs_.outputSize * settings_.tonemap.ssaa;
  const auto samples = static_cast<std::uint64_t>(inputs_.displaySize.x) *
                       static_cast<std::uint64_t>(inputs_.displaySize.y);
  checkCombination(settings_.oit);
  plan_.importance = settings_.importance;
  plan_.seed = settings_.seed;
  plan_.factorMaps = needsFactors(settings_.heatmap.map);
  planMethod(samples);
  planNetwork();
  planLod(lod_, settings_.lod, settings_.foveation, inputs_.facts, mayResize_);
  plan_.resizable = lod_.transparency;
  plan_.imageSize = inputs_.displaySize;
  resources_.setBufferBytes(Resource::OitTotals, sizeof(shader::OitTotals));
  const glm::ivec2 size = inputs_.displaySize;
  const glm::ivec2 tiles = (size + plan_.importance.tile - 1) / plan_.importance.tile;
  const auto area = [](glm::ivec2 s) {
    return static_cast<std::size_t>(s.x) * static_cast<std::size_t>(s.y);
  };
  constexpr std::size_t kVectorBytes = 16;
  resources_.setFixedSize(Resource::TileDepth, tiles);
  resources_.setBufferBytes(
      Resource::SliceSums,
      area(tiles) * static_cast<std::size_t>(plan_.importance.slices) * kVectorBytes);
  const int listed = plan_.listedTile();
  resources_.setBufferBytes(Resource::CoveredTiles,
                            area((size + listed - 1) / listed) * sizeof(std::uint32_t));
  // Cells that the last row and column only begin come on top, in whatever size is drawn.
  const std::size_t cells =
      std::min(area(size), static_cast<std::size_t>(PRICE_PIXELS + size.x + size.y + 1));
  resources_.setBufferBytes(Resource::CoveredSamples, cells * sizeof(std::uint32_t));
  resources_.setBufferBytes(Resource::StripSums, (area({(size.x + STRIP - 1) / STRIP, size.y}) +
                                                  static_cast<std::size_t>(size.y)) *
                                                     kVectorBytes);
  resources_.setBufferBytes(
      Resource::Occupancy,
      area(size) * static_cast<std::size_t>(plan_.options.cullWords) * sizeof(std::uint32_t));
  resources_.setBufferBytes(Resource::CountBins, COUNT_BINS * sizeof(std::uint32_t));
  // Of full rate: a change of r moves what is used of it.
  const glm::ivec2 lodTiles = (size + LOD_TILE - 1) / LOD_TILE;
  resources_.setFixedSize(Resource::ShadingRate, lodTiles);
  resources_.setBufferBytes(Resource::LodTiles, area(lodTiles) * LOD_RATES * sizeof(std::uint32_t));
  resources_.setBufferBytes(Resource::LodTotals, sizeof(shader::LodTotals));
  resources_.setBufferBytes(Resource::LodHoles, area(size) * sizeof(std::uint32_t));
  resources_.setFixedSize(Resource::ShadowMap, glm::ivec2(settings_.shadow.size));
  resources_.setBackground(settings_.background);
  allocate();
  if (inputs_.facts.transparentTriangles > 0) {
    statistics_.prepare(inputs_, resources_, machine_.programs);
  }
  prepared_ = true;
}

}  // namespace macula::passes
