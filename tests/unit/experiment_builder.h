// A small experiment for the tests of engine/experiment.
#pragma once

#include <string>

#include "engine/experiment/plan.h"

namespace macula::experiment {

/// Two scenes, two budgets, an unlimited and a limited variant.
inline const std::string kSmall = R"(title = "Small"
scenes = ["smoke", "bottles"]
sizes = ["64x48"]
budgets = [{ k_ave = 2 }, { share = 0.3 }]

[[variant]]
id = "exact"
settings = { oit.method = "ab-sbuffer" }

[[variant]]
id = "limited"
label = "k-buffer"
settings = { oit.method = "kb-variable" }
budgets = true
)";

/// Its text with one part replaced.
inline std::string smallWith(const std::string& part, const std::string& by) {
  std::string text = kSmall;
  const std::size_t at = text.find(part);
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

}  // namespace macula::experiment
