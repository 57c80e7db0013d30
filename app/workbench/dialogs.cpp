#include "app/workbench/dialogs.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/widgets/controls.h"
#include "app/widgets/pointing.h"

namespace ghostforce {
namespace {

struct Entry {
  Dialog id;
  const char* title;
  void (*draw)(const PanelContext&);
  bool is_at_the_side = false;
};
constexpr std::array dialogs{
    Entry{Dialog::help, "###help", draw_help},
    Entry{Dialog::doctor, "Device status", draw_doctor, true},
    Entry{Dialog::lessons, "###lessons", draw_lessons},
    Entry{Dialog::open_scene, "Open a scene", draw_open_scene},
    Entry{Dialog::save_scene, "Save the scene", draw_save_scene},
    Entry{Dialog::save_picture, "Save a picture", draw_save_picture},
    Entry{Dialog::save_clip, "Save a clip", draw_save_clip},
    Entry{Dialog::save_plots, "Save the plots", draw_save_plots},
    Entry{Dialog::reset_preferences, "###reset", draw_reset_preferences},
    Entry{Dialog::palette, "###palette", draw_palette},
};

constexpr ImGuiWindowFlags dialog_window = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                           ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                           ImGuiWindowFlags_AlwaysAutoResize;

constexpr const char* notice_window = "notice";

// A window as small as a phone's, where fingers press.
bool is_phone(const ImVec2& size) {
  constexpr float widest_phone = 500.0F;
  return std::min(size.x, size.y) < widest_phone;
}

ImVec2 button_padding(const ImVec2& size) {
  constexpr float finger = 44.0F;
  ImVec2 padding = ImGui::GetStyle().FramePadding;
  if (is_phone(size)) padding.y = std::max(padding.y, 0.5F * (finger - ImGui::GetFontSize()));
  return padding;
}

// Of what speaks the stage's language; the others are called as their entry says.
std::string title_in(const StageLanguage& language, Dialog dialog) {
  if (dialog == Dialog::lessons) return fmt::format("{}: {}", language.picker.title, language.picker.about);
  if (dialog == Dialog::help) return std::string(language.help.title);
  if (dialog == Dialog::reset_preferences) return std::string(language.reset.title);
  return std::string(dialog == Dialog::palette ? language.palette.title : "");
}

// The dialog itself, or the part of it that scrolls; null: all of it is in sight.
ImGuiWindow* scrolling_window_of(Dialog dialog) {
  const auto entry = std::ranges::find(dialogs, dialog, &Entry::id);
  ImGuiWindow* const whole = entry == dialogs.end() ? nullptr : ImGui::FindWindowByName(entry->title);
  if (whole == nullptr || !whole->WasActive) return nullptr;
  if (whole->ScrollMax.y > 0.0F) return whole;
  const ImVector<ImGuiWindow*>& parts = whole->DC.ChildWindows;
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [](const ImGuiWindow* each) { return each->WasActive && each->ScrollMax.y > 0.0F; });
  return part == parts.end() ? nullptr : *part;
}

}  // namespace

bool scrolls(Dialog dialog) {
  return scrolling_window_of(dialog) != nullptr;
}

void scroll(Dialog dialog, const ScrollStep& step) {
  ImGuiWindow* const window = scrolling_window_of(dialog);
  if (window == nullptr) return;
  const float line = ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
  const float page = window->InnerRect.GetHeight() - line;  // the last line is the next page's first
  // What an earlier key has asked for is done in the next frame.
  const float now = window->ScrollTarget.y < FLT_MAX ? window->ScrollTarget.y : window->Scroll.y;
  const float down = now + step.lines * line + step.pages * page;
  ImGui::SetScrollY(window, std::clamp(down, 0.0F, window->ScrollMax.y));
}

bool has_field(Dialog dialog) noexcept {
  constexpr std::array without{Dialog::none, Dialog::help, Dialog::doctor, Dialog::lessons, Dialog::reset_preferences};
  return std::ranges::find(without, dialog) == without.end();
}

void draw_dialog(const PanelContext& context, const std::optional<Vector<2>>& hand) {
  const Session& session = context.session;
  Form& form = context.memory.form;
  const auto entry = std::ranges::find(dialogs, session.dialog, &Entry::id);
  if (entry == dialogs.end()) {
    form = {};
    return;
  }
  // Every dialog begins with fields of its own.
  if (form.belongs_to != session.dialog && form.belongs_to != Dialog::none) form = {};
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  // Whole points: from parts of one a window that fits its content would have a scroll bar for what is rounded.
  const float margin = std::round(16.0F * context.scale);
  const std::string title = title_in(stage_language(session.language), entry->id) + entry->title;
  // Of the bar, or the stage's sentence and buttons, which grow with the window.
  const bool is_on_stage = session.face == Face::stage;
  const float bar = is_on_stage ? std::max(54.0F * context.scale, 0.1F * whole.y) : 54.0F * context.scale;
  float top = margin;
  if (entry->is_at_the_side) {
    // The steps speak of what happens in the scene: it stays out of its way, and out of the sentence's two lines.
    if (form.belongs_to != session.dialog) form.is_at_left = hand && hand->x > 0.5 * static_cast<double>(whole.x);
    top = is_on_stage && form.is_at_left ? std::max(bar, 0.14F * whole.y) : bar;
    const float side = form.is_at_left ? margin : whole.x - margin;
    ImGui::SetNextWindowPos({side, top}, ImGuiCond_Always, {form.is_at_left ? 0.0F : 1.0F, 0.0F});
  } else {
    float middle = 0.5F * whole.y;
    // As far as there is room, the stage's button that has opened it stays free, to close it.
    if (const ImGuiWindow* const shown = ImGui::FindWindowByName(title.c_str()); is_on_stage && shown != nullptr) {
      const float height = shown->Size.y;
      middle = std::max(middle, std::min(bar, whole.y - height - 0.25F * margin) + 0.5F * height);
    }
    ImGui::SetNextWindowPos({0.5F * whole.x, middle}, ImGuiCond_Always, {0.5F, 0.5F});
  }
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {whole.x - 2.0F * margin, whole.y - top - margin});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, button_padding(whole));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.5F * context.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0F * context.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {margin, std::round(0.75F * margin)});
  bool is_open = true;
  ImGui::Begin(title.c_str(), &is_open, dialog_window);
  ImGui::PopStyleVar(3);
  entry->draw(context);
  if (session.dialog != Dialog::none) form.belongs_to = entry->id;
  ImGui::End();
  ImGui::PopStyleVar();
  if (!is_open) context.apply(CloseDialog{});
}

void draw_notice(const PanelContext& context, const ScreenBox& scene) {
  const Session& session = context.session;
  if (!session.notice) return;
  const ImVec2 corner = imgui_vector(scene.least);
  const ImVec2 size = imgui_vector(scene.extent());
  const float scale = context.scale;
  const float width = std::min(620.0F * scale, size.x - 32.0F * scale);
  const float margin = 14.0F * scale;
  // To the right: the legend is on the left.
  const float right = corner.x + size.x - margin;
  if (const float room = size.y - 2.0F * margin; room >= 90.0F * scale) {
    ImGui::SetNextWindowPos({right, corner.y + margin}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {width, room});
  } else {
    // Plots have left the scene too low for it: it lies on them, between their buttons and the bar at the bottom.
    const float bottom = ImGui::GetIO().DisplaySize.y - 32.0F * scale - margin;
    ImGui::SetNextWindowPos({right, bottom}, ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {width, 110.0F * scale});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0F * scale);
  ImGui::PushStyleColor(ImGuiCol_Border,
                        unpacked(session.notice->is_problem ? context.theme.problem : context.theme.accent));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, unpacked(context.theme.panel_field));
  // News go by themselves: what is below them can be taken hold of meanwhile.
  const bool is_problem = session.notice->is_problem;
  ImGui::Begin(notice_window, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | (is_problem ? 0 : ImGuiWindowFlags_NoInputs));
  // On the stage, letters are made for a room.
  constexpr float stage_letters = 1.35F;
  ImGui::PushFont(nullptr, ImGui::GetStyle().FontSizeBase * (session.face == Face::stage ? stage_letters : 1.0F));
  if (is_problem) text_in(context.fonts.bold, stage_language(session.language).notices.problem);
  const std::string& words = session.notice->words;
  const float wrap = std::min(width - 32.0F * scale, ImGui::CalcTextSize(words.c_str()).x + 4.0F * scale);
  wrapped_text(words, ImGui::GetCursorPosX() + wrap);
  bool enough = false;
  if (is_problem) {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    const std::string_view close = stage_language(session.language).notices.close;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, button_padding(whole));
    enough = is_phone(whole) ? ImGui::Button(close.data()) : ImGui::SmallButton(close.data());
    ImGui::PopStyleVar();
  }
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
  if (enough) context.apply(CloseNotice{});
}

// What an author of shaders needs to see: what the driver said, and which line it meant.
void draw_shader_problem(const PanelContext& context, const ScreenBox& scene) {
  const std::string_view problem = context.loop.shader_problem;
  if (problem.empty()) return;
  const ImVec2 corner = imgui_vector(scene.least);
  const ImVec2 size = imgui_vector(scene.extent());
  const float margin = 14.0F * context.scale;
  ImGui::SetNextWindowPos({corner.x + margin, corner.y + 0.45F * size.y});
  ImGui::SetNextWindowSize({size.x - 2.0F * margin, 0.55F * size.y - margin});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * context.scale);
  ImGui::PushStyleColor(ImGuiCol_Border, unpacked(context.theme.problem));
  ImGui::Begin("The shaders do not compile; the previous ones are in use", nullptr,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
  text_in(context.fonts.number, problem);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace ghostforce
