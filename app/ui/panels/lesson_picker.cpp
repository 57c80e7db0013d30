// F5: the lessons that come with the program, with a picture of each, what it is about and how far one has come. The
// keyboard is at the lesson to begin with; arrows and Tab move it, Enter begins.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/lessons/lesson_file.h"
#include "app/lessons/lesson_shelf.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/picture_card.h"

namespace ghostforce {
namespace {

// [points]
constexpr double lesson_mark_scale = 0.5;  // of lines and marks in the small pictures
constexpr float lesson_picture_width = 150.0F;
constexpr float lesson_card_width = 420.0F;

// What is known of a lesson, in words.
std::string progress_words(const Lesson& lesson, const LessonProgress& progress) {
  const auto found = progress.lessons.find(lesson.name);
  if (found == progress.lessons.end()) return fmt::format("{} steps", lesson.steps.size());
  const LessonRecord& record = found->second;
  const std::size_t questions = questions_of(lesson);
  const std::size_t right = std::min(record.right.size(), questions);
  const std::string score = questions == 0 ? "" : fmt::format(" · {} of {} right", right, questions);
  if (record.is_finished) return fmt::format("Done{}", score);
  return fmt::format("Step {} of {}{}", std::min(record.farthest + 1, lesson.steps.size()), lesson.steps.size(), score);
}

// Where somebody goes on: the first lesson that is not done.
std::size_t lesson_to_begin(const Session& session) {
  const auto& lessons = shipped_lessons();
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const auto found = session.lesson_progress.lessons.find(lessons[i]->name);
    if (found == session.lesson_progress.lessons.end() || !found->second.is_finished) return i;
  }
  return 0;
}

void draw_reset(Session& session) {
  if (!session.form.asks_for_reset) {
    if (ImGui::Button("Forget my progress…")) session.form.asks_for_reset = true;
    return;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Forget how far you have come in all lessons?");
  same_line_if_room(ImGui::CalcTextSize("Forget it Keep it").x);
  if (ImGui::Button("Forget it")) {
    session.lesson_progress = {};
    session.form.asks_for_reset = false;
  }
  ImGui::SameLine();
  if (ImGui::Button("Keep it")) session.form.asks_for_reset = false;
}

}  // namespace

void draw_lessons(const PanelContext& context) {
  Session& session = context.session;
  const bool is_new = session.form.belongs_to != Dialog::lessons;
  if (is_new) session.form.marked_lesson = lesson_to_begin(session);
  const auto& lessons = shipped_lessons();
  const ImGuiStyle& style = ImGui::GetStyle();
  const CardRows rows(context, lesson_card_width, 2, lessons.size());
  ImGui::BeginChild("lessons", rows.size(), ImGuiChildFlags_NavFlattened);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.y, style.ItemSpacing.y});
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    rows.begin_card(i);
    const Lesson& lesson = *lessons[i];
    const LessonWords& words = words_in(lesson, session.language);
    const bool is_marked = session.form.marked_lesson == i;
    if (is_new && is_marked) {
      ImGui::SetKeyboardFocusHere();
      ImGui::SetNavCursorVisible(true);
    }
    const float density = ImGui::GetIO().DisplayFramebufferScale.x;
    const auto picture_of = [&](ImVec2 size) {
      return context.lessons.picture(i, context.theme, static_cast<int>(size.x * density),
                                     static_cast<int>(size.y * density),
                                     lesson_mark_scale * static_cast<double>(context.scale * density));
    };
    const PictureCard card{.id = static_cast<int>(i),
                           .title = words.title,
                           .about = words.about,
                           .remark = progress_words(lesson, session.lesson_progress),
                           .picture_width = lesson_picture_width,
                           .is_marked = is_marked};
    if (draw_picture_card(context, card, rows.card_size(), picture_of)) session.requests.open_lesson = lesson.name;
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  wrapped_text("Each asks what will happen before it shows it. Enter or a click begins one; Esc ends it.",
               ImGui::GetCursorPosX() + rows.size().x);
  draw_reset(session);
  ImGui::SameLine();
  if (ImGui::Button("Close")) session.dialog = Dialog::none;
}

}  // namespace ghostforce
