// Nothing that was pressed, typed or clicked within one slow frame is lost or changes its order.
#include "engine/window/input_queue.h"

#include <gtest/gtest.h>

#include "engine/window/held_keys.h"

namespace macula::window {
namespace {

using Kind = InputEvent::Kind;

InputEvent key(int code, bool down) {
  return {.kind = Kind::Key, .code = code, .down = down};
}

TEST(InputQueue, KeepsAKeyThatCameAndWent) {
  InputQueue queue;
  queue.push(key('A', true));
  queue.push(key('A', false));
  queue.push(key('A', true));
  for (const bool down : {true, false, true}) {
    const auto event = queue.take();
    ASSERT_TRUE(event);
    EXPECT_EQ(event->code, 'A');
    EXPECT_EQ(event->down, down);
  }
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.take());
}

TEST(InputQueue, TextBelongsToThePressBeforeIt) {
  InputQueue queue;
  queue.push(key('A', true));
  queue.type(U'a');
  queue.push(key('A', false));
  queue.type(U'\u00e9');  // composed: no key is known
  queue.type(U'b');
  EXPECT_EQ(queue.take()->text, U"a");
  EXPECT_EQ(queue.take()->text, U"");
  const auto composed = queue.take();
  EXPECT_EQ(composed->kind, Kind::Text);
  EXPECT_EQ(composed->text, U"\u00e9b");
}

TEST(InputQueue, MovesBecomeOneButNotAcrossAClick) {
  InputQueue queue;
  const auto move = [&](double x) { queue.push({.kind = Kind::Pointer, .place = {x, 0.0}}); };
  move(1.0);
  move(2.0);
  queue.push({.kind = Kind::Button, .code = 0, .down = true});
  move(3.0);
  EXPECT_EQ(queue.take()->place.x, 2.0);
  EXPECT_EQ(queue.take()->kind, Kind::Button);
  EXPECT_EQ(queue.take()->place.x, 3.0);
  EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, WheelStepsAddUp) {
  InputQueue queue;
  for (int i = 0; i < 3; ++i) queue.push({.kind = Kind::Wheel, .place = {0.0, 1.0}});
  EXPECT_EQ(queue.take()->place.y, 3.0);
  EXPECT_TRUE(queue.empty());
}

TEST(HeldKeys, ATapCountsForItsFrame) {
  HeldKeys keys;
  keys.press('W');
  keys.release('W');
  EXPECT_TRUE(keys.held('W'));
  keys.nextFrame();
  EXPECT_FALSE(keys.held('W'));
}

TEST(HeldKeys, AHeldKeyCountsUntilItIsReleased) {
  HeldKeys keys;
  keys.press('W');
  keys.nextFrame();
  EXPECT_TRUE(keys.held('W'));
  keys.release('W');
  EXPECT_FALSE(keys.held('W'));
}

TEST(HeldKeys, WhatIsHeldWhileTextIsTypedCountsNoMore) {
  HeldKeys keys;
  keys.press('W');
  keys.nextFrame();
  keys.press('A');
  keys.letGo();
  EXPECT_FALSE(keys.held('W'));
  EXPECT_TRUE(keys.held('A')) << "it was pressed before the text";
}

}  // namespace
}  // namespace macula::window
