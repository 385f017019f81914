#include "explorer.h"

#include <setjmp.h>  // _setjmp(), which leaves signal masks alone: swapcontext() makes a system call
#include <ucontext.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>

namespace macula::model {
namespace {

constexpr std::size_t kStackBytes = 64 * 1024;  // the threads call a handful of small functions

enum class Operation { Load, Store, Barrier, Exchange, None };

struct Place {
  std::vector<std::uint32_t> values;  ///< held since the oldest that a thread may still read
  std::size_t first = 0;              ///< number of values[0] among all that the place has held
  [[nodiscard]] std::size_t newest() const { return first + values.size() - 1; }
};

struct Waiting {
  std::size_t place;
  std::uint32_t value;
};

/// A thread, stopped before an access.
struct Fiber {
  ucontext_t context{};  ///< where it begins
  jmp_buf stopped{};     ///< where it goes on
  bool begun = false;
  std::unique_ptr<std::array<char, kStackBytes>> stack =
      std::make_unique<std::array<char, kStackBytes>>();
  const Explorer::Thread* run = nullptr;
  Operation operation = Operation::None;
  std::size_t place = 0;
  std::uint32_t value = 0;
  bool ended = false;
  std::vector<Waiting> stores;      ///< not committed, in program order
  std::vector<std::size_t> oldest;  ///< by place: number of the oldest value that a load may give
  std::vector<std::uint32_t> read;  ///< what its loads and exchanges gave: all that it knows
};

/// What can happen next.
struct Action {
  std::size_t fiber;
  bool commit;         ///< of the oldest store to `place`; else the fiber's access
  std::size_t place;   ///< of a commit
  std::size_t number;  ///< of the value that a load gives
};

class Search {
 public:
  Search(const std::vector<std::uint32_t>& memory, const std::vector<Explorer::Thread>& threads,
         const Explorer::Check& check)
      : initial_(memory), threads_(threads), check_(check), fibers_(threads.size()) {}

  Explorer::Result run() {
    while (result_.fault.empty()) {
      followOneOrder();
      while (!choices_.empty() && choices_.back().first + 1 == choices_.back().second) {
        choices_.pop_back();
      }
      if (choices_.empty()) break;
      ++choices_.back().first;
    }
    result_.states = seen_.size();
    return result_;
  }

  // Called on the stack of a fiber.
  std::uint32_t access(Operation operation, std::size_t place, std::uint32_t value) {
    Fiber& self = fibers_[current_];
    self.operation = operation;
    self.place = place;
    self.value = value;
    stop(self);
    return self.value;
  }
  [[nodiscard]] std::size_t current() const { return current_; }
  static void enter() {
    Fiber& self = active->fibers_[active->current_];
    (*self.run)();
    self.ended = true;
    self.operation = Operation::None;
    active->stop(self);
  }

  static Search* active;

 private:
  void start() {
    places_.assign(initial_.size(), {});
    for (std::size_t i = 0; i < initial_.size(); ++i) places_[i].values = {initial_[i]};
    for (std::size_t i = 0; i < fibers_.size(); ++i) {
      Fiber& fiber = fibers_[i];
      getcontext(&fiber.context);
      fiber.context.uc_stack.ss_sp = fiber.stack->data();
      fiber.context.uc_stack.ss_size = fiber.stack->size();
      fiber.context.uc_link = nullptr;
      makecontext(&fiber.context, &Search::enter, 0);
      fiber.run = &threads_[i];
      fiber.begun = fiber.ended = false;
      fiber.stores.clear();
      fiber.read.clear();
      fiber.oldest.assign(initial_.size(), 0);
      resume(i);
    }
  }

  void resume(std::size_t index) {
    current_ = index;
    Fiber& fiber = fibers_[index];
    if (_setjmp(main_) != 0) return;
    if (fiber.begun) _longjmp(fiber.stopped, 1);
    fiber.begun = true;
    setcontext(&fiber.context);
  }
  void stop(Fiber& fiber) {
    if (_setjmp(fiber.stopped) == 0) _longjmp(main_, 1);
  }

  /// Stores only enter the thread's own list, and an early barrier allows all that a late one does:
  /// neither needs a choice.
  void runWithoutChoice() {
    for (std::size_t i = 0; i < fibers_.size(); ++i) {
      Fiber& fiber = fibers_[i];
      for (;;) {
        if (fiber.operation == Operation::Store) {
          fiber.stores.push_back({fiber.place, fiber.value});
        } else if (fiber.operation == Operation::Barrier && fiber.stores.empty()) {
          for (std::size_t p = 0; p < places_.size(); ++p) fiber.oldest[p] = places_[p].newest();
        } else {
          break;
        }
        resume(i);
      }
    }
    for (std::size_t p = 0; p < places_.size(); ++p) forgetUnreadable(p);
  }

  void forgetUnreadable(std::size_t place) {
    std::size_t oldest = places_[place].newest();
    for (const Fiber& fiber : fibers_) {
      if (!fiber.ended)
        oldest = std::min(oldest, std::max(fiber.oldest[place], places_[place].first));
    }
    Place& p = places_[place];
    if (p.first == oldest) return;
    p.values.erase(p.values.begin(),
                   p.values.begin() + static_cast<std::ptrdiff_t>(oldest - p.first));
    p.first = oldest;
  }

  [[nodiscard]] std::vector<Action> actions(bool isNew) {
    std::vector<Action> all;
    for (std::size_t i = 0; i < fibers_.size(); ++i) {
      const Fiber& fiber = fibers_[i];
      std::vector<std::size_t> committed;
      for (const Waiting& store : fiber.stores) {
        if (std::ranges::find(committed, store.place) != committed.end()) continue;
        committed.push_back(store.place);
        all.push_back({i, true, store.place, 0});
      }
      const bool own = std::ranges::find(committed, fiber.place) != committed.end();
      if (fiber.operation == Operation::Exchange) {
        const bool taken = fiber.value == 1 && places_[fiber.place].values.back() == 1;
        if (taken && isNew) ++result_.waits;
        if (!taken) all.push_back({i, false, 0, 0});
      } else if (fiber.operation == Operation::Load && own) {
        all.push_back({i, false, 0, 0});
      } else if (fiber.operation == Operation::Load) {
        const Place& place = places_[fiber.place];
        for (std::size_t n = std::max(fiber.oldest[fiber.place], place.first); n <= place.newest();
             ++n) {
          all.push_back({i, false, 0, n});
        }
      }
    }
    return all;
  }

  void commit(Fiber& fiber, std::size_t place) {
    const auto store = std::ranges::find(fiber.stores, place, &Waiting::place);
    places_[place].values.push_back(store->value);
    fiber.oldest[place] = places_[place].newest();
    fiber.stores.erase(store);
  }

  void perform(const Action& action) {
    Fiber& fiber = fibers_[action.fiber];
    if (action.commit) return commit(fiber, action.place);
    Place& place = places_[fiber.place];
    if (fiber.operation == Operation::Exchange) {
      const std::uint32_t old = place.values.back();
      place.values = {fiber.value};  // which only exchanges touch, and they see the newest value
      ++place.first;
      fiber.value = old;
    } else {
      const auto own = std::find_if(fiber.stores.rbegin(), fiber.stores.rend(),
                                    [&](const Waiting& s) { return s.place == fiber.place; });
      if (own != fiber.stores.rend()) {
        fiber.value = own->value;
      } else {
        fiber.value = place.values[action.number - place.first];
        fiber.oldest[fiber.place] = action.number;
      }
    }
    fiber.read.push_back(fiber.value);
    resume(action.fiber);
  }

  [[nodiscard]] std::u32string state() const {
    std::u32string words;
    const auto add = [&](std::size_t word) { words.push_back(static_cast<char32_t>(word)); };
    for (const Place& place : places_) {
      add(place.values.size());
      words.append(place.values.begin(), place.values.end());
    }
    for (const Fiber& fiber : fibers_) {
      add(fiber.read.size());
      words.append(fiber.read.begin(), fiber.read.end());
      add(fiber.stores.size());
      for (const Waiting& store : fiber.stores) {
        add(store.place);
        add(store.value);
      }
      for (std::size_t p = 0; p < places_.size() && !fiber.ended; ++p) {
        add(std::max(fiber.oldest[p], places_[p].first) - places_[p].first);
      }
    }
    return words;
  }

  void end() {
    ++result_.outcomes;
    std::vector<std::uint32_t> memory;
    for (const Place& place : places_) memory.push_back(place.values.back());
    for (const Fiber& fiber : fibers_) {
      if (!fiber.ended) {
        result_.fault = "a thread waits for ever";
        return;
      }
    }
    result_.fault = check_(memory);
  }

  /// Repeats the choices made so far, then takes the first of each new one until the end or a state
  /// that was seen.
  void followOneOrder() {
    start();
    for (std::size_t depth = 0;; ++depth) {
      runWithoutChoice();
      const bool isNew = depth >= choices_.size();
      if (isNew && !seen_.insert(state()).second) return;
      const std::vector<Action> all = actions(isNew);
      if (all.empty()) return end();
      if (isNew) choices_.emplace_back(0, all.size());
      perform(all[choices_[depth].first]);
    }
  }

  const std::vector<std::uint32_t>& initial_;
  const std::vector<Explorer::Thread>& threads_;
  const Explorer::Check& check_;
  std::vector<Fiber> fibers_;
  std::vector<Place> places_;
  std::vector<std::pair<std::size_t, std::size_t>> choices_;  ///< taken, of how many
  std::unordered_set<std::u32string> seen_;
  Explorer::Result result_;
  jmp_buf main_{};
  std::size_t current_ = 0;
};

Search* Search::active = nullptr;

}  // namespace

Explorer::Result Explorer::explore(const std::vector<std::uint32_t>& memory,
                                   const std::vector<Thread>& threads, const Check& check) {
  Search search(memory, threads, check);
  Search::active = &search;
  return search.run();
}

std::size_t Explorer::thread() {
  return Search::active->current();
}
std::uint32_t Explorer::load(std::size_t place) {
  return Search::active->access(Operation::Load, place, 0);
}
void Explorer::store(std::size_t place, std::uint32_t value) {
  (void)Search::active->access(Operation::Store, place, value);
}
void Explorer::barrier() {
  (void)Search::active->access(Operation::Barrier, 0, 0);
}
std::uint32_t Explorer::exchangeLock(std::size_t place, std::uint32_t value) {
  return Search::active->access(Operation::Exchange, place, value);
}

}  // namespace macula::model
