#include "passes/lod/settings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "engine/control/law.h"
#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::passes {

LodParts parseLodParts(const std::string& what) {
  LodParts parts;
  const std::array<std::pair<std::string_view, bool*>, 4> known{{{"shading", &parts.shading},
                                                                 {"shadow", &parts.shadow},
                                                                 {"ao", &parts.occlusion},
                                                                 {"noise", &parts.noise}}};
  std::size_t begin = 0;
  while (begin <= what.size()) {
    const std::size_t end = std::min(what.find(',', begin), what.size());
    const std::string_view name = std::string_view(what).substr(begin, end - begin);
    bool found = false;
    for (const auto& [knownName, part] : known) {
      if (name == knownName) found = *part = true;
    }
    if (!found) {
      failInput(
          "lod.what: '{}' is no part of the shading; give shading, or some of shadow,ao,noise",
          oneLine(std::string(name)));
    }
    begin = end + 1;
  }
  if (parts.shading && (parts.shadow || parts.occlusion || parts.noise)) {
    failInput("lod.what: shading holds all other parts; give it alone, or some of shadow,ao,noise");
  }
  return parts;
}

void registerSettings(settings::Registry& registry, LodSettings& s) {
  registry.add(
      {.key = "lod.r", .help = "resize factor: width of the image over that of the shaded one"},
      s.resize, {.min = control::kLeastResize, .max = control::kMostResize});
  registry.add(
      {.key = "lod.what", .help = "what is computed at 1/r: shading, or some of shadow,ao,noise"},
      s.what);
  registry.addChoice({.key = "lod.reconstruction", .help = "how pixels come from the samples"},
                     s.reconstruction, {"bilinear", "yang2008", "macula"});
  registry.addChoice(
      {.key = "lod.holes", .help = "pixels that no sample fits: shaded, or the best sample"},
      s.holes, {"shade", "tap"});
  registry.add({.key = "lod.demodulate",
                .help = "macula: surface colours stay at full rate, only light is computed at 1/r"},
               s.demodulate);
  registry.add({.key = "lod.sigmaNormal",
                .help = "sigma_n of Yang 2008, Eq. 1, of normals divided by their z"},
               s.sigmaNormal, {.min = 1e-6, .max = 1e6});
  registry.add({.key = "lod.sigmaDepth",
                .unit = "of the depth",
                .help = "sigma_z of Yang 2008, Eq. 1",
                .share = true},
               s.sigmaDepth, {.min = 1e-6, .max = 1e6});
  registry.add({.key = "lod.transparency", .help = "transparent surfaces are drawn at 1/r, too"},
               s.transparency);
}

void registerSettings(settings::Registry& registry, FoveationSettings& s) {
  registry.add({.key = "foveation.enabled",
                .alias = "foveation",
                .help = "shading gets coarser away from the point of interest"},
               s.enabled);
  registry.add(
      {.key = "foveation.slope", .unit = "degrees/degree", .help = "m of MAR(e) = m e + w0"},
      s.slope, {.min = 0.0, .max = 10.0});
  registry.add({.key = "foveation.fovealMar",
                .unit = "degrees",
                .help = "w0 of MAR(e) = m e + w0 (20/20 vision: 1/60; Guenter 2012: 1/48)"},
               s.fovealMar, {.min = 0.0, .minExclusive = true, .max = 10.0});
  registry.add(
      {.key = "foveation.perCycle", .help = "MAR is of a cycle, so two samples go to it; off: one"},
      s.perCycle);
  registry.add({.key = "foveation.pixelsPerDegree",
                .unit = "pixels/degree",
                .help = "of the image; 0: from display.widthMm and display.distanceMm"},
               s.pixelsPerDegree, {.min = 0.0, .max = 1000.0});
  registry.addNumberChoice(
      {.key = "foveation.coarsest",
       .unit = "samples",
       .help = "of the reduced-rate image a side that share one of the shading"},
      s.coarsest, {1, 2, 4, 8});
}

}  // namespace macula::passes
