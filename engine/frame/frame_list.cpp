#include "engine/frame/frame_list.h"

#include <algorithm>

#include "engine/frame/pass_context.h"
#include "engine/gl/block_check.h"
#include "engine/gl/debug.h"

namespace macula::frame {
namespace {

std::vector<Touch> touchesOf(const Pass& pass) {
  PassDeclaration declaration;
  pass.declare(declaration);
  return declaration.touches();
}

std::size_t indexOf(Resource r) {
  return static_cast<std::size_t>(r);
}

void issue(GLbitfield barriers) {
  if (barriers != 0) glMemoryBarrier(barriers);
}

}  // namespace

FrameList::FrameList(std::vector<std::unique_ptr<Pass>> passes, std::vector<Resource> results)
    : results_(std::move(results)) {
  for (std::unique_ptr<Pass>& pass : passes) {
    std::vector<Touch> touches = touchesOf(*pass);
    entries_.push_back({std::move(pass), std::move(touches), false});
  }
}

std::vector<std::string> FrameList::validate() const {
  std::vector<DeclaredPass> declared;
  for (const Entry& entry : entries_) declared.push_back({entry.pass->name(), entry.touches});
  return frame::validate(declared, results_);
}

std::vector<PassReport> FrameList::report(const FrameInputs& inputs) const {
  std::vector<PassReport> rows;
  for (const Entry& entry : entries_) {
    rows.push_back({entry.pass->name(), entry.pass->hasWork(inputs), entry.pass->reason(inputs)});
  }
  return rows;
}

std::vector<Resource> FrameList::neededResources(const FrameInputs& inputs) const {
  std::vector<Resource> needed;
  for (const Entry& entry : entries_) {
    if (!entry.pass->hasWork(inputs)) continue;
    for (const Touch& touch : touchesOf(*entry.pass)) {
      // What is only read and has no clear value stays unbound: nothing in it would be looked at.
      const bool writes = touch.access != Access::Read && touch.access != Access::ReadHistory;
      if (writes || infoOf(touch.resource).clear != ClearKind::Never) {
        needed.push_back(touch.resource);
      }
    }
  }
  return needed;
}

void FrameList::prepare(const FrameInputs& inputs, FrameResources& resources,
                        gl::ProgramCache& programs, std::int64_t maxStorageBlockBytes) {
  for (Entry& entry : entries_) {
    entry.touches = touchesOf(*entry.pass);
    entry.runs = entry.pass->hasWork(inputs);
    if (entry.runs) entry.pass->prepare(inputs, programs);
  }
  resources.allocate(neededResources(inputs), inputs.outputSize, inputs.displaySize,
                     maxStorageBlockBytes);
  dirty_.fill(true);  // the background may have changed
  times_.reserve(entries_.size());
}

void FrameList::clearUnwritten(const Entry& entry, FrameResources& resources) {
  for (const Touch& touch : entry.touches) {
    const std::size_t i = indexOf(touch.resource);
    const bool reads = touch.access == Access::Read || touch.access == Access::Modify ||
                       touch.access == Access::Consume;
    if (!reads || written_[i] || infoOf(touch.resource).clear == ClearKind::Never) continue;
    if (dirty_[i]) {
      issue(barriers_.beforeClear(touch.resource));
      resources.clear(touch.resource);
    }
    dirty_[i] = false;
  }
}

void FrameList::run(PassContext& context, gl::FrameTimer& timer) {
  times_.clear();
  written_.fill(false);
  timer.begin();
  for (Entry& entry : entries_) {
    if (!entry.runs) continue;
    const gl::DebugGroup group(entry.pass->name());
    clearUnwritten(entry, context.resources());
    issue(barriers_.before(entry.touches));
    gl::BlockCheck::beginPass();
    context.setDeclared(entry.touches);
    entry.pass->execute(context);
    context.setDeclared({});
    for (const Touch& touch : entry.touches) {
      if (touch.access == Access::Read || touch.access == Access::ReadHistory) continue;
      written_[indexOf(touch.resource)] = true;
      dirty_[indexOf(touch.resource)] = true;
    }
    timer.mark();
    times_.push_back({entry.pass->name(), 0.0});
  }
  timer.end();
  for (std::size_t i = 0; i < times_.size(); ++i) times_[i].ms = timer.intervalMs(i);
}

}  // namespace macula::frame
