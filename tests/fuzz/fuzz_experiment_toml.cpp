// Any bytes as an experiment file: an InputError of one line, or an experiment that expands to
// points with keys of their own.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/experiment/plan.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace macula::experiment;
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    std::set<std::string> keys;
    for (const Group& group : expand(parseExperiment(text, "fuzz.toml"), {})) {
      for (const Batch& batch : group.batches) {
        for (const PointPlan& point : batch.points) {
          if (!keys.insert(point.key).second) std::abort();
        }
      }
    }
  } catch (const macula::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
