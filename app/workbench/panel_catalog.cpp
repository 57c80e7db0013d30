#include "app/workbench/panel_catalog.h"

#include <array>
#include <limits>

namespace ghostforce {
namespace {

bool has_motors(const LoopReading& loop) {
  return loop.motors.has_motors;
}

bool& news_of_measurement(const WidgetMemory& memory) {
  return memory.measurement_has_news;
}

bool& news_of_circle(const WidgetMemory& memory) {
  return memory.circle_has_news;
}

// From these heights on there is room for the panel beside all that open earlier [points].
constexpr double room_for_the_device = 700.0;
constexpr double room_for_the_input = 780.0;
constexpr double room_for_the_view = 940.0;
constexpr double when_asked = std::numeric_limits<double>::infinity();

constexpr std::array panels{
    Panel{"Live values", draw_live_values},
    Panel{.title = "Safety", .draw = draw_safety, .is_there = has_motors},
    Panel{"Rendering", draw_rendering},
    Panel{"Hand", draw_user},
    Panel{.title = measuring_panel, .draw = draw_measure_user, .opens_from = when_asked, .news = news_of_measurement},
    Panel{.title = round_panel, .draw = draw_round, .opens_from = when_asked, .news = news_of_circle},
    Panel{"Wall and device", draw_wall_and_device, room_for_the_device},
    Panel{"Input", draw_input, room_for_the_input},
    Panel{"View", draw_view_options, room_for_the_view},
    Panel{"Recording", draw_recording, when_asked},
};

}  // namespace

std::span<const Panel> panel_catalog() noexcept {
  return panels;
}

}  // namespace ghostforce
