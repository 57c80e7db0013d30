// F5: the lessons that come with the program, with a picture of each, what it is about and how far one has come. The
// keyboard is at the lesson to begin with; arrows and Tab move it, Enter begins.
#include <algorithm>
#include <string>

#include "app/files/file_exchange.h"
#include "app/stage/lesson_content.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/widgets/controls.h"
#include "app/widgets/picture_card.h"
#include "app/workbench/dialogs.h"

namespace ghostforce {
namespace {

// [points]
constexpr double lesson_mark_scale = 0.5;  // of lines and marks in the small pictures
constexpr float lesson_picture_width = 150.0F;
constexpr float lesson_card_width = 456.0F;
constexpr float beside_cards = 130.0F;  // title, a row of buttons and margins

void draw_reset(const PanelContext& context, const StageLanguage::Picker& words) {
  bool& asks = context.memory.form.asks_for_reset;
  if (!asks) {
    if (ImGui::Button(words.forget.data())) asks = true;
    return;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.forget_question.data());
  same_line_if_room(ImGui::CalcTextSize(filled("{} {}", words.forget_yes, words.forget_no).c_str()).x);
  if (ImGui::Button(words.forget_yes.data())) {
    context.apply(ForgetLessons{});
    asks = false;
  }
  ImGui::SameLine();
  if (ImGui::Button(words.forget_no.data())) asks = false;
}

}  // namespace

void draw_lessons(const PanelContext& context) {
  const Session& session = context.session;
  Form& form = context.memory.form;
  const StageLanguage::Picker& said = stage_language(session.language).picker;
  const bool is_new = form.belongs_to != Dialog::lessons;
  if (is_new) form.marked_lesson = lesson_to_go_on_with(session);
  const auto& lessons = shipped_lessons();
  const ImGuiStyle& style = ImGui::GetStyle();
  const CardRows rows(context, lesson_card_width, 2, lessons.size(), beside_cards);
  ImGui::BeginChild("lessons", rows.size(), ImGuiChildFlags_NavFlattened);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.y, style.ItemSpacing.y});
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    rows.begin_card(i);
    const Lesson& lesson = *lessons[i];
    const LessonWords& words = words_in(lesson, session.language);
    const bool is_marked = form.marked_lesson == i;
    if (is_new && is_marked) {
      ImGui::SetKeyboardFocusHere();
      ImGui::SetNavCursorVisible(true);
    }
    const float density = ImGui::GetIO().DisplayFramebufferScale.x;
    const auto picture_of = [&](ImVec2 size) {
      const int width = static_cast<int>(size.x * density);
      const int height = static_cast<int>(size.y * density);
      const double scale = lesson_mark_scale * static_cast<double>(context.scale * density);
      return context.lessons.picture(i, lessons.size(), context.theme, width, height, [&](std::size_t each) {
        return lesson_card(each, context.theme, {width, height}, scale);
      });
    };
    const PictureCard card{.id = static_cast<int>(i),
                           .title = numbered_title(i, session.language),
                           .about = words.about,
                           .remark = progress_words(lesson, session.lesson_progress, said),
                           .picture_width = lesson_picture_width,
                           .is_marked = is_marked};
    if (draw_picture_card(context, card, rows.card_size(), picture_of)) context.apply(OpenLesson{lesson.name});
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (!session.lesson_gone_through.empty()) {
    // One leads on to another.
    const std::size_t next = lesson_to_go_on_with(session);
    if (ImGui::Button(filled(said.next, numbered_title(next, session.language)).c_str())) {
      context.apply(OpenLesson{lessons[next]->name});
    }
    ImGui::SameLine();
  }
  if (session.lesson_progress != LessonProgress{}) {
    draw_reset(context, said);
    ImGui::SameLine();
  }
  if (offers_file_chooser()) {
    if (ImGui::Button(said.open_file.data())) {
      choose_file();
      context.apply(CloseDialog{});  // whatever is chosen is behind it
    }
    ImGui::SameLine();
  }
  if (ImGui::Button(said.close.data())) context.apply(CloseDialog{});
  same_line_if_room(12.0F * ImGui::GetFontSize());  // for both languages
  draw_language_choice(context);
}

}  // namespace ghostforce
