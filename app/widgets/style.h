// Dresses Dear ImGui in a theme at a UI scale.
#pragma once

#include "app/picture/theme.h"

namespace ghostforce {

void apply_style(const Theme& theme, float scale);

}  // namespace ghostforce
