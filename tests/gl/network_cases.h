// Networks made up for a test, and the ways to draw by them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/file.h"
#include "model_network.h"
#include "oit_cases.h"
#include "temporary_path.h"

namespace macula::test {

/// Files of small test networks, until the test ends.
class Networks : public GlTest {
 protected:
  void TearDown() override {
    for (const std::filesystem::path& file : files_) std::filesystem::remove(file);
    GlTest::TearDown();
  }
  std::filesystem::path write(const network::Network& network) {
    files_.emplace_back(temporaryPath(std::to_string(files_.size()) + ".safetensors"));
    writeFileAtomically(files_.back(), fileOf(network));
    return files_.back();
  }
  /// The options with this network.
  passes::OitSettings with(passes::OitSettings oit, const network::Network& network) {
    oit.network = write(network);
    return oit;
  }
  /// The options with a small network of their model, another one for each seed.
  passes::OitSettings random(passes::OitSettings oit, std::uint32_t seed) {
    return with(oit, randomNetwork(modelOf(oit), {8}, seed));
  }
  static passes::NetworkModel modelOf(const passes::OitSettings& oit) {
    return passes::methodById(oit.method).learnsImportance() ? passes::NetworkModel::Thesis
                                                             : passes::NetworkModel::Learned;
  }
  /// kb-learned without and with a filled budget, and kb-variable by learned utility.
  static std::vector<passes::OitSettings> ways(double kAve) {
    return {{.method = "kb-learned", .kAve = kAve},
            {.method = "kb-learned", .kAve = kAve, .fill = true},
            {.method = "kb-learned", .kAve = kAve, .fill = true, .tail = passes::Tail::Mean},
            learnedUtility(kAve)};
  }

 private:
  std::vector<std::filesystem::path> files_;
};

/// The options with networks evaluated once for so many samples a side.
inline passes::RenderSettings tiled(const passes::OitSettings& oit, int tile) {
  passes::RenderSettings settings = settingsOf(oit);
  settings.importance.networkTile = tile;
  return settings;
}

}  // namespace macula::test
