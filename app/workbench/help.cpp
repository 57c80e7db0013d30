// F1: what mouse and keys do, from the one table of each, by what they are for, in as many columns as have room.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "app/state/key_bindings.h"
#include "app/widgets/controls.h"
#include "app/workbench/dialogs.h"

namespace ghostforce {
namespace {

struct HelpLine {
  std::string_view press;
  std::string_view sentence;
};

struct HelpGroup {
  std::string_view title;
  std::vector<HelpLine> lines;

  std::size_t height() const noexcept { return 1 + lines.size(); }  // [lines]
};

// In the order of the keys; the mouse comes first in its group.
std::vector<HelpGroup> help_groups(const StageLanguage& language) {
  const auto in_language = [&](auto table, std::string_view words) {
    return counterpart(english_stage.*table, language.*table, words);
  };
  std::vector<HelpGroup> groups;
  for (const KeyBinding& binding : key_table()) {
    if (!binding.group.empty()) {
      groups.push_back({in_language(&StageLanguage::key_groups, binding.group), {}});
      for (const MouseGesture& gesture : mouse_table()) {
        if (gesture.group != binding.group) continue;
        groups.back().lines.push_back({in_language(&StageLanguage::mouse_rows, gesture.shown),
                                       in_language(&StageLanguage::mouse_rows, gesture.sentence)});
      }
    }
    if (binding.shown.empty()) continue;
    groups.back().lines.push_back(
        {in_language(&StageLanguage::key_names, binding.shown), sentence_in(language, binding)});
  }
  return groups;
}

std::size_t height_of(std::span<const HelpGroup> groups) {
  std::size_t height = 0;
  for (const HelpGroup& group : groups) height += group.height();
  return height;
}

// How many of the groups go to the left, so that neither column is longer than it must be.
std::size_t left_groups(std::span<const HelpGroup> groups) {
  std::size_t best = groups.size();
  std::size_t least = height_of(groups);
  for (std::size_t count = 0; count < groups.size(); ++count) {
    const std::size_t longer = std::max(height_of(groups.first(count)), height_of(groups.subspan(count)));
    if (longer >= least) continue;
    least = longer;
    best = count;
  }
  return best;
}

// [points]
constexpr float line_gap = 1.5F;     // between lines
constexpr float group_gap = 4.0F;    // above a title
constexpr float column_gap = 18.0F;  // between columns

float width_of(ImFont* font, float height, std::string_view words) {
  return font->CalcTextSizeA(height, 1e9F, 0.0F, words.data(), words.data() + words.size()).x;
}

struct ColumnWidths {
  float press = 0.0F;
  float sentence = 0.0F;
};

ColumnWidths widths_of(std::span<const HelpGroup> groups, const PanelContext& context) {
  const float height = ImGui::GetFontSize();
  ColumnWidths widths;
  for (const HelpGroup& group : groups) {
    for (const HelpLine& line : group.lines) {
      widths.press = std::max(widths.press, width_of(context.fonts.bold, height, line.press));
      widths.sentence = std::max(widths.sentence, width_of(context.fonts.regular, height, line.sentence));
    }
  }
  widths.press += 0.9F * height;
  return widths;
}

void draw_groups(std::span<const HelpGroup> groups, const ColumnWidths& widths, const PanelContext& context) {
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, line_gap * context.scale});
  const float left = ImGui::GetCursorPosX();
  for (const HelpGroup& group : groups) {
    ImGui::Dummy({0.0F, group_gap * context.scale});
    ImGui::PushFont(context.fonts.bold, 0.0F);
    text_in(context.theme.accent, group.title);
    ImGui::PopFont();
    for (const HelpLine& line : group.lines) {
      text_in(context.fonts.bold, line.press);
      ImGui::SameLine();
      ImGui::SetCursorPosX(left + widths.press);
      wrapped_text(line.sentence, left + widths.press + widths.sentence + context.scale);
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndGroup();
}

}  // namespace

void draw_help(const PanelContext& context) {
  const StageLanguage& language = stage_language(context.session.language);
  const std::vector<HelpGroup> groups = help_groups(language);
  const std::span<const HelpGroup> all(groups);
  const float room = ImGui::GetIO().DisplaySize.x - 64.0F * context.scale;
  const std::size_t split = left_groups(all);
  const std::array parts{all.first(split), all.subspan(split)};

  const std::array widths{widths_of(parts[0], context), widths_of(parts[1], context)};
  const float both =
      widths[0].press + widths[0].sentence + widths[1].press + widths[1].sentence + column_gap * context.scale;

  wrapped_text(language.help.subject, ImGui::GetCursorPosX() + std::min(both, room));
  if (both <= room) {
    const float left = ImGui::GetCursorPosX();
    draw_groups(parts[0], widths[0], context);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + widths[0].press + widths[0].sentence + column_gap * context.scale);
    draw_groups(parts[1], widths[1], context);
  } else {
    // One above the other where the window is too narrow for both.
    const float press = std::max(widths[0].press, widths[1].press);
    const float sentence = std::max(widths[0].sentence, widths[1].sentence);
    draw_groups(all, {press, std::min(sentence, room - press - ImGui::GetStyle().ScrollbarSize)}, context);
  }
  text_in(context.theme.faint_text, language.help.hint);
}

}  // namespace ghostforce
