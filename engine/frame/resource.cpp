#include "engine/frame/resource.h"

#include <array>

namespace macula::frame {
namespace {

using enum SizeRule;
using R = Resource;
using B = ByteClass;
using C = ClearKind;

constexpr std::array<ResourceInfo, kResourceCount> kResources{{
    {R::ShadowMap, "shadow map", GL_DEPTH_COMPONENT32F, Fixed, B::Other, C::Never},
    {R::Depth, "depth", GL_DEPTH_COMPONENT32F, Display, B::GBuffer, C::Zero},
    {R::Normal, "normal", GL_RG16_SNORM, Display, B::GBuffer, C::Never},
    {R::BaseColor, "base colour", GL_SRGB8_ALPHA8, Display, B::GBuffer, C::Never},
    {R::Surface, "surface", GL_RGBA8, Display, B::GBuffer, C::Never},
    {R::Emissive, "emissive", GL_R11F_G11F_B10F, Display, B::GBuffer, C::Never},
    {R::ShadingRate, "shading rate", GL_R32UI, Fixed, B::Other, C::Zero},
    {R::LodTiles, "level-of-detail tiles", 0, Bytes, B::Other, C::Never},
    {R::LodTotals, "level-of-detail totals", 0, Bytes, B::Other, C::Zero},
    {R::LodSamples, "level-of-detail samples", GL_RGBA32UI, DisplayOverR, B::Other, C::Never},
    {R::LodHoles, "level-of-detail holes", 0, Bytes, B::Other, C::Never},
    {R::ShadingParts, "shading parts", GL_RGBA8, Display, B::Other, C::Never},
    {R::HdrColor, "HDR colour", GL_RGBA16F, Display, B::Other, C::Background},
    {R::ResizedDepth, "resized depth", GL_DEPTH_COMPONENT32F, DisplayOverR, B::Overhead, C::Never},
    {R::ResizedColor, "resized transparency", GL_RGBA16F, DisplayOverR, B::Overhead, C::Never},
    // 32-bit, because 16-bit floats stop counting at 2,048.
    {R::FragmentCount, "fragment count", GL_R32F, Display, B::Overhead, C::Zero},
    {R::PredictedCount, "predicted count", GL_R32F, Display, B::Overhead, C::Never},
    {R::FrontNormal, "front normal", GL_RGBA8_SNORM, Display, B::Overhead, C::Zero},
    {R::Importance, "importance", GL_R32UI, Display, B::Overhead, C::Zero},
    {R::ImportanceFactors, "importance factors", GL_RGBA16F, Display, B::Overhead, C::Zero},
    {R::FragmentRange, "fragment range", GL_RG32UI, Display, B::Overhead, C::Zero},
    {R::FragmentFill, "fragment fill", GL_R32UI, Display, B::Overhead, C::Zero},
    {R::FragmentLock, "fragment lock", GL_R32UI, Display, B::Overhead, C::Zero},
    {R::FragmentKeys, "fragment keys", 0, Bytes, B::Oit, C::Never},
    {R::FragmentColors, "fragment colours", 0, Bytes, B::Oit, C::Never},
    {R::FragmentLinks, "fragment links", 0, Bytes, B::Oit, C::Never},
    {R::TailSums, "tail sums", GL_RGBA32F, Display, B::Oit, C::Never},
    {R::RoutedKeys, "routed keys", GL_RG32UI, DisplaySamples, B::Oit, C::Never},
    {R::RoutedColors, "routed colours", GL_RGBA16F, DisplaySamples, B::Oit, C::Never},
    {R::RoutedStencil, "routing stencil", GL_DEPTH32F_STENCIL8, DisplaySamples, B::Overhead,
     C::Never},
    {R::PeelDepth, "peel depth", GL_DEPTH_COMPONENT32F, Display, B::Overhead, C::Never},
    {R::PeelIds, "peel ids", GL_R32UI, Display, B::Overhead, C::Never},
    {R::PeelColor, "peel colour", GL_RGBA32F, Display, B::Oit, C::Never},
    {R::PeelLast, "peel last key", GL_RG32UI, Display, B::Oit, C::Never},
    {R::PeelSum, "peel sum", GL_RGBA32F, Display, B::Overhead, C::Never},
    {R::WeightedColors, "weighted colours", GL_RGBA32F, Display, B::Oit, C::Never},
    {R::SliceSums, "slice sums", 0, Bytes, B::Overhead, C::Zero},
    {R::TileDepth, "tile depth", GL_DEPTH_COMPONENT32F, Fixed, B::Overhead, C::Never},
    {R::CountBins, "count bins", 0, Bytes, B::Overhead, C::Zero},
    {R::StripSums, "strip sums", 0, Bytes, B::Overhead, C::Zero},
    {R::CoveredTiles, "covered tiles", 0, Bytes, B::Overhead, C::Never},
    {R::CoveredSamples, "covered samples", 0, Bytes, B::Overhead, C::Never},
    {R::SlotBids, "slot bids", GL_R32UI, Display, B::Overhead, C::Never},
    {R::DepthRange, "depth range", GL_RG32F, Display, B::Overhead, C::Never},
    {R::Occupancy, "occupancy", 0, Bytes, B::Overhead, C::Never},
    {R::CullDepth, "cull depth", GL_DEPTH_COMPONENT32F, Display, B::Overhead, C::Never},
    {R::ColorSums, "colour sums", GL_RGBA32F, Display, B::Overhead, C::Never},
    {R::NearestColor, "nearest colour", GL_RGBA32F, Display, B::Overhead, C::Never},
    {R::NetworkOutput, "network output", GL_RGBA32UI, Fixed, B::Overhead, C::Zero},
    {R::OitTotals, "transparency totals", 0, Bytes, B::Overhead, C::Zero},
    {R::LinearColor, "linear colour", GL_RGBA32F, Output, B::Other, C::Never},
    {R::DisplayColor, "display colour", GL_RGBA8, Output, B::Other, C::Never},
    {R::HeatmapColor, "heat map", GL_RGBA8, Output, B::Other, C::Never},
}};

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    if (static_cast<std::size_t>(kResources[i].id) != i) return false;
  }
  return true;
}
static_assert(inOrder(), "the table stands in the order of the enumeration");

}  // namespace

const ResourceInfo& infoOf(Resource resource) {
  return kResources[static_cast<std::size_t>(resource)];
}

std::string_view nameOf(Resource resource) {
  return infoOf(resource).name;
}

}  // namespace macula::frame
