#include "passes/oit/settings.h"

#include "engine/core/error.h"
#include "passes/oit/methods.h"

namespace macula::passes {
namespace {

void checkTail(const OitSettings& s, const Method& method) {
  if (s.tail == Tail::None) return;
  if (!method.isKBuffer()) {
    failInput("oit.tail: {} leaves nothing out in order, so there is no tail; use a k-buffer",
              method.id);
  }
  if (method.insertion == Insertion::StencilRouted) {
    failInput(
        "oit.tail: what kb-stencil leaves out is rejected by the stencil test before it has a "
        "colour; use another k-buffer");
  }
  if (s.cull == Cull::Occupancy) {
    failInput(
        "oit.cull: culled fragments would never reach the tail; use --oit.tail none or "
        "--oit.cull none");
  }
}

void checkImportance(const OitSettings& s, const Method& method) {
  const bool importance = method.allocation == Allocation::ImportanceMap;
  if (s.importance != Predictor::Published && !importance) {
    failInput("oit.importance: {} gives every pixel the same k; use kb-variable", method.id);
  }
  if (s.importance != Predictor::Published && method.learnsImportance()) {
    failInput(
        "oit.importance: {} takes importance from the thesis's network; use kb-variable for others",
        method.id);
  }
  if (s.importance == Predictor::Learned && (!s.fill || s.tail != Tail::Mean)) {
    failInput(
        "oit.importance: the network learned what layers are worth before a tail, in a budget that "
        "is filled; add --oit.fill on --oit.tail mean");
  }
  if (s.fill && !importance && method.allocation != Allocation::OneK) {
    failInput("oit.fill: {} has no budget that pixels share; use kb-variable or kb-plus",
              method.id);
  }
  if (s.count == CountSource::Predicted && !importance) {
    failInput("oit.count: only kb-variable can go by predicted counts, not {}", method.id);
  }
  if (s.count == CountSource::Predicted && method.learnsImportance()) {
    failInput("oit.count: the network of {} sees what a count pass gathers; use --oit.count drawn",
              method.id);
  }
  if (s.count == CountSource::Predicted && s.cull == Cull::Occupancy) {
    failInput(
        "oit.count: culling needs the depths that a count pass finds; use --oit.cull none or "
        "--oit.count drawn");
  }
  if (s.count == CountSource::Predicted && s.importance != Predictor::Published) {
    failInput(
        "oit.count: the depth slices of oit.importance come from the count pass that predicted "
        "counts leave out; use --oit.importance published");
  }
  if (s.count == CountSource::Predicted && s.fragmentBytes != 16) {
    failInput("oit.count: predicted counts need fragments of 16 bytes");
  }
}

void checkSync(const OitSettings& s, const Method& method) {
  if (s.sync == "auto") return;
  if (method.isRacy() && s.sync != "none") {
    failInput("oit.sync: kb-racy is kb-fixed without turns; use kb-fixed for sync {}", s.sync);
  }
  if (!method.fills() && method.insertion != Insertion::Linked) {
    failInput("oit.sync: fragments of {} need no turns; leave it at auto", method.id);
  }
  if (s.sync == "none" && method.insertion != Insertion::Sorted) {
    failInput("oit.sync: {} appends by atomic counters, which cannot be left out", method.id);
  }
}

}  // namespace

void checkCombination(const OitSettings& s) {
  const Method& method = methodById(s.method);
  checkTail(s, method);
  checkImportance(s, method);
  checkSync(s, method);
  if (s.cull == Cull::Occupancy && !method.isKBuffer()) {
    failInput(
        "oit.cull: {} keeps fragments behind the k-th, which culling would take; use a "
        "k-buffer",
        method.id);
  }
  if (s.fragmentBytes != 16 && method.insertion != Insertion::Sorted) {
    failInput("oit.fragmentBytes: {} stores 16 bytes a fragment; use a sorted k-buffer for 8",
              method.id);
  }
}

}  // namespace macula::passes
