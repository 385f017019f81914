// Work on a thread of its own, whose result is fetched between two frames.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <utility>

namespace macula::tools {

/// One piece of work at a time. The destructor waits for it.
template <typename Result>
class BackgroundJob {
 public:
  /// Must not be called while busy().
  void start(std::function<Result()> work) {
    future_ = std::async(std::launch::async, std::move(work));
  }
  /// From start() to take().
  [[nodiscard]] bool busy() const { return future_.valid(); }
  /// Whether take() returns at once.
  [[nodiscard]] bool ready() const {
    return busy() && future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  /// @throws what the work threw
  Result take() { return future_.get(); }

 private:
  std::future<Result> future_;
};

}  // namespace macula::tools
