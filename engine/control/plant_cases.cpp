// The protocol of the plant: loads, noises and clocks that control laws fail on.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/control/plant.h"
#include "engine/core/plural.h"

namespace macula::control {
namespace {

constexpr int kStep = 300;
constexpr int kAfterStep = 600;

PlantCase stepped(std::string name, std::string title, Load after) {
  PlantCase c;
  c.name = std::move(name);
  c.title = std::move(title);
  c.stepFrame = kStep;
  c.steadyFrom = kAfterStep;
  c.load = [after](int frame) { return frame < kStep ? Load{} : after; };
  return c;
}

PlantCase steady(std::string name, std::string title) {
  PlantCase c;
  c.name = std::move(name);
  c.title = std::move(title);
  return c;
}

void addLoads(std::vector<PlantCase>& cases) {
  cases.push_back(steady("steady", "steady load, 1.5 % noise"));
  cases.push_back(stepped("work-doubles", "K 20 to 40 ms", {40.0, 3.0}));
  cases.push_back(stepped("work-halves", "K 40 to 20 ms", {20.0, 3.0}));
  cases.back().load = [](int frame) { return Load{frame < kStep ? 40.0 : 20.0, 3.0}; };
  cases.push_back(stepped("fixed-rises", "C 3 to 10 ms", {20.0, 10.0}));
  PlantCase ramp = steady("ramp", "K 10 to 40 ms in 300 frames");
  ramp.load = [](int frame) {
    return Load{10.0 + 30.0 * std::clamp((frame - 300) / 300.0, 0.0, 1.0), 3.0};
  };
  cases.push_back(ramp);
  PlantCase sine = steady("sine", "K 20 +- 10 ms, a turn in 300 frames");
  sine.load = [](int frame) {
    return Load{20.0 + 10.0 * std::sin(2.0 * std::numbers::pi * frame / 300.0), 3.0};
  };
  cases.push_back(sine);
}

void addNoise(std::vector<PlantCase>& cases) {
  for (const auto& [name, title, noise] :
       {std::tuple{"noise-0", "no noise", 0.0}, {"noise-5", "5 % noise", 0.05}}) {
    cases.push_back(steady(name, title));
    cases.back().noise = noise;
  }
  cases.push_back(steady("spikes", "1 % of the frames 3 to 8 ms longer"));
  cases.back().spikeShare = 0.01;
  cases.push_back(steady("hitch", "one frame 500 ms longer"));
  cases.back().hitchMs = 500.0;
}

void addDeadTimes(std::vector<PlantCase>& cases) {
  for (int dead = 1; dead <= 6; ++dead) {
    cases.push_back(stepped(
        "dead-" + std::to_string(dead),
        "K 20 to 40 ms, times " + counted(static_cast<std::uint64_t>(dead), "frame") + " late",
        {40.0, 3.0}));
    cases.back().deadFrames = dead;
  }
}

void addClocks(std::vector<PlantCase>& cases) {
  cases.push_back(steady("tick", "a timer that counts milliseconds"));
  cases.back().tickMs = 1.0;
  cases.push_back(steady("lost-times", "a fifth of the times never comes"));
  cases.back().lostShare = 0.2;
  cases.push_back(steady("zero-times", "a tenth of the times is 0"));
  cases.back().zeroShare = 0.1;
  cases.push_back(steady("stale-times", "a fifth of the times comes twice"));
  cases.back().staleShare = 0.2;
  cases.push_back(stepped("one-time", "only the whole frame is timed; K 20 to 40 ms", {40.0, 3.0}));
  cases.back().separate = false;
  cases.push_back(steady("vsync-60", "a clock that waits for 60 Hz"));
  cases.back().refreshMs = 1000.0 / 60.0;
  cases.push_back(steady("vsync-144", "a clock that waits for 144 Hz"));
  cases.back().refreshMs = 1000.0 / 144.0;
  cases.push_back(steady("quantised", "r in steps of 1/16"));
  cases.back().resizeStep = 1.0 / 16.0;
}

void addLimits(std::vector<PlantCase>& cases) {
  PlantCase unreachable = stepped("unreachable", "C 25 ms for 300 frames, then 3 ms", {});
  unreachable.load = [](int frame) { return Load{20.0, frame < kStep ? 25.0 : 3.0}; };
  cases.push_back(unreachable);
  cases.push_back(steady("easy", "full resolution fits"));
  cases.back().load = [](int) { return Load{5.0, 3.0}; };
  cases.push_back(steady("cpu-bound", "the CPU needs 25 ms, the GPU 8"));
  cases.back().load = [](int) { return Load{5.0, 3.0}; };
  cases.back().cpuMs = 25.0;
}

}  // namespace

std::vector<PlantCase> plantCases() {
  std::vector<PlantCase> cases;
  addLoads(cases);
  addNoise(cases);
  addDeadTimes(cases);
  addClocks(cases);
  addLimits(cases);
  return cases;
}

}  // namespace macula::control
