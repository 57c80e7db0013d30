#include "app/view/compose.h"

#include <array>
#include <utility>

#include "app/view/layers.h"

namespace ghostforce {

Marks compose(const View& view, Marks earlier) {
  Marks marks = std::move(earlier);
  marks.clear();
  add_wall(view, marks);
  if (view.options.trails) add_trails(view, marks);
  add_loop(view, marks);
  add_guides(view, marks);
  if (view.options.predictions) add_predictions(view, marks);
  add_hand(view, marks);
  add_target(view, marks);
  for_each_shown(view, [&](StrategyId id) {
    add_arrows(view, id, marks);
    add_markers(view, id, marks);
  });
  add_goal(view, marks);
  add_handles(view, marks);
  add_labels(view, marks);
  return marks;
}

namespace {

constexpr std::array compare_modes{
    CompareMode{Compare::overlay, "overlay", "Overlay"},
    CompareMode{Compare::side_by_side, "side-by-side", "Side by side"},
    CompareMode{Compare::active_only, "active-only", "Active only"},
};

}  // namespace

std::span<const CompareMode> compare_catalog() noexcept {
  return compare_modes;
}

std::string_view compare_name(Compare id) noexcept {
  return compare_modes[static_cast<std::size_t>(id)].name;
}

std::optional<Compare> find_compare(std::string_view name) noexcept {
  for (const CompareMode& mode : compare_modes) {
    if (mode.name == name) return mode.id;
  }
  return std::nullopt;
}

}  // namespace ghostforce
