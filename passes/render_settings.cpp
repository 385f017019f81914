#include "passes/render_settings.h"

#include <vector>

namespace macula::passes {
namespace {

constexpr auto kReloads = settings::Effect::ReloadsScene;

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.emplace_back(method.id);
  return names;
}

void registerOit(settings::Registry& registry, OitSettings& s) {
  registry.addChoice({.key = "oit.method", .alias = "method", .help = "how transparency is drawn"},
                     s.method, methodNames());
  registry.add({.key = "oit.kAve",
                .alias = "k-ave",
                .unit = "fragments/sample",
                .help = "layers stored per sample on average (Vasilakis 2017, Eq. 2)"},
               s.kAve, {.min = 0.0, .minExclusive = true, .max = 4096.0});
  registry.add({.key = "oit.memoryMiB",
                .alias = "oit-memory",
                .unit = "MiB",
                .help = "budget of the fragment storage, in place of --k-ave; 0: by that"},
               s.memoryMiB, {.min = 0.0, .max = 8192.0});
  registry.addRivals("oit.kAve", "oit.memoryMiB");
  registry.addChoice({.key = "oit.sync", .help = "per-pixel ordering of fragments"}, s.sync,
                     {"auto", "interlock", "spinlock", "ordered", "none"});
  registry.add(
      {.key = "oit.layers", .unit = "layers", .help = "slots a sample of ab-array, layers of peel"},
      s.layers, {.min = 1.0, .max = 1024.0});
  registry.addChoice(
      {.key = "oit.tail", .help = "what becomes of the tail: the fragments that get no slot"},
      s.tail, {"none", "mean"});
  registry.add({.key = "oit.fill",
                .help = "no sample gets more slots than it has fragments; others get the rest"},
               s.fill);
  registry.addChoice(
      {.key = "oit.importance", .help = "what the number of layers of a sample follows"},
      s.importance, {"published", "transmittance", "error", "learned"});
  registry.addChoice({.key = "oit.cull", .help = "early rejection behind the k-th layer"}, s.cull,
                     {"none", "occupancy"});
  registry.add({.key = "oit.cullWords",
                .unit = "32-bit words a sample",
                .help = "d of Vasilakis 2015: 32 d depth intervals"},
               s.cullWords, {.min = 1.0, .max = 64.0});
  registry.addNumberChoice({.key = "oit.fragmentBytes",
                            .unit = "bytes",
                            .help = "of a fragment that a sorted k-buffer stores"},
                           s.fragmentBytes, {16, 8});
  registry.add({.key = "oit.network",
                .help = "weights of kb-learned or of oit.importance learned; empty: Macula's own"},
               s.network);
  registry.addChoice({.key = "oit.count", .help = "source of the number of a sample's fragments"},
                     s.count, {"drawn", "predicted"});
}

void registerImportance(settings::Registry& registry, ImportanceSettings& s) {
  registry.add(
      {.key = "importance.rangeBias", .help = "alpha of Vasilakis 2017, Eq. 3", .share = true},
      s.rangeBias, {.min = 0.0, .max = 1.0});
  registry.add({.key = "importance.periphery",
                .help = "d of Vasilakis 2017, Eq. 4: how fast importance falls off the gaze"},
               s.periphery, {.min = 0.0, .minExclusive = true, .max = 64.0});
  registry.add(
      {.key = "importance.noise", .help = "lambda of Vasilakis 2017, Eq. 6", .share = true},
      s.noise, {.min = 0.0, .max = 1.0});
  registry.add({.key = "importance.layerLimit",
                .unit = "layers",
                .help = "N_limit of Vasilakis 2017, Eq. 3; 0: the largest count seen so far"},
               s.layerLimit, {.min = 0.0, .max = 65535.0});
  registry.add({.key = "importance.slices",
                .unit = "depth slices",
                .help = "that oit.importance transmittance and error predict from; learned: 8"},
               s.slices, {.min = 1.0, .max = 16.0});
  registry.addNumberChoice(
      {.key = "importance.tile", .unit = "samples a side", .help = "that share their depth slices"},
      s.tile, {1, 2, 4});
  registry.addNumberChoice({.key = "importance.networkTile",
                            .unit = "samples a side",
                            .help = "for which a network is evaluated once"},
                           s.networkTile, {1, 2, 4});
  registry.add({.key = "importance.gazeWeight",
                .help = "how far predicted errors count less away from the gaze",
                .share = true},
               s.gazeWeight, {.min = 0.0, .max = 1.0});
  registry.add({.key = "importance.noisePerFrame", .help = "a new random number each frame"},
               s.noisePerFrame);
}

}  // namespace

RenderSettings referenceOf(const RenderSettings& settings) {
  RenderSettings reference = settings;
  reference.oit = {};
  reference.oit.method = "ab-sbuffer";
  reference.heatmap.map = "none";
  reference.lod = {};
  reference.foveation = {};
  return reference;
}

void registerSettings(settings::Registry& registry, RenderSettings& s) {
  registerOit(registry, s.oit);
  registerImportance(registry, s.importance);
  registerSettings(registry, s.lod);
  registerSettings(registry, s.foveation);
  registry.addChoice(
      {.key = "tonemap.curve", .alias = "tonemap", .help = "none writes linear values as they are"},
      s.tonemap.curve, {"none", "neutral", "aces"});
  registry.add(
      {.key = "tonemap.exposure", .alias = "exposure", .unit = "stops", .help = "brighter"},
      s.tonemap.exposure, {.min = -32.0, .max = 32.0});
  registry.addNumberChoice({.key = "frame.ssaa",
                            .alias = "ssaa",
                            .unit = "samples per axis",
                            .help = "supersampling: N x N samples for each pixel"},
                           s.tonemap.ssaa, {1, 2, 4});
  registry.add({.key = "frame.timing",
                .help = "time of each pass; off: passes may overlap, and no times are reported"},
               s.timing);
  registry.add({.key = "scene.environment",
                .alias = "environment",
                .help = "equirectangular .hdr or .exr for light and background",
                .effect = kReloads},
               s.environment);
  registry.add({.key = "scene.background",
                .alias = "background",
                .unit = "linear R,G,B",
                .help = "where nothing is drawn"},
               s.background, {.min = 0.0, .max = 10000.0});
  registry.addChoice(
      {.key = "scene.lighting",
       .help = "transparent surfaces as the scene says, unlit, or lit by four lights",
       .effect = kReloads},
      s.lighting, {"own", "unlit", "four"});
  registry.add({.key = "scene.opacity",
                .help = "below 1 every surface is transparent, its alpha multiplied by this",
                .share = true,
                .effect = kReloads},
               s.opacity, {.min = 0.0, .minExclusive = true, .max = 1.0});
  registry.addChoice({.key = "scene.order",
                      .help = "in which transparent triangles are drawn, from the first camera",
                      .effect = kReloads},
                     s.order, {"file", "near-first", "far-first", "random"});
  registry.add({.key = "frame.seed",
                .alias = "seed",
                .help = "of noise and procedural scenes",
                .effect = kReloads},
               s.seed, {.min = 0.0, .max = 2147483647.0});
  registry.add({.key = "shadow.size", .unit = "texels a side", .help = "of the shadow map"},
               s.shadow.size, {.min = 64.0, .max = 8192.0});
  registry.addChoice({.key = "view.heatmap", .alias = "heatmap", .help = "shown over the image"},
                     s.heatmap.map, heatmapNames());
  registry.add({.key = "view.heatmapRange",
                .unit = "layers",
                .help = "value of the hottest colour for counts and k; 0: the largest seen"},
               s.heatmap.range, {.min = 0.0, .max = 65535.0});
}

}  // namespace macula::passes
