// Ctrl+O: the shipped scenes with a picture of each, and a field for the path of any other. The field has the keyboard:
// the arrows move a mark from scene to scene, Enter opens what is typed, or else what is marked.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/files/shipped_scenes.h"
#include "app/state/key_bindings.h"
#include "app/widgets/controls.h"
#include "app/widgets/picture_card.h"
#include "app/workbench/dialogs.h"

namespace ghostforce {
namespace {

constexpr double mark_scale = 0.62;   // of lines and marks in the small pictures
constexpr float card_width = 296.0F;  // [points]

// As the program brings it along: a person's own scene may have kept the title of one that it was made from.
bool is_open_now(const Session& session, const ShippedScene& shipped) {
  return *session.scene == shipped.scene;
}

// True when it was pressed.
bool draw_scene_card(const PanelContext& context, std::size_t number, ImVec2 size) {
  const ShippedScene& shipped = shipped_scenes()[number];
  const bool is_open = is_open_now(context.session, shipped);
  const PictureCard card{.id = static_cast<int>(number),
                         .title = shipped.scene.title,
                         .about = is_open ? "Open now. " + shipped.scene.about : shipped.scene.about,
                         .is_marked = context.session.form.marked_scene == number,
                         .is_open = is_open};
  const float density = ImGui::GetIO().DisplayFramebufferScale.x;
  return draw_picture_card(context, card, size, [&](ImVec2 picture) {
    return context.gallery.picture(number, context.theme, static_cast<int>(picture.x * density),
                                   static_cast<int>(picture.y * density),
                                   mark_scale * static_cast<double>(context.scale * density));
  });
}

// By the arrows; true when it has moved.
bool move_mark(Form& form, int columns) {
  const int count = static_cast<int>(shipped_scenes().size());
  int mark = static_cast<int>(form.marked_scene);
  if (ImGui::IsKeyPressed(ImGuiKey_DownArrow) && mark + columns < count) mark += columns;
  if (ImGui::IsKeyPressed(ImGuiKey_UpArrow) && mark >= columns) mark -= columns;
  if (form.path.empty()) {
    if (ImGui::IsKeyPressed(ImGuiKey_RightArrow)) mark = std::min(mark + 1, count - 1);
    if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow)) mark = std::max(mark - 1, 0);
  }
  const bool has_moved = mark != static_cast<int>(form.marked_scene);
  form.marked_scene = static_cast<std::size_t>(mark);
  return has_moved;
}

// Its first lines: a file may be wrong in many places.
std::string beginning_of(const std::string& problem) {
  constexpr int most_lines = 4;
  std::size_t end = 0;
  for (int line = 0; line < most_lines && end != std::string::npos; ++line) end = problem.find('\n', end + 1);
  return end == std::string::npos ? problem : problem.substr(0, end) + "\n…";
}

void draw_problem(const PanelContext& context, float width) {
  Form& form = context.memory.form;
  if (form.problem.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.problem));
  wrapped_text(beginning_of(form.problem), ImGui::GetCursorPosX() + width);
  ImGui::PopStyleColor();
  if (form.suggestion.empty()) return;
  if (ImGui::Button(fmt::format("Open {} instead###suggestion", form.suggestion).c_str())) {
    form.path = form.suggestion;
    context.apply(OpenScene{form.path});
  }
}

}  // namespace

void draw_open_scene(const PanelContext& context) {
  const Session& session = context.session;
  Form& form = context.memory.form;
  const bool is_new = form.belongs_to != Dialog::open_scene;
  const auto& scenes = shipped_scenes();
  if (is_new) {
    const auto open =
        std::ranges::find(scenes, session.scene->title, [](const ShippedScene& s) { return s.scene.title; });
    form.marked_scene = open == scenes.end() ? 0 : static_cast<std::size_t>(open - scenes.begin());
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const CardRows rows(context, card_width, 3, scenes.size());
  const float width = rows.size().x;
  const float gap = style.ItemSpacing.y;
  ImGui::BeginChild("scenes", rows.size());
  const bool has_moved = ImGui::IsAnyItemActive() && move_mark(form, rows.columns());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    rows.begin_card(i);
    if (draw_scene_card(context, i, rows.card_size())) {
      form.marked_scene = i;
      context.apply(OpenScene{scenes[i].name});
    }
    if (i == form.marked_scene && (has_moved || is_new)) ImGui::SetScrollHereY();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();

  wrapped_text(offers_file_chooser()
                   ? "Or open a scene, a recording or a saved picture of your own, or drop it on the window:"
                   : "Or type the path of a scene, a recording or a saved picture, or drop it on the window:",
               ImGui::GetCursorPosX() + width);
  const char* const open_words = "Open";
  const char* const cancel_words = "Cancel";
  const char* const choose_words = "Open a file…";
  float field_width = width - button_width(open_words) - button_width(cancel_words) - 2.0F * style.ItemSpacing.x;
  if (offers_file_chooser()) field_width -= button_width(choose_words) + style.ItemSpacing.x;
  ImGui::SetNextItemWidth(field_width);
  if (is_new) ImGui::SetKeyboardFocusHere();
  const bool entered = search_field("##path", "my_scene.toml", form.path);
  ImGui::SameLine();
  const bool pressed = ImGui::Button(open_words);
  ImGui::SameLine();
  if (offers_file_chooser()) {
    if (ImGui::Button(choose_words)) choose_file();
    ImGui::SameLine();
  }
  if (ImGui::Button(cancel_words)) context.apply(CloseDialog{});
  if (entered || pressed) {
    const ShippedScene& marked = scenes[form.marked_scene];
    if (!form.path.empty()) {
      context.apply(OpenScene{form.path});
    } else if (!is_open_now(session, marked)) {
      context.apply(OpenScene{marked.name});
    } else {
      context.apply(CloseDialog{});  // it is open, and what has been changed in it stays
    }
  }
  draw_problem(context, width);
}

}  // namespace ghostforce
