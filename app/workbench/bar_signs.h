// Signs that everybody knows, drawn because the font has none of them. `unit` is half a sign's height.
#pragma once

#include <imgui.h>

namespace ghostforce {

using DrawSign = void (*)(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);

void draw_play_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_pause_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_step_back_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_step_on_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_reset_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_record_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_undo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);
void draw_redo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);

}  // namespace ghostforce
