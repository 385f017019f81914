// macula scene make NAME --out F.glb, macula scene list, macula scene info F
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/scene/glb_writer.h"
#include "engine/scene/light_choice.h"
#include "engine/scene/load.h"
#include "engine/scene/scene_facts.h"
#include "engine/scene/scene_info.h"
#include "engine/settings/command_line.h"
#include "passes/frame_list.h"

namespace macula::tools {
namespace {

struct Options {
  std::string name;
  std::string out;
  std::string json;
  passes::RenderSettings settings;
  settings::Registry registry;
};

void make(const Options& options) {
  const scene::Scene made = scene::loadScene(options.name, options.settings.seed);
  scene::writeGlb(made, options.out);
  fmt::print("{}: {} written\n", options.out, counted(scene::describe(made).triangles, "triangle"));
}

void list() {
  for (const scene::RecipeInfo& recipe : scene::recipes()) {
    fmt::print("{:<12} {}\n", recipe.name, recipe.description);
  }
}

void info(Options& options, const CLI::App& command) {
  settings::applyOptions(command, options.registry);
  scene::Scene loaded = scene::loadScene(options.name, options.settings.seed);
  scene::SceneInfo facts = scene::describe(loaded);
  prepareForRendering(loaded, options.settings);
  if (loaded.lights.size() > scene::kMostLights) {
    facts.warnings.push_back(
        oneLine(scene::lightsLeftOut(loaded, startCamera(loaded), 1.0F, "the first camera")));
  }
  const passes::OitPlan plan{.method = &passes::methodById(options.settings.oit.method)};
  const frame::FrameInputs inputs =
      passes::inputsOf(scene::factsOf(loaded, !options.settings.environment.empty()));
  passes::LodPlan lod;
  passes::planLod(lod, options.settings.lod, options.settings.foveation, inputs.facts, false);
  const auto report = passes::makeFrameList(options.settings, plan, lod).report(inputs);
  if (options.json != "-") {
    fmt::print("triangles    {} ({} transparent)\ndraws        {}\n", facts.triangles,
               facts.transparentTriangles, facts.draws);
    fmt::print("materials    {} opaque, {} mask, {} blend\nlights       {}\ntextures     {}\n",
               facts.materials.opaque, facts.materials.mask, facts.materials.blend, facts.lights,
               facts.textures);
    for (const std::string& name : facts.unsupportedExtensions) {
      fmt::print("unsupported  {}\n", name);
    }
    for (const std::string& warning : facts.warnings) fmt::print("warning      {}\n", warning);
    fmt::print("passes with --method {}:\n", options.settings.oit.method);
    for (const frame::PassReport& pass : report) {
      fmt::print("  {} {:<15} {}\n", pass.runs ? "runs" : "-   ", pass.name, pass.reason);
    }
  }
  nlohmann::ordered_json json = scene::toJson(facts);
  json["passes"] = nlohmann::ordered_json::array();
  for (const frame::PassReport& pass : report) {
    if (pass.runs) json["passes"].push_back(pass.name);
  }
  writeJson(options.json, json);
}

}  // namespace

void addScene(CLI::App& root) {
  auto options = std::make_shared<Options>();
  passes::registerSettings(options->registry, options->settings);
  CLI::App* command = root.add_subcommand("scene", "Procedural scenes, and what a file holds");
  command->require_subcommand(1);
  CLI::App* makeCommand = command->add_subcommand("make", "Write a procedural scene as .glb");
  makeCommand->add_option("name", options->name, "See 'macula scene list'")->required();
  makeCommand->add_option("--out", options->out, "File to write")->required();
  makeCommand->add_option("--seed", options->settings.seed, "Of the recipe (default 1)");
  makeCommand->callback([options] { make(*options); });
  command->add_subcommand("list", "The procedural scenes")->callback(list);
  CLI::App* infoCommand = command->add_subcommand("info", "Triangles, materials, passes and why");
  infoCommand->add_option("scene", options->name, "File or procedural name")->required();
  addJsonOption(*infoCommand, options->json);
  settings::addOptions(*infoCommand, options->registry);
  infoCommand->callback([options, infoCommand] { info(*options, *infoCommand); });
}

}  // namespace macula::tools
