// What the panel Input shows of a SpaceMouse: which it is, or why there is none; its cap, live; its settings, which are
// the session's.
#pragma once

#include <string_view>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// What there is to do about each trouble, which the two fronts of the program answer differently.
struct SpaceMouseWords {
  std::string_view absent;
  std::string_view not_allowed;
  std::string_view not_opened;
};

void draw_spacemouse(const PanelContext& context, const SpaceMouseReading& reading, const SpaceMouseWords& words);

}  // namespace ghostforce
