#include "app/widgets/controls.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "app/widgets/focus.h"
#include "app/widgets/symbol_text.h"
#include "core/conventions.h"
#include "core/scene.h"

namespace ghostforce {

ImU32 packed(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

ImVec4 unpacked(Colour colour) {
  return ImGui::ColorConvertU32ToFloat4(packed(colour));
}

void text_in(ImFont* font, std::string_view words) {
  ImGui::PushFont(font, 0.0F);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopFont();
}

void text_in(Colour colour, std::string_view words) {
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(colour));
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopStyleColor();
}

void wrapped_text(std::string_view words, float end) {
  const float right = end > 0.0F ? end : ImGui::GetContentRegionMax().x;
  symbol_text(words, std::max(1.0F, right - ImGui::GetCursorPosX()));
}

float button_width(const char* words) {
  return ImGui::CalcTextSize(words).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

float letters_for(const std::string& words, ImFont* font, float room, float height) {
  const float width = font->CalcTextSizeA(height, 1e9F, 0.0F, words.c_str()).x;
  return width <= room ? height : height * room / width;
}

void draw_glyph(ImDrawList& draw_list, ImVec2 center, float radius, Shape shape, Colour fill) {
  const ImU32 colour = packed(fill);
  switch (shape) {
    case Shape::disc:
      draw_list.AddCircleFilled(center, radius, colour, 24);
      break;
    case Shape::diamond:
      draw_list.AddNgonFilled(center, 1.25F * radius, colour, 4);
      break;
    case Shape::triangle: {
      const float side = 1.2F * radius;
      draw_list.AddTriangleFilled({center.x, center.y - 1.1F * radius}, {center.x + side, center.y + 0.95F * radius},
                                  {center.x - side, center.y + 0.95F * radius}, colour);
      break;
    }
  }
}

bool begin_rows(const char* id, const PanelContext& context) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return false;
  // A narrow panel breaks the names rather than the controls.
  const float names = std::min(144.0F * context.scale, 0.4F * ImGui::GetContentRegionAvail().x);
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, names);
  ImGui::TableSetupColumn("control", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

namespace {

template <typename Explanation>
void any_row(const char* name, const Explanation& explanation) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  symbol_text(name, ImGui::GetContentRegionAvail().x);
  tooltip(explanation);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1.0F);
}

// Of a number in the scene's files.
SliderLimits range_of(std::string_view name) {
  for (const SceneKey& key : scene_keys()) {
    if (key.name != name) continue;
    if (const auto* number = std::get_if<NumberKey>(&key.value)) return {number->least, number->greatest};
    if (const auto* number = std::get_if<OptionalNumberKey>(&key.value)) return {number->least, number->greatest};
  }
  throw std::logic_error(fmt::format("no number is called {} in a scene", name));
}

// Three significant digits, or all before the point.
const char* format_for(double newton_per_metre) {
  if (newton_per_metre >= 100.0) return "%.0f N/m";
  if (newton_per_metre >= 10.0) return "%.1f N/m";
  return "%.2f N/m";
}

int grow(ImGuiInputTextCallbackData* data) {
  if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
  auto& text = *static_cast<std::string*>(data->UserData);
  text.resize(static_cast<std::size_t>(data->BufTextLen));
  data->Buf = text.data();
  return 0;
}

}  // namespace

void row(const char* name, Term term) {
  any_row(name, term);
}

void row(const char* name, std::string_view sentence) {
  any_row(name, sentence);
}

void end_rows() {
  ImGui::EndTable();
}

void same_line_if_room(float width) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
  if (end <= right) ImGui::SameLine();
}

bool text_field(const char* id, const char* hint, std::string& text, ImGuiInputTextFlags flags) {
  return ImGui::InputTextWithHint(id, hint, text.data(), text.capacity() + 1,
                                  flags | ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_EnterReturnsTrue,
                                  grow, &text);
}

bool search_field(const char* id, const char* hint, std::string& text) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTextEnterKeepActive = true;
  const bool entered = text_field(id, hint, text, ImGuiInputTextFlags_CallbackHistory);
  io.ConfigInputTextEnterKeepActive = false;
  return entered;
}

namespace {

std::string number_in(const char* format, double value) {
  std::array<char, 64> text{};
  ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), ImGuiDataType_Double, &value, format);
  std::string words = text.data();
  if (words.starts_with('-')) {
    const bool is_zero = words.find_first_of("123456789") == std::string::npos;
    words.replace(0, 1, is_zero ? "" : "−");
  }
  return words;
}

// By Enter where it has the focus, or by a click with Ctrl.
bool is_asked_for_a_number(ImGuiID id) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool by_enter = context.NavActivateId == id && (context.NavActivateFlags & ImGuiActivateFlags_PreferInput) != 0;
  return by_enter || context.IO.KeyCtrl;
}

// A slider of Dear ImGui whose number is drawn here, with a real minus sign, and which obeys the keyboard.
template <typename Nudged>
bool any_slider(const char* id, double& value, const SliderLimits& limits, const char* format, ImGuiSliderFlags flags,
                const Nudged& nudged) {
  const ImGuiID own = ImGui::GetID(id);
  const bool was_typing = ImGui::TempInputIsActive(own);
  // Tab alone would turn it into a field at once.
  if (!was_typing && !is_asked_for_a_number(own)) flags |= ImGuiSliderFlags_NoInput;
  if (!was_typing) ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
  bool is_changed =
      ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &limits.least, &limits.greatest, format, flags);
  if (!was_typing) ImGui::PopStyleColor();
  for (const Nudge& nudge : take_nudges()) {
    const double before = value;
    value = nudge.way == Nudge::Way::to_least      ? limits.least
            : nudge.way == Nudge::Way::to_greatest ? limits.greatest
                                                   : nudged(value, nudge.steps);
    is_changed = is_changed || value != before;
  }
  if (!was_typing && !ImGui::TempInputIsActive(own)) {
    const std::string words = number_in(format, value);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    // In the half where the knob is not.
    const bool is_logarithmic = (flags & ImGuiSliderFlags_Logarithmic) != 0;
    const double middle =
        is_logarithmic ? std::sqrt(limits.least * limits.greatest) : 0.5 * (limits.least + limits.greatest);
    const float padding = ImGui::GetStyle().FramePadding.x;
    const ImVec2 least{ImGui::GetItemRectMin().x + padding, ImGui::GetItemRectMin().y};
    const ImVec2 most{ImGui::GetItemRectMax().x - padding, ImGui::GetItemRectMax().y};
    ImGui::RenderTextClipped(least, most, words.c_str(), nullptr, &size, {value < middle ? 1.0F : 0.0F, 0.5F});
  }
  return is_changed;
}

// As a file has it: three digits.
double with_three_digits(double value) {
  if (!(value > 0.0)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::round(value / unit) * unit;
}

}  // namespace

bool slider(const char* id, double& value, const SliderLimits& limits, const char* format, ImGuiSliderFlags flags) {
  const bool is_logarithmic = (flags & ImGuiSliderFlags_Logarithmic) != 0;
  return any_slider(id, value, limits, format, flags, [&](double before, double steps) {
    const double after = is_logarithmic
                             ? with_three_digits(before * std::pow(limits.greatest / limits.least, 0.01 * steps))
                             : before + 0.01 * steps * (limits.greatest - limits.least);
    // What was typed may lie beyond the slider's ends: no step leads farther.
    return std::clamp(after, std::min(before, limits.least), std::max(before, limits.greatest));
  });
}

bool stiffness_slider(const char* id, std::string_view key, double& newton_per_metre, const SliderLimits& limits) {
  if (!slider(id, newton_per_metre, limits, format_for(newton_per_metre), ImGuiSliderFlags_Logarithmic)) return false;
  const SliderLimits range = range_of(key);
  newton_per_metre = std::clamp(newton_per_metre, range.least, range.greatest);
  return true;
}

float dialog_field_width(float points, const PanelContext& context) {
  return std::min(points * context.scale, ImGui::GetIO().DisplaySize.x - 80.0F * context.scale);
}

bool is_dragged() {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  return ImGui::IsItemActive() || (ImGui::IsItemDeactivated() && (moved.x != 0.0F || moved.y != 0.0F));
}

void close_popup_on_escape() {
  if (ImGui::IsKeyPressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
}

bool angle_slider(const char* id, double& radians) {
  double shown = std::remainder(radians, 2.0 * std::numbers::pi) * degrees_per_radian;
  const auto turned = [](double before, double steps) {
    // To whole steps, so that holding the key down runs through round angles.
    const double step = std::abs(steps);
    constexpr double rounding = 1e-6;
    return step *
           (steps > 0.0 ? std::floor(before / step + rounding) + 1.0 : std::ceil(before / step - rounding) - 1.0);
  };
  if (!any_slider(id, shown, {-180.0, 180.0}, "%.1f°", ImGuiSliderFlags_None, turned)) return false;
  radians = std::remainder(shown / degrees_per_radian, 2.0 * std::numbers::pi);
  return true;
}

void draw_strategy_name(const PanelContext& context, const Strategy& entry, ImFont* font) {
  const std::size_t i = index_of(entry.id);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  draw_glyph(*ImGui::GetWindowDrawList(), {corner.x + 0.6F * height, corner.y + 0.5F * height}, 0.38F * height,
             strategy_style(entry.id).shape, context.theme.strategy[i]);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.4F * height);
  ImGui::PushFont(font, 0.0F);
  text_in(context.theme.strategy_text[i], {&entry.letter, 1});
  ImGui::PopFont();
  tooltip(entry.sentence);
}

void number_cell(const PanelContext& context, const std::string& text) {
  ImGui::TableNextColumn();
  text_in(context.fonts.number, text);
}

}  // namespace ghostforce
