#include "engine/frame/frame_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/frame/pass_context.h"
#include "engine/gl/debug.h"

namespace macula::frame {
namespace {

bool contains(const std::vector<const Resource*>& list, const Resource& r) {
  return std::find(list.begin(), list.end(), &r) != list.end();
}

/// Collects what a frame needs of each resource, pass by pass.
class DemandList {
 public:
  explicit DemandList(const FrameInputs& inputs) : inputs_(inputs) {}

  void add(const PassDeclaration& table, std::uint32_t pass) {
    for (const Binding& row : table.bindings()) {
      Demand& demand = demandOf(*row.resource, pass);
      demand.life.last = pass;
      if (outlivesFrame(row.access)) demand.transient = false;
    }
    for (const Extent& extent : table.extents()) setSize(extent, pass);
  }

  std::vector<Demand> finish() {
    for (const Demand& demand : all_) {
      const bool unsampled =
          demand.resource->size == SizeRule::DisplaySamples && demand.samples == 0;
      if ((demand.resource->isBuffer() ? demand.bytes == 0 : demand.size == glm::ivec2(0)) ||
          unsampled) {
        throw std::logic_error(fmt::format("no pass states a size of {}", demand.resource->name));
      }
    }
    return std::move(all_);
  }

 private:
  Demand& demandOf(const Resource& r, std::uint32_t pass) {
    for (Demand& demand : all_) {
      if (demand.resource == &r) return demand;
    }
    Demand demand{.resource = &r, .life = {pass, pass}, .transient = r.isBuffer()};
    switch (r.size) {
      case SizeRule::Output:
        demand.size = inputs_.outputSize;
        break;
      case SizeRule::Display:
      case SizeRule::DisplayOverR:
      case SizeRule::DisplaySamples:
        demand.size = inputs_.displaySize;
        break;
      case SizeRule::Declared:
        break;
    }
    return all_.emplace_back(demand);
  }

  void setSize(const Extent& extent, std::uint32_t pass) {
    const Resource& r = *extent.resource;
    Demand& demand = demandOf(r, pass);
    const bool samples = r.size == SizeRule::DisplaySamples;
    const bool same = (demand.bytes == 0 || demand.bytes == extent.bytes) &&
                      (samples || demand.size == glm::ivec2(0) || demand.size == extent.size) &&
                      (demand.samples == 0 || demand.samples == extent.samples);
    if (!same) throw std::logic_error(fmt::format("passes state several sizes of {}", r.name));
    demand.bytes = extent.bytes;
    if (samples) {
      demand.samples = extent.samples;
    } else {
      demand.size = extent.size;
    }
  }

  const FrameInputs& inputs_;
  std::vector<Demand> all_;
};

/// Notes the programs that a pass asks for while it lives.
class ProgramRecord {
 public:
  ProgramRecord(gl::ProgramCache& programs, std::vector<GLuint>& into) : programs_(programs) {
    into.clear();
    programs_.record(&into);
  }
  ~ProgramRecord() { programs_.record(nullptr); }
  ProgramRecord(const ProgramRecord&) = delete;
  ProgramRecord& operator=(const ProgramRecord&) = delete;

 private:
  gl::ProgramCache& programs_;
};

}  // namespace

FrameList::FrameList(std::vector<std::unique_ptr<Pass>> passes,
                     std::vector<const Resource*> results,
                     std::vector<const Resource*> readAfterwards,
                     std::vector<std::unique_ptr<Pass>> reportPasses)
    : framePasses_(passes.size()),
      results_(std::move(results)),
      readAfterwards_(std::move(readAfterwards)) {
  for (std::unique_ptr<Pass>& pass : passes) entries_.emplace_back().pass = std::move(pass);
  for (std::unique_ptr<Pass>& pass : reportPasses) entries_.emplace_back().pass = std::move(pass);
}

std::vector<std::string> FrameList::validate(const FrameInputs& inputs) const {
  std::vector<DeclaredPass> declared;
  for (const Entry& entry : entries_) {
    if (!entry.pass->hasWork(inputs)) continue;
    entry.pass->declare(declared.emplace_back(DeclaredPass{entry.pass->name(), {}}).table, inputs);
  }
  return frame::validate(declared, results_);
}

std::vector<PassReport> FrameList::report(const FrameInputs& inputs) const {
  std::vector<PassReport> rows;
  for (const Entry& entry : std::span(entries_).first(framePasses_)) {
    rows.push_back(
        {std::string(entry.pass->name()), entry.pass->hasWork(inputs), entry.pass->reason(inputs)});
  }
  return rows;
}

std::vector<const Resource*> FrameList::neededResources(const FrameInputs& inputs) const {
  std::vector<const Resource*> needed;
  for (const Entry& entry : entries_) {
    if (!entry.pass->hasWork(inputs)) continue;
    PassDeclaration table;
    entry.pass->declare(table, inputs);
    for (const Binding& row : table.bindings()) {
      if (!contains(needed, *row.resource)) needed.push_back(row.resource);
    }
  }
  return needed;
}

std::optional<Shortage> FrameList::shortage(const FrameInputs& inputs,
                                            const gl::Limits& limits) const {
  for (const Entry& entry : entries_) {
    if (!entry.pass->hasWork(inputs)) continue;
    PassDeclaration table;
    entry.pass->declare(table, inputs);
    if (auto found = shortageOf(entry.pass->name(), needsOf(table), limits)) return found;
  }
  return std::nullopt;
}

std::vector<Demand> FrameList::demands(const FrameInputs& inputs, bool shareMemory) const {
  DemandList list(inputs);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].runs) list.add(entries_[i].table, static_cast<std::uint32_t>(i));
  }
  std::vector<Demand> all = list.finish();
  for (Demand& demand : all) {
    // Results leave the frame by way of their own memory; what is only read back keeps its place in
    // shared memory to the end of the frame.
    if (!shareMemory || contains(results_, *demand.resource)) demand.transient = false;
    if (contains(readAfterwards_, *demand.resource)) {
      demand.life.last = static_cast<std::uint32_t>(entries_.size());
    }
  }
  return all;
}

void FrameList::prepare(const FrameInputs& inputs, FrameResources& resources,
                        gl::ProgramCache& programs, const AllocationRules& rules) {
  gl::ProgramCache::Batch batch(programs);
  for (Entry& entry : entries_) {
    entry.table.clear();
    entry.runs = entry.pass->hasWork(inputs);
    if (!entry.runs) continue;
    entry.pass->declare(entry.table, inputs);
    const ProgramRecord record(programs, entry.programs);
    entry.pass->prepare(inputs, programs);
  }
  batch.finish();
  resources.allocate(demands(inputs, rules.shareMemory),
                     rules.limits[gl::Limit::StorageBlockBytes]);
  for (Entry& entry : entries_) entry.slots = slotsOf(entry.table, resources);
  barriers_.setMemory(resources.memory());
  dirty_.assign(resources.slots(), true);  // the background may have changed
  written_.assign(resources.slots(), false);
  ran_.reserve(entries_.size());
  compared_ = {};
  if (gl::isDebugContext()) checkBindings();
}

/// No program may need more than its table says, or than GL promises of a work group, which tables
/// do not state.
void FrameList::checkNeeds(const Entry& entry) {
  gl::Limits stated = gl::guaranteedLimits();
  for (const gl::LimitRow& row : gl::limitRows()) {
    if (row.limit != gl::Limit::GroupThreads) stated[row.limit] = 0;
  }
  for (const Need& need : needsOf(entry.table)) stated[need.limit] = need.amount;
  for (const GLuint program : entry.programs) {
    if (const auto more = shortageOf(entry.pass->name(), needsOf(program), stated)) {
      gl::reportMistake(fmt::format("pass '{}': a program needs {} {}, and its table says {}",
                                    more->pass, more->need.amount, gl::rowOf(more->need.limit).what,
                                    more->offered));
    }
  }
}

void FrameList::checkBindings() {
  for (const Entry& entry : entries_) {
    if (!entry.runs) continue;
    std::vector<std::vector<ShaderBinding>> programs;
    for (const GLuint program : entry.programs) programs.push_back(bindingsOf(program));
    for (const std::string& problem : compareBindings(entry.pass->name(), entry.table, programs)) {
      gl::reportMistake(problem);
    }
    checkNeeds(entry);
    compared_.programs += programs.size();
    compared_.rows += entry.table.bindings().size();
  }
}

/// Declares again for what differs in this frame; the rows are those that prepare() resolved.
void FrameList::refresh(Entry& entry, const PassContext& context) {
  entry.table.clear();
  entry.pass->declare(entry.table, context.inputs());
  const std::vector<Binding>& rows = entry.table.bindings();
  bool same = rows.size() == entry.slots.size();
  for (std::size_t i = 0; same && i < rows.size(); ++i) {
    same = *rows[i].resource == context.resources().resourceAt(entry.slots[i]);
  }
  if (!same) {
    throw std::logic_error(
        fmt::format("pass '{}' declares other rows than when it was prepared", entry.pass->name()));
  }
}

/// Clears what a pass will read and no pass of this frame has written, and notes what it writes.
void FrameList::clearUnwritten(const Entry& entry, const FrameResources& resources) {
  const std::vector<Binding>& rows = entry.table.bindings();
  for (std::uint32_t step = 0; step < entry.table.steps(); ++step) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::uint32_t slot = entry.slots[i];
      const Resource& r = *rows[i].resource;
      const bool reads = rows[i].active && rows[i].step == step && readsThisFrame(rows[i].access);
      if (!reads || written_[slot] || r.initial == Initial::Undefined || !dirty_[slot]) continue;
      if (const GLbitfield bits = barriers_.beforeClear(r, slot); bits != 0) glMemoryBarrier(bits);
      resources.clear(slot);
      dirty_[slot] = false;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].active || rows[i].step != step || !writes(rows[i].access)) continue;
      written_[entry.slots[i]] = true;
      for (const std::uint32_t s : barriers_.sharing(entry.slots[i])) dirty_[s] = true;
    }
  }
}

void FrameList::runPass(Entry& entry, PassContext& context) {
  refresh(entry, context);
  const gl::DebugGroup group(entry.pass->name());
  clearUnwritten(entry, context.resources());
  context.beginPass(entry.table, entry.slots);
  context.beginStep(0);
  entry.pass->execute(context);
}

void FrameList::run(PassContext& context, gl::FrameTimer* timer) {
  ran_.clear();
  written_.assign(written_.size(), false);
  barriers_.beginFrame();
  for (Entry& entry : framePasses()) {
    if (!entry.runs) continue;
    runPass(entry, context);
    if (timer != nullptr) timer->mark();
    ran_.push_back(entry.pass->name());
  }
}

void FrameList::runReport(PassContext& context) {
  for (Entry& entry : std::span(entries_).subspan(framePasses_)) {
    if (entry.runs) runPass(entry, context);
  }
}

}  // namespace macula::frame
