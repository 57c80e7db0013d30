// The one list of the panels in the right column, from top to bottom. A new panel is its own file and one row.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/widgets/panel_context.h"

namespace ghostforce {

std::span<const Panel> panel_catalog() noexcept;

// Called as the modes of the stage that do the same.
inline constexpr std::string_view round_panel = "Round and round";
inline constexpr std::string_view measuring_panel = "Measure the hand";

// The panels themselves, a file each.
void draw_live_values(const PanelContext& context);
void draw_safety(const PanelContext& context);
void draw_rendering(const PanelContext& context);
void draw_user(const PanelContext& context);
void draw_measure_user(const PanelContext& context);
void draw_round(const PanelContext& context);
void draw_wall_and_device(const PanelContext& context);
void draw_input(const PanelContext& context);
void draw_view_options(const PanelContext& context);
void draw_recording(const PanelContext& context);

// --- What the record button and the recording panel share ---

// Begins a recording under the name in the panel's field, or else under a proposed one; or ends the one that is made.
void toggle_recording(const PanelContext& context);

// How long it is, how large, and what it has lost.
std::string words_about(const RecordingReading& recording);

}  // namespace ghostforce
