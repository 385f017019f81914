#include "passes/oit/methods.h"

#include <array>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::passes {
namespace {

constexpr std::array kMethods{
    Method{"blend", Allocation::None, Insertion::Blended, false,
           "unsorted alpha blending: the floor of speed", "Porter and Duff 1984"},
    Method{"ab-sbuffer", Allocation::ExactCount, Insertion::Appended, true,
           "A-buffer with exact contiguous ranges: the reference",
           "Vasilakis and Fudos 2012; Tsopouridis 2021, section 3.1"},
    Method{"kb-variable", Allocation::ImportanceMap, Insertion::Sorted, false,
           "k-buffer whose k(p) follows an importance map under a budget",
           "Vasilakis 2017; Tsopouridis 2021, section 3.2.2"},
};

}  // namespace

std::span<const Method> methods() {
  return kMethods;
}

const Method& methodById(std::string_view id) {
  std::vector<std::string> known;
  for (const Method& method : kMethods) {
    if (method.id == id) return method;
    known.emplace_back(method.id);
  }
  failInput("oit.method: there is no method '{}'; did you mean '{}'?", id, nearestName(id, known));
}

}  // namespace macula::passes
