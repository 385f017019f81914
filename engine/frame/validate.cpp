#include "engine/frame/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace macula::frame {
namespace {

struct State {
  std::string_view writer;  ///< last pass that wrote it; empty: none
  bool read = false;        ///< since that write
  bool everRead = false;
  bool isHistory = false;
};

class Validator {
 public:
  void visit(const DeclaredPass& pass) {
    if (!names_.insert(pass.name).second) report("pass '{}' stands twice in the frame", pass.name);
    std::set<Resource> seen;
    for (const Touch& touch : pass.touches) {
      if (!seen.insert(touch.resource).second) {
        report("pass '{}' declares {} twice", pass.name, nameOf(touch.resource));
      }
    }
    // What a pass reads, it reads before it writes.
    for (const Touch& touch : pass.touches) visitRead(pass, touch);
    for (const Touch& touch : pass.touches) visitWrite(pass, touch);
  }

  std::vector<std::string> finish(std::span<const Resource> results) {
    for (std::size_t i = 0; i < kResourceCount; ++i) {
      const State& state = states_[i];
      const auto resource = static_cast<Resource>(i);
      if (state.writer.empty() || state.read || state.isHistory) continue;
      if (std::find(results.begin(), results.end(), resource) != results.end()) continue;
      report("pass '{}' writes {}, which nobody reads afterwards", state.writer, nameOf(resource));
    }
    return std::move(problems_);
  }

 private:
  template <typename... Args>
  void report(fmt::format_string<Args...> format, Args&&... args) {
    problems_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  State& state(Resource r) { return states_[static_cast<std::size_t>(r)]; }

  void visitRead(const DeclaredPass& pass, const Touch& touch) {
    State& s = state(touch.resource);
    if (touch.access == Access::ReadHistory || touch.access == Access::Carry) {
      s.isHistory = true;
      if (!s.writer.empty()) {
        report("pass '{}' reads the history of {}, which pass '{}' has already overwritten",
               pass.name, nameOf(touch.resource), s.writer);
      }
      return;
    }
    if (touch.access == Access::Write || touch.access == Access::Keep ||
        touch.access == Access::Scratch) {
      return;
    }
    if (s.writer.empty() && infoOf(touch.resource).clear == ClearKind::Never) {
      report("pass '{}' reads {}, which no earlier pass writes", pass.name, nameOf(touch.resource));
    }
    s.read = true;
  }

  void visitWrite(const DeclaredPass& pass, const Touch& touch) {
    if (touch.access == Access::Read || touch.access == Access::ReadHistory) return;
    State& s = state(touch.resource);
    if (touch.access == Access::Consume || touch.access == Access::Scratch) {
      s.writer = {};  // a later read finds nothing
      return;
    }
    if (touch.access == Access::Write && !s.writer.empty() && !s.read) {
      report("pass '{}' overwrites {} of pass '{}', which nobody has read", pass.name,
             nameOf(touch.resource), s.writer);
    }
    s.writer = pass.name;
    s.read = false;
  }

  std::array<State, kResourceCount> states_{};
  std::set<std::string_view> names_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> validate(std::span<const DeclaredPass> passes,
                                  std::span<const Resource> results) {
  Validator validator;
  for (const DeclaredPass& pass : passes) validator.visit(pass);
  return validator.finish(results);
}

}  // namespace macula::frame
