#include "app/workbench/bars.h"

#include <algorithm>
#include <string>

#include "app/state/lecture_notes.h"
#include "app/state/stage_language.h"
#include "app/widgets/controls.h"
#include "app/widgets/pointing.h"

namespace ghostforce {

float notes_height(float window_height) {
  constexpr float lines = 5.0F;  // a title, three lines of what to say, and what comes next; more can be scrolled to
  constexpr float most = 0.3F;   // of the window
  const float padding = 2.0F * ImGui::GetStyle().WindowPadding.y;
  return std::min(lines * ImGui::GetTextLineHeightWithSpacing() + padding, most * window_height);
}

void draw_notes(const PanelContext& context) {
  const LectureNotes notes = lecture_notes(context.session);
  ImGui::PushFont(context.fonts.bold, 0.0F);
  ImGui::TextUnformatted(notes.title.c_str());
  ImGui::PopFont();
  if (!notes.words.empty()) wrapped_text(notes.words);
  ImGui::PushStyleColor(ImGuiCol_Text, packed(context.theme.faint_text));
  wrapped_text(notes.next);
  ImGui::PopStyleColor();
}

void draw_blank_words(const PanelContext& context, const ScreenBox& scene) {
  constexpr double dimmed = 0.75;
  ImDrawList& draw_list = *ImGui::GetBackgroundDrawList();
  if (context.session.face == Face::stage) {
    draw_list.AddRectFilled(imgui_vector(scene.least), imgui_vector(scene.most),
                            packed(faded(context.theme.background, dimmed)));
  }
  const std::string words(stage_language(context.session.language).lecture.is_blank);
  const float height = 1.5F * ImGui::GetFontSize();
  const float width = static_cast<float>(0.9 * scene.extent().x);
  const ImVec2 extent = context.fonts.bold->CalcTextSizeA(height, width, width, words.c_str());
  const ImVec2 middle = imgui_vector(0.5 * (scene.least + scene.most));
  draw_list.AddText(context.fonts.bold, height, {middle.x - 0.5F * extent.x, middle.y - 0.5F * extent.y},
                    packed(context.theme.text), words.c_str(), nullptr, width);
}

}  // namespace ghostforce
