// Reports of a SpaceMouse: what it says moves the goal no faster and no farther than promised.
#include <cmath>

#include <glm/geometric.hpp>

#include "device/spacemouse/spacemouse_input.h"
#include "device/spacemouse/spacemouse_report.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes({data, size});
  SpaceMouseSettings settings;
  SpaceMouseState state;
  SpaceMouseMotion motion;
  SpaceMouseReading reading;
  reading.connection = 1;
  constexpr double rate_hz = 1000.0;
  Vector<2> before{0.0};
  motion.restart(before);
  while (!bytes.empty()) {
    const std::uint8_t head = bytes.next();
    if (head >= 0xF0) {  // plugged out or in, other settings
      reading.connection = head % 4;
      settings.mode = static_cast<SpaceMouseSettings::Mode>(bytes.next() % 2);
      settings.up = static_cast<SpaceMouseSettings::Up>(bytes.next() % 2);
      settings.dead_zone = bytes.next() / 256.0;
      settings.reach_m = bytes.next() / 64.0;
      settings.speed_m_s = bytes.next() / 16.0;
      require(is_valid(settings), "these settings are valid");
    } else {
      const SpaceMouseState before_report = state;
      const auto report = bytes.take(head % 16);
      if (take_report(report, state)) {
        ++reading.reports;
      } else {
        require(state == before_report, "a report that is none changes nothing");
      }
    }
    // Of any size, as if a device counted to more than others do.
    for (std::size_t i = 0; i < reading.axes.size(); ++i) reading.axes[i] = state.axes[i] / 350.0;
    for (int tick = 0; tick < 8; ++tick) {
      const Vector<2> goal = motion.step(reading, settings, rate_hz);
      require(std::isfinite(goal.x) && std::isfinite(goal.y), "the goal is a place");
      require(std::abs(goal.x) <= SpaceMouseMotion::farthest_m && std::abs(goal.y) <= SpaceMouseMotion::farthest_m,
              "the goal stays near");
      require(glm::length(goal - before) * rate_hz <= SpaceMouseMotion::fastest_m_s * (1.0 + 1e-9),
              "the goal goes no faster than promised");
      require(reading.connected() || goal == before, "without a device the goal stays");
      before = goal;
    }
  }
  return 0;
}
