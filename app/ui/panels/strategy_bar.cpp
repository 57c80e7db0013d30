// The bar on top: which strategy is on the device, what is compared, and how time runs.
#include <fmt/format.h>

#include <array>
#include <string>

#include "app/session/key_bindings.h"
#include "app/session/motor_button.h"
#include "app/ui/panels/hints.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/panels/recording.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

// How much room there is for the same things [letter heights].
struct BarSizes {
  bool has_titles;  // of strategies: else their letters must do
  float pad;        // in a strategy's button
  float compare;
  float speed;
  float sign;  // width of a button with a sign, in heights of it
  float gap;   // between groups [points]
};
constexpr BarSizes wide{.has_titles = true, .pad = 1.2F, .compare = 9.6F, .speed = 4.8F, .sign = 1.15F, .gap = 14.0F};
constexpr BarSizes narrow{.has_titles = false, .pad = 0.7F, .compare = 7.6F, .speed = 4.0F, .sign = 0.9F, .gap = 6.0F};

const BarSizes& bar_sizes(const PanelContext& context) {
  // The button of the motors is one more thing to see.
  const float needed = context.loop.motors.has_motors ? 1010.0F : 930.0F;
  return ImGui::GetWindowWidth() < needed * context.scale ? narrow : wide;
}

void draw_strategy_button(const PanelContext& context, const Strategy& entry, float height) {
  const std::size_t i = index_of(entry.id);
  const bool active = entry.id == context.session.settings.active;
  const BarSizes& sizes = bar_sizes(context);
  const std::string words = sizes.has_titles ? std::string(entry.title) : std::string(1, entry.letter);
  const float glyph = 0.4F * ImGui::GetFontSize();
  const float key_width = 1.5F * ImGui::GetFontSize();
  ImGui::PushFont(active ? context.fonts.bold : context.fonts.regular, 0.0F);
  // As wide as the bold words, so that choosing does not make the bar jump.
  const float words_width = context.fonts.bold->CalcTextSizeA(ImGui::GetFontSize(), 1e9F, 0.0F, words.c_str()).x;
  const ImVec2 size{key_width + 2.6F * glyph + words_width + sizes.pad * ImGui::GetFontSize(), height};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(i));
  if (ImGui::InvisibleButton("strategy", size, ImGuiButtonFlags_EnableNav)) context.session.settings.active = entry.id;
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  const bool is_hinted = i == 2 && points_at(context.session, HintTarget::third_strategy);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const float rounding = ImGui::GetStyle().FrameRounding;
  const double tint = active ? active_tint : hovered ? 0.5 * active_tint : 0.0;
  draw_list.AddRectFilled(corner, end, packed(mix(context.theme.panel_field, context.theme.strategy[i], tint)),
                          rounding);
  const Colour rim = is_hinted ? context.theme.accent : active ? context.theme.strategy[i] : context.theme.panel_border;
  draw_list.AddRect(corner, end, packed(rim), rounding, 0, (is_hinted ? 3.0F : active ? 2.0F : 1.0F) * context.scale);
  const float text_y = corner.y + 0.5F * (size.y - ImGui::GetFontSize());
  const float pad = 0.5F * ImGui::GetFontSize();
  draw_list.AddText({corner.x + pad, text_y}, packed(context.theme.faint_text), fmt::format("{}", i + 1).c_str());
  draw_glyph(draw_list, {corner.x + key_width + glyph, corner.y + 0.5F * size.y}, glyph, strategy_style(entry.id).shape,
             context.theme.strategy[i]);
  draw_list.AddText({corner.x + key_width + 2.6F * glyph + 0.3F * pad, text_y},
                    packed(active ? context.theme.strategy_text[i] : context.theme.text), words.c_str());
  ImGui::PopFont();
  tooltip(entry.sentence);
  ImGui::SameLine();
}

// A combo box as high as the bar's buttons.
template <typename DrawChoices>
void bar_combo(const char* id, const std::string& shown, float width, float height, DrawChoices&& draw_choices) {
  ImGui::SetNextItemWidth(width);
  const float pad = 0.5F * (height - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, pad});
  if (ImGui::BeginCombo(id, shown.c_str())) {
    close_popup_on_escape();
    draw_choices();
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
}

void draw_compare(Session& session, float width, float height) {
  const CompareMode& mode = compare_catalog()[static_cast<std::size_t>(session.options.compare)];
  bar_combo("##compare", std::string(mode.title), width * ImGui::GetFontSize(), height, [&] {
    for (const CompareMode& each : compare_catalog()) {
      if (ImGui::Selectable(each.title.data(), each.id == session.options.compare)) session.options.compare = each.id;
    }
  });
  tooltip("Compare: all strategies in one picture, a picture for each, or the active one only. Key 0.");
}

void draw_speed(Session& session, float width, float height) {
  constexpr std::array speeds{1.0, 0.5, 0.2, 0.1, 0.02};
  bar_combo("##speed", fmt::format("{:g}×", session.speed), width * ImGui::GetFontSize(), height, [&] {
    for (const double speed : speeds) {
      if (ImGui::Selectable(fmt::format("{:g}×", speed).c_str(), speed == session.speed)) session.speed = speed;
    }
  });
  tooltip("Slow motion: fewer ticks per second, and the same physics.");
}

// Signs that everybody knows, drawn because the font has none of them. `unit` is half the sign's height.
using DrawSign = void (*)(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour);

void draw_play_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddTriangleFilled({middle.x - 0.7F * unit, middle.y - unit}, {middle.x + unit, middle.y},
                              {middle.x - 0.7F * unit, middle.y + unit}, colour);
}

void draw_pause_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  for (const float side : {-1.0F, 1.0F}) {
    const float x = middle.x + 0.5F * side * unit;
    draw_list.AddRectFilled({x - 0.28F * unit, middle.y - unit}, {x + 0.28F * unit, middle.y + unit}, colour);
  }
}

void draw_step_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddTriangleFilled({middle.x - unit, middle.y - unit}, {middle.x + 0.4F * unit, middle.y},
                              {middle.x - unit, middle.y + unit}, colour);
  draw_list.AddRectFilled({middle.x + 0.5F * unit, middle.y - unit}, {middle.x + 0.95F * unit, middle.y + unit},
                          colour);
}

// Three quarters of a circle and an arrow head: once more.
void draw_reset_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  constexpr float quarter = 1.5708F;
  draw_list.PathArcTo(middle, 0.85F * unit, -0.6F * quarter, 2.6F * quarter, 24);
  draw_list.PathStroke(colour, 0, 0.3F * unit);
  const ImVec2 end{middle.x + 0.5F * unit, middle.y - 0.69F * unit};
  draw_list.AddTriangleFilled({end.x - 0.75F * unit, end.y - 0.3F * unit}, {end.x + 0.5F * unit, end.y - 0.75F * unit},
                              {end.x + 0.35F * unit, end.y + 0.6F * unit}, colour);
}

void draw_record_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddCircleFilled(middle, unit, colour, 24);
}

bool icon_button(const char* id, DrawSign draw_sign, Colour colour, const PanelContext& context, float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = bar_sizes(context).sign * height;
  const bool pressed = ImGui::Button(id, {width, height});
  draw_sign(*ImGui::GetWindowDrawList(), {corner.x + 0.5F * width, corner.y + 0.5F * height}, 0.22F * height,
            packed(colour));
  return pressed;
}

bool icon_button(const char* id, DrawSign draw_sign, const PanelContext& context, float height) {
  return icon_button(id, draw_sign, context.theme.text, context, height);
}

void draw_record_button(const PanelContext& context, float height) {
  const bool is_on = context.loop.recording.is_on;
  if (is_on) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 2.5F * context.scale);
    ImGui::PushStyleColor(ImGuiCol_Border, unpacked(context.theme.problem));
  }
  if (icon_button("##record", draw_record_sign, is_on ? context.theme.problem : context.theme.text, context, height)) {
    toggle_recording(context);
  }
  if (is_on) {
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
  }
  tooltip(is_on ? fmt::format("Recording: {}. Press to stop.", words_about(context.loop.recording))
                : "Records every tick to a new file, which any spreadsheet opens and which can be replayed.");
}

void draw_safety_button(const PanelContext& context, float height) {
  const MotorReport& motors = context.loop.motors;
  const std::string words = safety_words(motors);
  const float width = ImGui::CalcTextSize(words.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine();
  const bool fits = ImGui::GetContentRegionAvail().x >= width;
  if (!fits && !motors.has_motors) {
    ImGui::NewLine();
    return;  // it says nothing that one has to know
  }
  // With motors it is there, whatever it covers.
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
  const bool stands_out = motors.has_motors && (motors.state != SafetyState::off || motors.reason != OffReason::none);
  const Colour rim = motors.state == SafetyState::off ? context.theme.accent : context.theme.problem;
  ImGui::BeginDisabled(!can_press_safety_button(motors));
  if (stands_out) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 2.5F * context.scale);
    ImGui::PushStyleColor(ImGuiCol_Border, unpacked(rim));
  }
  if (ImGui::Button((words + "###motors").c_str(), {width, height})) press_safety_button(context.session, motors);
  if (stands_out) {
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
  }
  ImGui::EndDisabled();
  if (!motors.has_motors) {
    tooltip("No device with a motor is in use: the forces on screen are the model's.");
  } else if (motors.state == SafetyState::off && motors.reason != OffReason::none) {
    tooltip(entry_of(motors.reason).remedy);
  } else {
    tooltip("Lets the device push. Esc turns it off at any time.");
  }
}

}  // namespace

void draw_strategy_bar(const PanelContext& context) {
  Session& session = context.session;
  const float height = 30.0F * context.scale;
  for (const Strategy& entry : strategy_catalog()) draw_strategy_button(context, entry, height);

  const BarSizes& sizes = bar_sizes(context);
  ImGui::SameLine(0.0F, sizes.gap * context.scale);
  draw_compare(session, sizes.compare, height);
  ImGui::SameLine(0.0F, sizes.gap * context.scale);
  // Nobody stops the time of a real hand.
  ImGui::BeginDisabled(context.snapshot.measured.has_value());
  if (icon_button("##pause", session.paused ? draw_play_sign : draw_pause_sign, context, height)) toggle_pause(session);
  tooltip(session.paused ? "Lets model time go on. Space." : "Stops model time. Space.");
  ImGui::SameLine();
  if (icon_button("##step", draw_step_sign, context, height)) single_step(session);
  tooltip("One tick of the loop, then pause. The key is the full stop.");
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (icon_button("##reset", draw_reset_sign, context, height)) restart(session);
  tooltip("Starts the motion again. Key R; Alt+R resets the settings too.");
  ImGui::SameLine();
  ImGui::BeginDisabled(context.snapshot.measured.has_value());
  draw_speed(session, sizes.speed, height);
  ImGui::EndDisabled();
  ImGui::SameLine();
  draw_record_button(context, height);

  draw_safety_button(context, height);
}

}  // namespace ghostforce
