#include "app/widgets/symbol_text.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr float index_size = 0.74F;  // of the letters
constexpr float lowered = 0.13F;     // of their height
constexpr float air = 0.06F;         // behind an index, of their height

bool is_ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_index_letter(char c) {
  return is_ascii_letter(c) || (c >= '0' && c <= '9');
}

// Of a letter, whatever its bytes in UTF-8.
bool is_in_word(char c) {
  return is_index_letter(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80U;
}

std::size_t length_of_letter(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

// "r", "ta", "h,k" and "r,k−1"; 0 where it is no index.
std::size_t length_of_index(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_index_letter(text[end])) ++end;
  if (end == 0 || end > 2) return 0;
  constexpr std::array<std::string_view, 2> times{",k−1", ",k"};
  const auto time =
      std::ranges::find_if(times, [&](std::string_view each) { return text.substr(end).starts_with(each); });
  if (time != times.end()) end += time->size();
  return end < text.size() && is_in_word(text[end]) ? 0 : end;
}

float width_of(const SymbolRun& run) {
  const float size = ImGui::GetFontSize() * (run.is_subscript ? index_size : 1.0F);
  const float width =
      ImGui::GetFont()->CalcTextSizeA(size, 1e9F, 0.0F, run.text.data(), run.text.data() + run.text.size()).x;
  return run.is_subscript ? width + air * ImGui::GetFontSize() : width;
}

// As many letters as there is room for, and one at least.
std::string_view beginning_of(std::string_view word, float width) {
  std::size_t end = length_of_letter(word);
  while (end < word.size()) {
    const std::size_t next = end + length_of_letter(word.substr(end));
    if (symbol_text_width(word.substr(0, next)) > width) break;
    end = next;
  }
  return word.substr(0, end);
}

std::vector<std::string_view> lines_of(std::string_view words, float width) {
  std::vector<std::string_view> lines;
  for (;;) {
    const std::size_t paragraph_end = std::min(words.find('\n'), words.size());
    std::string_view rest = words.substr(0, paragraph_end);
    do {
      std::string_view line = rest;
      while (width > 0.0F && symbol_text_width(line) > width) {
        const std::size_t space = line.rfind(' ');
        if (space == std::string_view::npos || space == 0) {
          line = beginning_of(line, width);
          break;
        }
        line = line.substr(0, space);
      }
      lines.push_back(line);
      rest.remove_prefix(line.size());
      while (rest.starts_with(' ')) rest.remove_prefix(1);
    } while (!rest.empty());
    if (paragraph_end == words.size()) return lines;
    words.remove_prefix(paragraph_end + 1);
  }
}

ImVec2 size_of(const std::vector<std::string_view>& lines) {
  float width = 0.0F;
  for (const std::string_view line : lines) width = std::max(width, symbol_text_width(line));
  return {width, ImGui::GetTextLineHeight() * static_cast<float>(lines.size())};
}

}  // namespace

std::vector<SymbolRun> symbol_runs(std::string_view words) {
  std::vector<SymbolRun> runs;
  std::size_t begin = 0;
  for (std::size_t at = words.find('_'); at != std::string_view::npos; at = words.find('_', at + 1)) {
    const bool has_letter = at > begin && is_ascii_letter(words[at - 1]);
    const bool is_single = has_letter && (at - 1 == begin || !is_in_word(words[at - 2]));
    const std::size_t length = is_single ? length_of_index(words.substr(at + 1)) : 0;
    if (length == 0) continue;
    runs.push_back({words.substr(begin, at - begin), false});
    runs.push_back({words.substr(at + 1, length), true});
    begin = at + 1 + length;
  }
  if (begin < words.size()) runs.push_back({words.substr(begin), false});
  return runs;
}

float symbol_text_width(std::string_view words) {
  float width = 0.0F;
  for (const SymbolRun& run : symbol_runs(words)) width += width_of(run);
  return width;
}

void draw_symbol_text(ImDrawList& draw_list, ImVec2 corner, ImU32 colour, std::string_view words) {
  const float size = ImGui::GetFontSize();
  const ImFontBaked& baked = *ImGui::GetFontBaked();
  const float ascent = baked.Ascent / baked.Size;
  const float drop = (lowered + ascent * (1.0F - index_size)) * size;
  for (const SymbolRun& run : symbol_runs(words)) {
    const ImVec2 at{corner.x, corner.y + (run.is_subscript ? drop : 0.0F)};
    draw_list.AddText(ImGui::GetFont(), size * (run.is_subscript ? index_size : 1.0F), at, colour, run.text.data(),
                      run.text.data() + run.text.size());
    corner.x += width_of(run);
  }
}

ImVec2 symbol_text_size(std::string_view words, float width) {
  return size_of(lines_of(words, width));
}

std::string as_much_as_fits(std::string words, ImVec2 room) {
  if (symbol_text_size(words, room.x).y <= room.y) return words;
  for (std::size_t space = words.rfind(' '); space != std::string::npos; space = words.rfind(' ')) {
    words.resize(space);
    if (symbol_text_size(words + "…", room.x).y <= room.y) break;
  }
  return words + "…";
}

void draw_symbol_lines(ImDrawList& draw_list, ImVec2 corner, ImU32 colour, std::string_view words, float width) {
  for (const std::string_view line : lines_of(words, width)) {
    draw_symbol_text(draw_list, corner, colour, line);
    corner.y += ImGui::GetTextLineHeight();
  }
}

void symbol_text(std::string_view words, float width) {
  ImGuiWindow& window = *ImGui::GetCurrentWindow();
  if (window.SkipItems) return;
  const std::vector<std::string_view> lines = lines_of(words, width);
  const ImVec2 size = size_of(lines);
  ImVec2 corner{window.DC.CursorPos.x, window.DC.CursorPos.y + window.DC.CurrLineTextBaseOffset};
  ImGui::ItemSize(size, 0.0F);
  if (!ImGui::ItemAdd({corner, {corner.x + size.x, corner.y + size.y}}, 0)) return;
  for (const std::string_view line : lines) {
    draw_symbol_text(*window.DrawList, corner, ImGui::GetColorU32(ImGuiCol_Text), line);
    if (ImGui::GetCurrentContext()->LogEnabled) ImGui::LogRenderedText(&corner, line.data(), line.data() + line.size());
    corner.y += ImGui::GetTextLineHeight();
  }
}

}  // namespace ghostforce
