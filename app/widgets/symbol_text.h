// Words with the paper's symbols in them: what follows the _ of k_r, q_h or f_r,k−1 is drawn small and lowered, because
// Unicode has no such letters. In ImGui's current font; within a frame, but for symbol_runs().
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace ghostforce {

struct SymbolRun {
  std::string_view text;
  bool is_subscript;
};

// The pieces that words are drawn in, in their order, without the _ of symbols. A symbol is a single letter with an
// index; names with _ in them, such as my_scene.toml, are no symbols. Pure, any thread.
std::vector<SymbolRun> symbol_runs(std::string_view words);

// In one line.
float symbol_text_width(std::string_view words);
void draw_symbol_text(ImDrawList& draw_list, ImVec2 corner, ImU32 colour, std::string_view words);

// Broken into lines of that width at most [points]; 0: only where the words are.
ImVec2 symbol_text_size(std::string_view words, float width);
// What of the words has room in a box [points]: whole words, and a sign where there were more.
std::string as_much_as_fits(std::string words, ImVec2 room);
void draw_symbol_lines(ImDrawList& draw_list, ImVec2 corner, ImU32 colour, std::string_view words, float width);

// As an item at the cursor, like ImGui::TextUnformatted().
void symbol_text(std::string_view words, float width = 0.0F);

}  // namespace ghostforce
