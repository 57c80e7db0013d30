// The one list of the panels in the right column, from top to bottom. A new panel is its own file and one row.
#pragma once

#include <span>

#include "app/panels/panel.h"

namespace ghostforce {

std::span<const Panel> panel_catalog() noexcept;

// The panels themselves, a file each.
void draw_live_values(const PanelContext& context);
void draw_rendering(const PanelContext& context);
void draw_user(const PanelContext& context);
void draw_wall_and_device(const PanelContext& context);
void draw_keys(const PanelContext& context);

// Above and below the scene.
void draw_strategy_bar(const PanelContext& context);
void draw_status_bar(const PanelContext& context);

}  // namespace ghostforce
