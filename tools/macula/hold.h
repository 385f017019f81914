// Options of `macula hold`.
#pragma once

#include <string>

#include "common.h"

namespace macula::tools {

struct HoldOptions {
  bool plant = false;
  double targetMs = 1000.0 / 60.0;
  int seeds = 20;
  std::string out;
  std::string json;
};

/// Runs every law on every case of the plant; writes results and report where a folder is named.
void holdPlant(const HoldOptions& options);

}  // namespace macula::tools
