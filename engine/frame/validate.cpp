#include "engine/frame/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace macula::frame {
namespace {

struct State {
  std::string_view writer;  ///< last pass that wrote it; empty: none
  bool read = false;        ///< since that write
  bool isHistory = false;
};

bool hasUnit(BindPoint point) {
  return point != BindPoint::Update && point != BindPoint::Indirect;
}

bool isBufferPoint(BindPoint point) {
  return point == BindPoint::Storage || point == BindPoint::Indirect;
}

class Validator {
 public:
  void visit(const DeclaredPass& pass) {
    if (!names_.insert(pass.name).second) report("pass '{}' stands twice in the frame", pass.name);
    for (const Binding& row : pass.table.bindings()) {
      // Also where the row rests: what is written now is history for a frame in which it does not.
      if (readsHistory(row.access)) states_[row.resource].isHistory = true;
    }
    for (std::uint32_t step = 0; step < pass.table.steps(); ++step) {
      std::vector<Binding> rows;
      for (const Binding& row : pass.table.bindings()) {
        if (row.step == step && row.active) rows.push_back(row);
      }
      visitUnits(pass, rows);
      // What a step reads, it reads before it writes.
      for (const Binding& row : rows) visitRead(pass, row);
      for (const Binding& row : rows) visitWrite(pass, row);
    }
    visitSizes(pass);
  }

  std::vector<std::string> finish(std::span<const Resource* const> results) {
    for (const auto& [resource, state] : states_) {
      if (state.writer.empty() || state.read || state.isHistory) continue;
      if (std::find(results.begin(), results.end(), resource) != results.end()) continue;
      report("pass '{}' writes {}, which no pass reads afterwards", state.writer, resource->name);
    }
    for (const auto& [resource, pass] : declared_) {
      if (resource->size != SizeRule::Declared && resource->size != SizeRule::DisplaySamples) {
        continue;
      }
      if (!extents_.contains(resource)) {
        report("pass '{}' declares {}, whose size no pass states", pass, resource->name);
      }
    }
    return std::move(problems_);
  }

 private:
  template <typename... Args>
  void report(fmt::format_string<Args...> format, Args&&... args) {
    problems_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  void visitUnits(const DeclaredPass& pass, const std::vector<Binding>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Binding& a = rows[i];
      const bool buffer = a.resource->isBuffer();
      if (a.point != BindPoint::Update && buffer != isBufferPoint(a.point)) {
        report("pass '{}' binds {} as what it is not", pass.name, a.resource->name);
      }
      for (std::size_t j = i + 1; j < rows.size(); ++j) {
        const Binding& b = rows[j];
        if (a.point != b.point) continue;
        if (a.resource == b.resource) {
          report("pass '{}' declares {} twice in one step", pass.name, a.resource->name);
        } else if (hasUnit(a.point) && a.unit == b.unit) {
          report("pass '{}' binds {} and {} at one unit", pass.name, a.resource->name,
                 b.resource->name);
        }
      }
    }
  }

  void visitSizes(const DeclaredPass& pass) {
    for (const Binding& row : pass.table.bindings()) declared_.emplace(row.resource, pass.name);
    for (const Extent& e : pass.table.extents()) {
      const auto [found, added] = extents_.emplace(e.resource, e);
      const Extent& first = found->second;
      if (!added &&
          (first.bytes != e.bytes || first.size != e.size || first.samples != e.samples)) {
        report("pass '{}' states another size of {} than an earlier pass", pass.name,
               e.resource->name);
      }
    }
  }

  void visitRead(const DeclaredPass& pass, const Binding& row) {
    if (!reads(row.access) || row.access == Access::Scratch) return;
    State& s = states_[row.resource];
    const std::string_view name = row.resource->name;
    if (readsHistory(row.access)) {
      if (!s.writer.empty() && s.writer != pass.name) {
        report("pass '{}' reads the history of {}, which pass '{}' has already overwritten",
               pass.name, name, s.writer);
      }
      return;
    }
    if (s.writer.empty() && row.resource->initial == Initial::Undefined) {
      report("pass '{}' reads {}, which no earlier pass writes", pass.name, name);
    }
    s.read = true;
  }

  void visitWrite(const DeclaredPass& pass, const Binding& row) {
    if (!writes(row.access)) return;
    State& s = states_[row.resource];
    if (row.access == Access::ReadInvalidate || row.access == Access::Scratch) {
      s.writer = {};  // a later read finds nothing
      return;
    }
    const bool unread = !s.writer.empty() && s.writer != pass.name && !s.read;
    if (row.access == Access::Write && unread) {
      report("pass '{}' overwrites {} of pass '{}', which no pass has read", pass.name,
             row.resource->name, s.writer);
    }
    s.writer = pass.name;
    s.read = isReadInOtherStep(pass, row);
  }

  /// Steps may be repeated, and so a step may read what a later one wrote.
  static bool isReadInOtherStep(const DeclaredPass& pass, const Binding& written) {
    const std::vector<Binding>& rows = pass.table.bindings();
    return std::any_of(rows.begin(), rows.end(), [&](const Binding& row) {
      return row.resource == written.resource && row.step != written.step && reads(row.access);
    });
  }

  struct ByName {
    bool operator()(const Resource* a, const Resource* b) const { return a->name < b->name; }
  };
  std::map<const Resource*, State, ByName> states_;
  std::map<const Resource*, Extent, ByName> extents_;
  std::map<const Resource*, std::string_view, ByName> declared_;  ///< first pass that names it
  std::set<std::string_view> names_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> validate(std::span<const DeclaredPass> passes,
                                  std::span<const Resource* const> results) {
  Validator validator;
  for (const DeclaredPass& pass : passes) validator.visit(pass);
  return validator.finish(results);
}

}  // namespace macula::frame
