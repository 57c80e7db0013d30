// Ctrl+O: the shipped scenes with a picture of each, and a field for the path of any other. The field has the keyboard:
// the arrows move a mark from scene to scene, Enter opens what is typed, or else what is marked.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/session/key_bindings.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/symbol_text.h"

namespace ghostforce {
namespace {

// [points]
constexpr float picture_width = 112.0F;
constexpr float picture_height = 92.0F;
constexpr float card_width = 296.0F;
constexpr float card_padding = 6.0F;
constexpr double mark_scale = 0.62;  // of lines and marks in the small pictures

int columns_for(float width, const PanelContext& context) {
  return std::clamp(static_cast<int>(width / (card_width * context.scale)), 1, 3);
}

// Words in a box, as many as it has room for.
void words_in_box(ImFont* font, Colour colour, ImVec2 corner, ImVec2 end, const std::string& words) {
  ImGui::PushFont(font, 0.0F);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 room{end.x - corner.x, end.y - corner.y};
  draw_symbol_lines(draw_list, corner, packed(colour), as_much_as_fits(words, room), room.x);
  ImGui::PopFont();
}

// As the program brings it along: a person's own scene may have kept the title of one that it was made from.
bool is_open_now(const Session& session, const ShippedScene& shipped) {
  return *session.scene == shipped.scene;
}

// True when it was pressed.
bool draw_card(const PanelContext& context, std::size_t number, float width) {
  const ShippedScene& shipped = shipped_scenes()[number];
  const Theme& theme = context.theme;
  const float padding = card_padding * context.scale;
  const ImVec2 picture{std::round(picture_width * context.scale), std::round(picture_height * context.scale)};
  const ImVec2 size{width, picture.y + 2.0F * padding};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  ImGui::PushID(static_cast<int>(number));
  const bool pressed = ImGui::InvisibleButton("scene", size, ImGuiButtonFlags_EnableNav);
  ImGui::PopID();
  const bool is_marked = context.session.form.marked_scene == number;
  const bool is_open = is_open_now(context.session, shipped);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool is_hovered = ImGui::IsItemHovered();
  draw_list.AddRectFilled(corner, end, packed(mix(theme.panel_field, theme.accent, is_hovered ? 0.16 : 0.0)), rounding);
  draw_list.AddRect(corner, end, packed(is_marked ? theme.accent : theme.panel_border), rounding, 0,
                    (is_marked ? 2.5F : 1.0F) * context.scale);
  const float density = ImGui::GetIO().DisplayFramebufferScale.x;
  const unsigned int name = context.gallery.picture(number, theme, static_cast<int>(picture.x * density),
                                                    static_cast<int>(picture.y * density),
                                                    mark_scale * static_cast<double>(context.scale * density));
  const ImVec2 from{corner.x + padding, corner.y + padding};
  const ImVec2 to{from.x + picture.x, from.y + picture.y};
  draw_list.AddImage(ImTextureID{name}, from, to, {0.0F, 1.0F}, {1.0F, 0.0F});
  draw_list.AddRect(from, to, packed(theme.panel_border), 0.0F, 0, context.scale);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 words{to.x + 1.5F * padding, from.y};
  const float right = end.x - padding;
  words_in_box(context.fonts.bold, theme.text, words, {right, words.y + 2.0F * line}, shipped.scene.title);
  ImGui::PushFont(context.fonts.bold, 0.0F);
  const float title_width = symbol_text_width(shipped.scene.title);
  ImGui::PopFont();
  const float about_y = words.y + (title_width > right - words.x ? 2.0F : 1.0F) * line;
  words_in_box(context.fonts.regular, is_open ? theme.accent : theme.faint_text, {words.x, about_y},
               {right, end.y - padding}, is_open ? "Open now. " + shipped.scene.about : shipped.scene.about);
  return pressed;
}

// The field keeps the keyboard when Enter is pressed, and the arrows up and down are not taken for a way out of it.
bool path_field(std::string& path) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTextEnterKeepActive = true;
  const bool entered = text_field("##path", "my_scene.toml", path, ImGuiInputTextFlags_CallbackHistory);
  io.ConfigInputTextEnterKeepActive = false;
  return entered;
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
  Form& form = context.session.form;
  if (form.problem.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.problem));
  wrapped_text(beginning_of(form.problem), ImGui::GetCursorPosX() + width);
  ImGui::PopStyleColor();
  if (form.suggestion.empty()) return;
  if (ImGui::Button(fmt::format("Open {} instead###suggestion", form.suggestion).c_str())) {
    form.path = form.suggestion;
    context.session.requests.open_scene = form.path;
  }
}

}  // namespace

void draw_open_scene(const PanelContext& context) {
  Session& session = context.session;
  Form& form = session.form;
  const bool is_new = form.belongs_to != Dialog::open_scene;
  const auto& scenes = shipped_scenes();
  if (is_new) {
    const auto open =
        std::ranges::find(scenes, session.scene->title, [](const ShippedScene& s) { return s.scene.title; });
    form.marked_scene = open == scenes.end() ? 0 : static_cast<std::size_t>(open - scenes.begin());
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = dialog_field_width(3.0F * (card_width + 6.0F) + 14.0F, context);
  const float room = width - style.ScrollbarSize;
  const int columns = columns_for(room, context);
  const float gap = style.ItemSpacing.y;
  const float card = std::floor((room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns));
  const float card_height = (picture_height + 2.0F * card_padding) * context.scale;
  const int rows = (static_cast<int>(scenes.size()) + columns - 1) / columns;
  // What remains of the window beside the dialog's title, margins, field, buttons and a few lines about a problem.
  const float most = ImGui::GetIO().DisplaySize.y - 200.0F * context.scale - 2.0F * gap;
  const float all = static_cast<float>(rows) * (card_height + gap);
  ImGui::BeginChild("scenes", {width, std::max(std::min(all, most), card_height)});
  const bool has_moved = ImGui::IsAnyItemActive() && move_mark(form, columns);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    if (draw_card(context, i, card)) {
      form.marked_scene = i;
      session.requests.open_scene = scenes[i].name;
    }
    if (i == form.marked_scene && (has_moved || is_new)) ImGui::SetScrollHereY();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();

  wrapped_text("Or type the path of a scene or a recording, or drop the file on the window:",
               ImGui::GetCursorPosX() + width);
  const char* const open_words = "Open";
  const char* const cancel_words = "Cancel";
  const auto button_width = [&](const char* words) {
    return ImGui::CalcTextSize(words).x + 2.0F * style.FramePadding.x;
  };
  ImGui::SetNextItemWidth(width - button_width(open_words) - button_width(cancel_words) - 2.0F * style.ItemSpacing.x);
  if (is_new) ImGui::SetKeyboardFocusHere();
  const bool entered = path_field(form.path);
  ImGui::SameLine();
  const bool pressed = ImGui::Button(open_words);
  ImGui::SameLine();
  if (ImGui::Button(cancel_words)) session.dialog = Dialog::none;
  if (entered || pressed) {
    const ShippedScene& marked = scenes[form.marked_scene];
    if (!form.path.empty()) {
      session.requests.open_scene = form.path;
    } else if (!is_open_now(session, marked)) {
      session.requests.open_scene = marked.name;
    } else {
      session.dialog = Dialog::none;  // it is open, and what has been changed in it stays
    }
  }
  draw_problem(context, width);
}

}  // namespace ghostforce
