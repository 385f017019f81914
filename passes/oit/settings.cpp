#include "passes/oit/settings.h"

#include "engine/core/error.h"
#include "passes/oit/methods.h"

namespace macula::passes {
namespace {

void checkTail(const OitSettings& s, const Method& method) {
  if (s.tail == Tail::None) return;
  if (!method.insertion.noTail.empty()) {
    failInput("oit.tail: {} {}", method.id, method.insertion.noTail);
  }
  if (s.cull == Cull::Occupancy) {
    failInput(
        "oit.cull: culled fragments would never reach the tail; use --oit.tail none or "
        "--oit.cull none");
  }
}

void checkImportance(const OitSettings& s, const Method& method) {
  if (s.importance != Predictor::Published && !method.followsImportance()) {
    failInput("oit.importance: {} gives every pixel the same k; use kb-variable", method.id);
  }
  if (s.importance != Predictor::Published && method.learnsImportance()) {
    failInput(
        "oit.importance: {} takes importance from the thesis's network; use kb-variable for others",
        method.id);
  }
  if (s.importance == Predictor::Learned && (!s.fill || s.tail != Tail::Mean)) {
    failInput(
        "oit.importance: the network learned the utility of layers before a tail, in a budget that "
        "is filled; add --oit.fill on --oit.tail mean");
  }
  if (s.fill && !method.sharesBudget()) {
    failInput("oit.fill: {} has no budget that pixels share; use kb-variable or kb-plus",
              method.id);
  }
}

void checkPredictedCounts(const OitSettings& s, const Method& method) {
  if (s.count != CountSource::Predicted) return;
  if (!method.followsImportance()) {
    failInput("oit.count: only kb-variable can go by predicted counts, not {}", method.id);
  }
  if (method.learnsImportance()) {
    failInput("oit.count: the network of {} reads what a count pass sums; use --oit.count drawn",
              method.id);
  }
  if (s.cull == Cull::Occupancy) {
    failInput(
        "oit.count: culling needs the depths that a count pass finds; use --oit.cull none or "
        "--oit.count drawn");
  }
  if (s.importance != Predictor::Published) {
    failInput(
        "oit.count: the depth slices of oit.importance need the depths of a count pass, which "
        "predicted counts leave out; use --oit.importance published");
  }
  if (s.fragmentBytes != 16) {
    failInput("oit.count: predicted counts need fragments of 16 bytes");
  }
}

void checkOrdering(const OitSettings& s, const Method& method) {
  if (s.sync == "auto") return;
  if (method.isRacy() && s.sync != "none") {
    failInput("oit.sync: {} is kb-fixed without per-pixel ordering; use kb-fixed for sync {}",
              method.id, s.sync);
  }
  if (!method.hasFill()) {
    failInput("oit.sync: fragments of {} need no per-pixel ordering; leave it at auto", method.id);
  }
  if (s.sync == "none" && !method.sorts()) {
    failInput("oit.sync: {} appends by atomic counters, which cannot be left out", method.id);
  }
}

}  // namespace

void checkCombination(const OitSettings& s) {
  const Method& method = methodById(s.method);
  checkTail(s, method);
  checkImportance(s, method);
  checkPredictedCounts(s, method);
  checkOrdering(s, method);
  if (s.cull == Cull::Occupancy && !method.hasBudget()) {
    failInput(
        "oit.cull: {} keeps fragments behind the k-th, which culling would reject; use a "
        "k-buffer",
        method.id);
  }
  if (s.fragmentBytes != 16 && !method.sorts()) {
    failInput("oit.fragmentBytes: {} stores 16 bytes a fragment; use a sorted k-buffer for 8",
              method.id);
  }
}

}  // namespace macula::passes
