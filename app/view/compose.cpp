#include "app/view/compose.h"

#include "app/view/layers.h"

namespace ghostforce {

Marks compose(const View& view) {
  Marks marks;
  add_wall(view, marks);
  add_trails(view, marks);
  add_arrows(view, marks);
  add_markers(view, marks);
  add_guides(view, marks);
  add_labels(view, marks);
  return marks;
}

std::string_view role_name(Role role) noexcept {
  constexpr std::array names{"wall",          "hatching",    "grid",   "motor_axis", "trail",   "hand_spring",
                             "tracking_link", "goal",        "device", "proxy",      "contact", "force",
                             "ghost_force",   "proxy_drift", "scale",  "legend"};
  static_assert(names.size() == static_cast<std::size_t>(Role::legend) + 1);
  return names[static_cast<std::size_t>(role)];
}

}  // namespace ghostforce
