// The bar at the bottom: who moves the goal, and which scene; what is not as it should be, and what to do about it; and
// the ways to other scenes and to files. Above it, why watched shaders do not compile.

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/files/file_exchange.h"
#include "app/state/front_keys.h"
#include "app/state/stage_language.h"
#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"
#include "app/workbench/bars.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

// Fewer late ticks than this are felt by nobody and happen on every desktop [share of all].
constexpr double late_share_to_tell = 1e-3;

void draw_save_menu(const PanelContext& context) {
  if (!ImGui::BeginPopup("save")) return;
  close_popup_on_escape();
  const ActionSink& apply = context.apply;
  const FrontKeys& keys = front_keys();
  const auto item = [](const char* words, std::string_view key) {
    return ImGui::MenuItem(words, std::string(key).c_str());
  };
  if (ImGui::MenuItem("Save this scene…", "Ctrl+S")) apply(OpenDialog{Dialog::save_scene});
  if (item("Save a picture…", keys.save_picture.shown)) apply(OpenDialog{Dialog::save_picture});
  if (save_place().paints_files && ImGui::MenuItem("Save a clip…")) apply(OpenDialog{Dialog::save_clip});
  if (ImGui::MenuItem("Save the plots…", nullptr, false, context.session.plots.is_open)) {
    apply(OpenDialog{Dialog::save_plots});
  }
  ImGui::Separator();
  if (!keys.link.shown.empty() && item("Send a link…", keys.link.shown)) apply(ShowLink{});
  if (item("Copy a picture", keys.copy_picture.shown)) apply(CopyPicture{});
  if (item("Copy the live values", keys.copy_values.shown)) apply(CopyValues{});
  if (ImGui::MenuItem("Copy this set-up as a command", "Ctrl+C")) apply(CopySetUp{});
  if (ImGui::MenuItem("Paste a set-up", "Ctrl+V")) apply(PasteSetUp{});
  ImGui::EndPopup();
}

// What a narrow bar cuts off at its end says so.
std::string shortened(const std::string& text, float room) {
  constexpr std::size_t longest = 200;  // bytes; no bar has room for more
  if (text.size() <= longest && ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  std::string kept = text.substr(0, longest);
  do {
    // Whole letters: the bytes that go on a letter in UTF-8 begin with the bits 10.
    while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xC0U) == 0x80U) kept.pop_back();
    if (!kept.empty()) kept.pop_back();
  } while (!kept.empty() && ImGui::CalcTextSize((kept + "…").c_str()).x > room);
  return kept + "…";
}

// Empty: this is no replay.
std::string replay_words(const LoopReading& loop, const StageLanguage& language) {
  if (!loop.replay) return {};
  if (loop.replay->is_over) return std::string(language.notices.replay_over);
  return filled(language.notices.replay, loop.replay->done, loop.replay->all);
}

}  // namespace

void draw_replay_place(const PanelContext& context, ImVec2 end, float unit) {
  const std::string words = replay_words(context.loop, stage_language(context.session.language));
  const float padding = 10.0F * unit;
  const float margin = 14.0F * unit;
  const float room = end.x - 2.0F * (margin + padding);  // none before the first picture
  if (words.empty() || room <= 0.0F) return;
  const float height = letters_for(words, context.fonts.bold, room, 28.0F * unit);
  const ImVec2 extent = context.fonts.bold->CalcTextSizeA(height, 1e9F, 0.0F, words.c_str());
  const ImVec2 most{end.x - margin, end.y - margin};
  const ImVec2 corner{most.x - extent.x - 2.0F * padding, most.y - extent.y - 2.0F * padding};
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddRectFilled(corner, most, packed(context.theme.panel_field), padding);
  draw_list.AddRect(corner, most, packed(context.theme.accent), padding, 0, 2.0F * unit);
  draw_list.AddText(context.fonts.bold, height, {corner.x + padding, corner.y + padding}, packed(context.theme.text),
                    words.c_str());
}

std::vector<std::string> troubles_of(const LoopReading& loop, const Settings& settings) {
  std::vector<std::string> words;
  if (loop.diverged) {
    words.emplace_back("Unstable: the device runs away. Change a setting, undo with Ctrl+Z, or press Alt+R.");
    return words;
  }
  const double made = settings.rate * LoopReading::lately_s;
  if (static_cast<double>(loop.late_ticks_lately) > late_share_to_tell * made) {
    words.push_back(
        fmt::format("{} ticks late in {:.0f} s: close other programs", loop.late_ticks_lately, LoopReading::lately_s));
    if (!loop.refused_by_system.empty()) {
      words.push_back(fmt::format("{}: 'ghostforce doctor' says why", loop.refused_by_system));
    }
  }
  if (loop.dropped_samples > 0) {
    words.push_back(fmt::format("{} samples missing in the plots: close other programs", loop.dropped_samples));
  }
  if (loop.recording.is_on && loop.recording.dropped > 0) {
    words.push_back(fmt::format("{} samples not recorded: record to a faster disk", loop.recording.dropped));
  }
  if (loop.refused > 0)
    words.push_back(fmt::format("{} changes refused: out of range; undo with Ctrl+Z", loop.refused));
  return words;
}

void draw_status_bar(const PanelContext& context, bool has_caption) {
  const Session& session = context.session;
  const LoopReading& loop = context.loop;
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto width = [](const std::string& text) { return symbol_text_width(text); };
  const auto symbol_button_width = [&](const std::string& text) { return width(text) + 2.0F * style.FramePadding.x; };
  // On motors they are felt, and whoever holds the handle must not take them for the wall.
  const bool tones_are_felt = loop.hand.tone_gain > 0.0 && loop.motors.state != SafetyState::off;
  const std::string replay = replay_words(loop, english_stage);
  const std::string words =
      fmt::format("{}{}{}   ·   t = {:8.3f} s{}", replay, replay.empty() ? "" : "   ·   ", loop.input_title,
                  context.snapshot.time_s, tones_are_felt ? "   ·   measuring the hand: tones on the motor" : "");
  std::vector<std::string> problems = has_caption ? std::vector<std::string>() : warnings_of_caption(context);
  std::ranges::move(troubles_of(loop, context.settings), std::back_inserter(problems));
  const std::string problem = problems.empty() ? "" : fmt::format("   ·   {}", fmt::join(problems, "   ·   "));

  // From the right: help, saving, the scene, and the loop's words in what remains.
  const std::string help = fmt::format("{}  Help", front_keys().help.shown);
  const char* const save = "Save  ▾";
  const float spacing = style.ItemSpacing.x;
  const float left = ImGui::GetCursorPosX();
  const float save_x = ImGui::GetContentRegionMax().x - symbol_button_width(help) - spacing - symbol_button_width(save);
  const float for_scene = save_x - 2.0F * spacing - left - width(words) - width(problem) - symbol_button_width("");
  const std::string title = shortened(session.scene->title, std::max(for_scene, 7.0F * ImGui::GetFontSize()));
  const float scene_x = save_x - spacing - symbol_button_width(title);
  const float room = scene_x - spacing - left;

  ImGui::SetCursorPosY(0.5F * (ImGui::GetWindowHeight() - ImGui::GetFrameHeight()));
  ImGui::AlignTextToFramePadding();
  ImGui::BeginGroup();
  // Where there is room for one of them, trouble is what has to be read.
  const bool has_room_for_both = width(words) + width(problem) <= room;
  if (problems.empty() || has_room_for_both) {
    ImGui::TextUnformatted(shortened(words, room).c_str());
    ImGui::SameLine(0.0F, 0.0F);
  }
  if (!problems.empty()) {
    text_in(context.theme.problem,
            has_room_for_both ? problem : shortened(fmt::format("{}", fmt::join(problems, ". ")), room));
  }
  ImGui::EndGroup();
  tooltip(
      fmt::format("What moves the goal, and the model time. {:.0f} ticks a second; {} late so far. The panel "
                  "“Recording” shows how far apart they are.{}{}",
                  loop.rate_hz, loop.late_ticks, problems.empty() ? "" : "\n", fmt::join(problems, "\n")));
  ImGui::SameLine(scene_x);
  const bool opens_scene = ImGui::Button("###scene", {symbol_button_width(title), 0.0F});
  const ImVec2 corner = ImGui::GetItemRectMin();
  draw_symbol_text(*ImGui::GetWindowDrawList(), {corner.x + style.FramePadding.x, corner.y + style.FramePadding.y},
                   ImGui::GetColorU32(ImGuiCol_Text), title);
  if (opens_scene) context.apply(ToggleDialog{Dialog::open_scene});
  tooltip(fmt::format("{} Click to open another scene. Ctrl+O.", session.scene->about));
  ImGui::SameLine();
  if (ImGui::Button(save)) ImGui::OpenPopup("save");
  tooltip("Saves the scene, a picture or the plots; copies the live values or a picture.");
  draw_save_menu(context);
  ImGui::SameLine();
  if (ImGui::Button(help.c_str())) context.apply(ToggleDialog{Dialog::help});
  tooltip("All keys and mouse gestures.");
}

}  // namespace ghostforce
