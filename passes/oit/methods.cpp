#include "passes/oit/methods.h"

#include <array>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::passes {
namespace {

using A = Allocation;
using I = Insertion;

constexpr std::string_view kRacyId = "kb-racy";
constexpr std::string_view kLearnedId = "kb-learned";

constexpr std::array kMethods{
    Method{"blend", A::None, I::Blended, false, "unsorted alpha blending: the floor of speed",
           "Porter and Duff 1984"},
    Method{"wboit", A::None, I::Weighted, false,
           "weighted blended: one pass, no order, colours by a guess of their visibility",
           "McGuire and Bavoil 2013, Eq. 9"},
    Method{"peel", A::None, I::Peeled, false,
           "depth peeling: the nearest oit.layers, a layer a pass", "Everitt 2001"},
    Method{"ab-array", A::Constant, I::Appended, false,
           "A-buffer of oit.layers slots a pixel: the first drawn are kept",
           "Tsopouridis 2021, section 3.1.1"},
    Method{"ab-list", A::Pool, I::Linked, true, "A-buffer of per-pixel linked lists",
           "Yang et al. 2010; Tsopouridis 2021, section 3.1.2"},
    Method{"ab-sbuffer", A::ExactCount, I::Appended, true,
           "A-buffer with exact contiguous ranges: the reference",
           "Vasilakis and Fudos 2012; Tsopouridis 2021, section 3.1"},
    Method{kRacyId, A::Constant, I::Sorted, false,
           "k-buffer without synchronisation: hazards on purpose", "Bavoil et al. 2007"},
    Method{"kb-stencil", A::Constant, I::StencilRouted, false,
           "the first k drawn, one multisample slot each; sorted at the resolve",
           "Bavoil and Myers 2008"},
    Method{"kb-atomic", A::Constant, I::AtomicMin, false,
           "the k nearest: keys by atomic minima, then colours to their keys", "Maule et al. 2013"},
    Method{"kb-fixed", A::Constant, I::Sorted, false,
           "the k nearest of each pixel, the same k everywhere",
           "Salvi 2013; Tsopouridis 2021, section 3.2.1"},
    Method{"kb-plus", A::OneK, I::Sorted, false,
           "the min(n, k) nearest, one k from the histogram of counts under a budget",
           "Vasilakis and Fudos 2014"},
    Method{"kb-variable", A::ImportanceMap, I::Sorted, false,
           "k-buffer whose k(p) follows importance under a budget",
           "Vasilakis 2017; Tsopouridis 2021, section 3.2.2"},
    Method{kLearnedId, A::ImportanceMap, I::Sorted, false,
           "k-buffer whose k(p) follows importance as a network says it, under a budget",
           "Tsopouridis 2021, chapter 4"},
};

}  // namespace

bool Method::isRacy() const {
  return id == kRacyId;
}

bool Method::learnsImportance() const {
  return id == kLearnedId;
}

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
