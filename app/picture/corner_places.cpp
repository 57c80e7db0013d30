#include "app/picture/corner_places.h"

#include <algorithm>
#include <utility>

namespace ghostforce {
namespace {

constexpr double corner_fade_s = 0.25;
// So long does it wait until it comes back, and at rest until it goes to a better place.
constexpr double corner_comes_back_s = 0.3;
constexpr double corner_moves_on_s = 0.7;

// In points of the design.
constexpr double corner_roomy_air = 30.0;  // words beside marks have room, too
constexpr double corner_air = 6.0;
constexpr double corner_least_air = 3.0;  // as long as it stands there

}  // namespace

std::optional<CornerPlace> place_in_corner(const std::vector<ScreenBox>& places, std::size_t places_of_form,
                                           LabelPlacer& labels, CornerMemory& memory) {
  const LabelObstacles& obstacles = labels.obstacles();
  const auto points = [&](double of_design) { return of_design * labels.unit(); };
  const auto fits = [&](const ScreenBox& box) {
    return box.least.x >= 0.0 && box.least.y >= 0.0 && box.most.x <= labels.size().x && box.most.y <= labels.size().y;
  };
  const auto first_of = [&](std::size_t form, double air, Clearance clearance) -> std::optional<std::size_t> {
    for (std::size_t i = form; i < form + places_of_form; ++i) {
      if (fits(places[i]) && obstacles.is_free(places[i], points(air), clearance)) return i;
    }
    return std::nullopt;
  };
  const auto best = [&]() -> std::optional<std::size_t> {
    for (const Clearance clearance : {Clearance::always, Clearance::if_possible}) {
      for (std::size_t form = 0; form < places.size(); form += places_of_form) {
        for (const double air : {corner_roomy_air, corner_air}) {
          if (const auto found = first_of(form, air, clearance)) return found;
        }
      }
    }
    return std::nullopt;
  };
  const auto move_to = [&](std::size_t place) {
    memory = {.place = place, .strength = labels.is_first() ? 1.0 : 0.0, .picture = memory.picture};
  };

  if (labels.is_first()) memory = {};
  const std::uint64_t now = obstacles.signature();
  const bool is_still = std::exchange(memory.picture, now) == now;
  memory.strength = std::min(1.0, memory.strength + labels.interval_s() / corner_fade_s);
  const bool can_stay = memory.place && *memory.place < places.size() && fits(places[*memory.place]) &&
                        obstacles.is_free(places[*memory.place], points(corner_least_air), Clearance::if_possible);
  const bool may_move = labels.is_first() || !can_stay || is_still;
  const std::optional<std::size_t> found = may_move ? best() : std::nullopt;
  memory.is_best = may_move;
  if (!can_stay) memory.place.reset();
  if (!found || found == memory.place) {
    memory.waited_s = 0.0;
  } else {
    // So that something is on its way, however short the first interval is.
    memory.waited_s += std::max(labels.interval_s(), 1e-6);
    const double wait_s = labels.is_first() ? 0.0 : can_stay ? corner_moves_on_s : corner_comes_back_s;
    if (memory.waited_s >= wait_s) move_to(*found);
  }
  if (!memory.place) return std::nullopt;
  labels.keep_clear(places[*memory.place]);
  return CornerPlace{*memory.place, memory.strength};
}

ScreenBox box_in_corner(Corner corner, const Vector<2>& extent, const Vector<2>& size, double margin) {
  const bool is_right = corner == Corner::upper_right || corner == Corner::lower_right;
  const bool is_low = corner == Corner::lower_left || corner == Corner::lower_right;
  const Vector<2> least{is_right ? size.x - margin - extent.x : margin, is_low ? size.y - margin - extent.y : margin};
  return {least, least + extent};
}

}  // namespace ghostforce
