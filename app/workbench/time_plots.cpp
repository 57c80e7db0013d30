// The quantities of the three strategies over time: four plots with one time axis and one cursor.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/widgets/controls.h"
#include "app/workbench/drawer.h"
#include "app/workbench/plot_pieces.h"

namespace ghostforce {
namespace {

constexpr int rows = 2;
constexpr int columns = 2;
static_assert(rows * columns == quantity_count);
// A range smaller than this would magnify what nobody can feel [unit of the quantity].
constexpr double smallest_range = 1.0;

// A bucket of several ticks is a stroke between its least and its greatest. It begins with the one nearer to where the
// last ended: less of a way for the line to go is less to draw.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

Curve curve_of(const std::vector<PlotBucket>& buckets, std::size_t quantity, std::size_t strategy) {
  Curve curve;
  curve.x.reserve(2 * buckets.size());
  curve.y.reserve(2 * buckets.size());
  for (const PlotBucket& bucket : buckets) {
    double first = bucket.least[quantity][strategy];
    double second = bucket.greatest[quantity][strategy];
    const bool is_stroke = first < second;
    if (!curve.y.empty() && std::abs(second - curve.y.back()) < std::abs(first - curve.y.back())) {
      std::swap(first, second);
    }
    const double middle = 0.5 * (bucket.from_s + bucket.to_s);
    curve.x.push_back(middle);
    curve.y.push_back(first);
    if (!is_stroke) continue;
    curve.x.push_back(middle);
    curve.y.push_back(second);
  }
  return curve;
}

PlotRange range_of(const std::vector<PlotBucket>& buckets, std::size_t quantity) {
  double least = 0.0;
  double greatest = 0.0;
  for (const PlotBucket& bucket : buckets) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      least = std::fmin(least, bucket.least[quantity][i]);
      greatest = std::fmax(greatest, bucket.greatest[quantity][i]);
    }
  }
  return roomy(least, greatest, smallest_range);
}

// The middle of the longest time in which nobody knew the quantity, if that is long enough for words.
std::optional<double> middle_of_unknown(const std::vector<PlotBucket>& buckets, std::size_t quantity,
                                        double shortest_s) {
  std::optional<double> middle;
  std::size_t begin = 0;
  for (std::size_t end = 0; end <= buckets.size(); ++end) {
    const auto is_unknown = [](double value) { return std::isnan(value); };
    if (end < buckets.size() && std::ranges::all_of(buckets[end].least[quantity], is_unknown)) continue;
    if (end > begin && buckets[end - 1].to_s - buckets[begin].from_s >= shortest_s) {
      shortest_s = buckets[end - 1].to_s - buckets[begin].from_s;
      middle = 0.5 * (buckets[end - 1].to_s + buckets[begin].from_s);
    }
    begin = end + 1;
  }
  return middle;
}

// Name and unit, and at the right the values under the cursor.
void draw_head(const PanelContext& context, const Quantity& quantity, std::size_t index, const PlotBucket* cursor,
               float width) {
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(fmt::format("{} [{}]", quantity.title, quantity.unit).c_str());
  tooltip(quantity.term);
  if (cursor == nullptr) return;
  std::array<std::string, strategy_count> words;
  const float glyph_room = ImGui::GetFontSize();
  float needed = 0.0F;
  ImGui::PushFont(context.fonts.number, 0.0F);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const double value = cursor->greatest[index][i];
    words[i] = fmt::format("{:>8}", std::isnan(value) ? "—" : decimal_text(value, quantity.decimals));
    needed += glyph_room + ImGui::CalcTextSize(words[i].c_str()).x;
  }
  if (ImGui::GetItemRectSize().x + needed < width) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width - needed - ImGui::GetStyle().ItemSpacing.x);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      // Its shape: the letter N would read as newton.
      const ImVec2 corner = ImGui::GetCursorScreenPos();
      draw_glyph(*ImGui::GetWindowDrawList(),
                 {corner.x + 0.7F * glyph_room, corner.y + 0.5F * ImGui::GetTextLineHeight()}, 0.3F * glyph_room,
                 strategy_style(strategy_catalog()[i].id).shape, context.theme.strategy[i]);
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + glyph_room);
      text_in(context.theme.strategy_text[i], words[i]);
      ImGui::SameLine(0.0F, 0.0F);
    }
    ImGui::NewLine();
  }
  ImGui::PopFont();
}

// One quantity; the time under the pointer, if it is there.
std::optional<double> draw_plot(const PanelContext& context, const std::vector<PlotBucket>& buckets, std::size_t q,
                                bool has_time_axis, ImVec2 size, float canvas) {
  PlotView& view = context.memory.plots;
  if (!ImPlot::BeginPlot("##plot", size, quiet_plot)) return std::nullopt;
  set_up_time_axis(view, has_time_axis, size.x);
  const PlotRange range = range_of(buckets, q);
  set_up_value_axis(range.least, range.greatest, canvas);
  for_each_strategy(context, [&](StrategyId id) {
    const Curve curve = curve_of(buckets, q, index_of(id));
    draw_strategy_curve(context, id, curve.x, curve.y);
  });
  const double seconds_per_pixel = view.span_s() / static_cast<double>(ImPlot::GetPlotSize().x);
  const double width_s = static_cast<double>(ImGui::CalcTextSize(unknown).x) * seconds_per_pixel;
  if (const auto middle = middle_of_unknown(buckets, q, width_s)) {
    ImPlot::PlotText(unknown, *middle, 0.5 * (range.least + range.greatest));
  }
  const std::optional<double> cursor = draw_time_cursor(context);
  ImPlot::EndPlot();
  return cursor;
}

}  // namespace

void draw_time_plots(const PanelContext& context, const PlotHistory& history) {
  PlotView& view = context.memory.plots;
  bring_times_into_sight(context, history);
  const PlotView before = view;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  const float width = (room.x - spacing.x * (columns - 1)) / columns;
  const float head = ImGui::GetTextLineHeightWithSpacing();
  const float axis = ImGui::GetTextLineHeight() + 4.0F * context.scale;  // of the lower row, with its tick labels
  const float canvas = (room.y - axis - rows * head - (rows - 1) * spacing.y) / rows;

  const std::vector<PlotBucket> buckets =
      history.between(view.from_s, view.to_s, std::max<std::size_t>(64, static_cast<std::size_t>(width)));
  const std::optional<double> read_at = view.cursor_s ? view.cursor_s : context.session.stage.looks_back_to_s;
  const PlotBucket* const under_cursor = read_at ? history.at(*read_at) : nullptr;
  std::optional<double> cursor;
  for (std::size_t column = 0; column < columns; ++column) {
    if (column > 0) ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::PushID(static_cast<int>(column));
    // Their left edges in one line, however long the numbers at their axes are.
    const bool is_aligned = ImPlot::BeginAlignedPlots("column");
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t q = row * columns + column;
      const bool has_time_axis = row + 1 == rows;
      draw_head(context, quantity_catalog()[q], q, under_cursor, width);
      ImGui::PushID(static_cast<int>(row));
      const ImVec2 size{width, canvas + (has_time_axis ? axis : 0.0F)};
      if (const auto at = draw_plot(context, buckets, q, has_time_axis, size, canvas)) cursor = at;
      ImGui::PopID();
    }
    if (is_aligned) ImPlot::EndAlignedPlots();
    ImGui::PopID();
    ImGui::EndGroup();
  }
  keep_times(view, before, cursor);
}

}  // namespace ghostforce
