// Keys that are held down, for movement: a key that came and went within a frame counts for it.
#pragma once

#include <set>

namespace macula::window {

class HeldKeys {
 public:
  void press(int key) {
    down_.insert(key);
    pressed_.insert(key);
  }
  void release(int key) { down_.erase(key); }
  /// Nothing is held any more, as where the keyboard goes to a text field; what was pressed in this
  /// frame still counts for it.
  void letGo() { down_.clear(); }
  /// Whether the key is down, or was pressed in this frame.
  [[nodiscard]] bool held(int key) const { return down_.contains(key) || pressed_.contains(key); }
  /// The frame has moved by what was held.
  void nextFrame() { pressed_.clear(); }

 private:
  std::set<int> down_;
  std::set<int> pressed_;  ///< in this frame
};

}  // namespace macula::window
