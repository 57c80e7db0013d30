#include "app/workbench/plot_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "app/picture/ticks.h"
#include "app/widgets/controls.h"

namespace ghostforce {
namespace {

constexpr float glyph_radius = 4.5F;
constexpr float glyph_spacing = 130.0F;  // [points], more or less

bool is_inside(ImVec2 at) {
  const ImVec2 corner = ImPlot::GetPlotPos();
  const ImVec2 size = ImPlot::GetPlotSize();
  return at.x >= corner.x && at.y >= corner.y && at.x <= corner.x + size.x && at.y <= corner.y + size.y;
}

}  // namespace

void apply_plot_style(const Theme& theme, float scale) {
  ImPlotStyle style;
  style.PlotMinSize = {40.0F * scale, 20.0F * scale};
  style.PlotBorderSize = scale;
  style.MajorTickLen = {4.0F * scale, 4.0F * scale};
  style.MinorTickLen = {0.0F, 0.0F};
  style.MajorGridSize = {scale, scale};
  style.MinorGridSize = {0.0F, 0.0F};
  style.PlotPadding = {14.0F * scale, 2.0F * scale};  // the last number at an axis stands out by half
  style.LabelPadding = {3.0F * scale, 2.0F * scale};
  const auto set = [&](ImPlotCol which, Colour colour) { style.Colors[which] = unpacked(colour); };
  set(ImPlotCol_FrameBg, theme.panel);
  set(ImPlotCol_PlotBg, theme.background);
  set(ImPlotCol_PlotBorder, theme.panel_border);
  set(ImPlotCol_InlayText, theme.text);
  set(ImPlotCol_AxisText, theme.text);
  set(ImPlotCol_AxisGrid, theme.grid);
  set(ImPlotCol_AxisTick, theme.panel_border);
  set(ImPlotCol_AxisBg, theme.panel);
  set(ImPlotCol_AxisBgHovered, theme.panel);
  set(ImPlotCol_AxisBgActive, theme.panel);
  ImPlot::GetStyle() = style;
}

void draw_strategy_curve(const PanelContext& context, StrategyId id, std::span<const double> x,
                         std::span<const double> y) {
  if (x.empty()) return;
  const std::size_t i = index_of(id);
  const bool in_front = id == context.settings.active;
  ImPlotSpec look;
  look.LineColor = unpacked(context.theme.strategy[i]);
  look.LineWeight = (in_front ? 2.4F : 1.5F) * static_cast<float>(context.theme.thickness) * context.scale;
  ImPlot::PlotLine(strategy(id).name.data(), x.data(), y.data(), static_cast<int>(x.size()), look);

  // Each strategy's shapes at other places, so that curves on top of each other can still be told apart.
  const int shapes = std::max(2, static_cast<int>(ImPlot::GetPlotSize().x / (glyph_spacing * context.scale)));
  ImDrawList& draw_list = *ImPlot::GetPlotDrawList();
  for (int k = 0; k < shapes; ++k) {
    const double share = (k + 0.25 + 0.25 * static_cast<double>(i)) / shapes;
    const auto at = static_cast<std::size_t>(share * static_cast<double>(x.size() - 1));
    const ImVec2 place = ImPlot::PlotToPixels(x[at], y[at]);
    if (!std::isfinite(y[at]) || !is_inside(place)) continue;
    draw_glyph(draw_list, place, glyph_radius * context.scale, strategy_style(id).shape, context.theme.strategy[i]);
  }
}

void set_up_ticks(ImAxis axis, const PlotRange& range, float length, std::string_view unit) {
  const bool is_horizontal = axis < ImAxis_Y1;
  const std::function<double(std::string_view)> extent = [&](std::string_view words) {
    const std::string whole = std::string(words) + std::string(unit);
    const ImVec2 size = ImGui::CalcTextSize(whole.c_str());
    return static_cast<double>(is_horizontal ? size.x : size.y);
  };
  const double gap = static_cast<double>(ImGui::GetFontSize()) * (is_horizontal ? 1.6 : 1.0);
  const Ticks ticks =
      choose_ticks({range.least, range.greatest, false, false, static_cast<double>(length), gap, extent});
  std::vector<double> values;
  std::vector<std::string> words;
  for (const Tick& tick : ticks.named) {
    values.push_back(tick.value);
    words.push_back(tick.words + std::string(unit));
  }
  set_up_ticks(axis, values, words);
}

void set_up_ticks(ImAxis axis, std::span<const double> marks, std::span<const std::string> words) {
  std::vector<const char*> labels;
  for (const std::string& each : words) labels.push_back(each.c_str());
  ImPlot::SetupAxisTicks(axis, marks.data(), static_cast<int>(marks.size()), labels.data());
}

void draw_upright_line(const PanelContext& context, double x, float thickness) {
  const float at = ImPlot::PlotToPixels(x, 0.0).x;
  const ImVec2 corner = ImPlot::GetPlotPos();
  if (at < corner.x || at > corner.x + ImPlot::GetPlotSize().x) return;
  ImPlot::GetPlotDrawList()->AddLine({at, corner.y}, {at, corner.y + ImPlot::GetPlotSize().y},
                                     packed(context.theme.accent),
                                     thickness * static_cast<float>(context.theme.thickness) * context.scale);
}

void draw_strategy_point(const PanelContext& context, StrategyId id, double x, double y, bool is_hollow) {
  const ImVec2 place = ImPlot::PlotToPixels(x, y);
  if (!is_inside(place)) return;
  const float radius = (is_hollow ? 8.5F : 7.0F) * context.scale;
  ImDrawList& draw_list = *ImPlot::GetPlotDrawList();
  const Colour colour = context.theme.strategy[index_of(id)];
  if (is_hollow) {
    draw_list.AddCircle(place, radius, packed(colour), 32, 1.5F * context.scale);
    return;
  }
  draw_glyph(draw_list, place, radius + 1.5F * context.scale, strategy_style(id).shape, context.theme.background);
  draw_glyph(draw_list, place, radius, strategy_style(id).shape, colour);
}

PlotRange roomy(double least, double greatest, double smallest) {
  const double missing = std::max(0.0, smallest - (greatest - least));
  // What is missing goes where there is nothing yet: a curve that is 0 stays at the bottom.
  least >= 0.0 ? greatest += missing : least -= missing;
  const double room = 0.12 * (greatest - least);
  return {least - room, greatest + room};
}

namespace {

constexpr ImPlotAxisFlags quiet_axis =
    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoSideSwitch | ImPlotAxisFlags_NoHighlight;

// Whoever drags means the times in sight.
bool is_click() {
  const float threshold = ImGui::GetIO().MouseDragThreshold;
  return ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
         ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < threshold * threshold;
}

void bring_into_sight(double time_s, PlotView& view) {
  const double span = view.span_s();
  const double margin = 0.1 * span;
  if (time_s < view.from_s) view.from_s = time_s - margin;
  if (time_s > view.to_s) view.from_s = time_s + margin - span;
  view.to_s = view.from_s + span;
}

}  // namespace

void bring_times_into_sight(const PanelContext& context, const PlotHistory& history) {
  PlotView& view = context.memory.plots;
  if (view.follows) {
    const double span = view.span_s();
    view.to_s = history.is_empty() ? span : history.newest_s();
    view.from_s = view.to_s - span;
  }
  if (const auto looks_back_to_s = context.session.stage.looks_back_to_s) bring_into_sight(*looks_back_to_s, view);
}

void set_up_time_axis(PlotView& view, bool has_words, float width) {
  ImPlot::SetupAxis(ImAxis_X1, nullptr, quiet_axis | (has_words ? 0 : ImPlotAxisFlags_NoTickLabels));
  ImPlot::SetupAxisLinks(ImAxis_X1, &view.from_s, &view.to_s);
  ImPlot::SetupAxisZoomConstraints(ImAxis_X1, PlotView::shortest_span_s, PlotView::longest_span_s);
  set_up_ticks(ImAxis_X1, {view.from_s, view.to_s}, width - 4.0F * ImGui::GetFontSize(), " s");
}

void set_up_value_axis(double least, double greatest, float height) {
  ImPlot::SetupAxis(ImAxis_Y1, nullptr, quiet_axis | ImPlotAxisFlags_Lock);
  ImPlot::SetupAxisLimits(ImAxis_Y1, least, greatest, ImPlotCond_Always);
  set_up_ticks(ImAxis_Y1, {least, greatest}, height, "");
}

std::optional<double> draw_time_cursor(const PanelContext& context) {
  const std::optional<double>& looks_back_to_s = context.session.stage.looks_back_to_s;
  if (const auto cursor_s = context.session.plots.cursor_s) draw_upright_line(context, *cursor_s, 1.0F);
  if (looks_back_to_s) draw_upright_line(context, *looks_back_to_s, 2.0F);
  if (!ImPlot::IsPlotHovered()) return std::nullopt;
  const double pointer_s = ImPlot::GetPlotMousePos().x;
  if (is_click()) context.apply(LookBackTo{pointer_s});
  return pointer_s;
}

void keep_times(PlotView& view, const PlotView& before, std::optional<double> cursor_s) {
  view.cursor_s = cursor_s;
  // The wheel chooses how long a time is in sight; whoever drags looks at a moment.
  const bool has_moved = view.from_s != before.from_s || view.to_s != before.to_s;
  if (has_moved && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) view.follows = false;
}

}  // namespace ghostforce
