#include "app/panels/panel_catalog.h"

#include <array>

namespace ghostforce {
namespace {

bool has_motors(const LoopReading& loop) {
  return loop.motors.has_motors;
}

// Until the button in the bar has begun one there is nothing to see, and a small window has no room for that.
bool has_recording(const LoopReading& loop) {
  return !loop.recording.path.empty();
}

constexpr std::array panels{
    Panel{"Live", draw_live_values, false},
    Panel{"Safety", draw_safety, false, has_motors},
    Panel{"Rendering", draw_rendering, false},
    Panel{"User", draw_user, false},
    Panel{.title = "Measure the hand", .draw = draw_measure_user, .can_wait = true, .is_extra = true},
    Panel{.title = energy_panel, .draw = draw_energy, .can_wait = true, .is_extra = true},
    Panel{"Wall and device", draw_wall_and_device, false},
    Panel{"Input", draw_input, true},
    Panel{"View", draw_view_options, true},
    Panel{.title = "Recording", .draw = draw_recording, .can_wait = true, .is_there = has_recording, .is_extra = true},
};

constexpr double room_for_all = 780.0;  // height of the window [points]

}  // namespace

std::span<const Panel> panel_catalog() noexcept {
  return panels;
}

std::set<std::string, std::less<>> panels_folded_at_first(double height) {
  std::set<std::string, std::less<>> folded;
  for (const Panel& panel : panels) {
    if (panel.is_extra || (panel.can_wait && height < room_for_all)) folded.emplace(panel.title);
  }
  return folded;
}

}  // namespace ghostforce
