// What is asked of and told to a tracker once it is open, on a thread of its own.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "engine/gaze/hid/layout.h"
#include "engine/gaze/hid/link.h"

namespace macula::gaze::hid {

/// Reads the size of the calibrated display and asks the tracker to stream. A device may never
/// answer; the kernel then waits five seconds for each request, while the reading thread goes on.
class Exchange {
 public:
  struct Outcome {
    bool done = false;                   ///< every request was answered, refused or given up
    std::optional<glm::dvec2> screenMm;  ///< as soon as it is known
    std::string problem;                 ///< what was not answered; may be empty
  };

  /// Starts a thread that keeps the exchange and the link alive until its last request has ended,
  /// and that is not waited for.
  static std::shared_ptr<Exchange> start(std::shared_ptr<const HidrawLink> link,
                                         const TrackerLayout& layout);

  Exchange(std::shared_ptr<const HidrawLink> link, TrackerLayout layout);

  [[nodiscard]] Outcome outcome() const;
  /// No further request is begun.
  void abandon();

 private:
  void run();
  void askScreen();
  void askToStream();
  void addProblem(const std::string& problem);
  [[nodiscard]] bool isAbandoned() const;

  const std::shared_ptr<const HidrawLink> link_;
  const TrackerLayout layout_;
  mutable std::mutex mutex_;
  Outcome outcome_;
  bool abandoned_ = false;
};

}  // namespace macula::gaze::hid
