// How stiff the hand is, over time: measured live with its band, believed, and given where the hand is a simulated one.
// A bold line in a band, long dashes, and dots: nothing is told by colour alone.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/widgets/controls.h"
#include "app/workbench/drawer.h"
#include "app/workbench/plot_pieces.h"

namespace ghostforce {
namespace {

constexpr double smallest_stiffness_range = 100.0;  // [N/m]
// Estimates that are farther apart have an unknown time between them, even where nothing was made of it [s].
constexpr double longest_step_s = 3.0 * HandHistory::interval_s;
constexpr double band_tint = 0.25;

struct StiffnessLook {
  LinePattern pattern;
  float width;  // [points]
};
constexpr StiffnessLook live_look{solid_line, 2.6F};
constexpr StiffnessLook believed_look{{11.0, 6.0, 11.0, 6.0}, 2.0F};
constexpr StiffnessLook given_look{dotted_line, 2.4F};

Colour believed_colour(const Theme& theme) {
  return theme.strategy_text[index_of(StrategyId::anisotropic)];
}

// Estimates in a row, without a gap.
struct KnownRun {
  std::vector<double> time_s;
  std::vector<double> least, middle, greatest;  // k̂ − σ, k̂, k̂ + σ [N/m]
};

std::vector<KnownRun> known_runs(const std::vector<HandPoint>& points) {
  std::vector<KnownRun> runs;
  bool goes_on = false;
  for (const HandPoint& point : points) {
    const HandEstimate& hand = point.estimate;
    if (!hand.is_known()) {
      goes_on = false;
      continue;
    }
    if (!goes_on || point.time_s - runs.back().time_s.back() > longest_step_s) runs.emplace_back();
    goes_on = true;
    KnownRun& run = runs.back();
    run.time_s.push_back(point.time_s);
    run.least.push_back(hand.k_u - hand.sigma);
    run.middle.push_back(hand.k_u);
    run.greatest.push_back(hand.k_u + hand.sigma);
  }
  return runs;
}

PlotRange stiffness_range(const std::vector<HandPoint>& points) {
  double greatest = 0.0;
  for (const HandPoint& point : points) {
    greatest = std::max({greatest, point.believed_k_u, point.given_k_u.value_or(0.0)});
    if (point.estimate.is_known()) greatest = std::max(greatest, point.estimate.k_u + point.estimate.sigma);
  }
  return {0.0, roomy(0.0, greatest, smallest_stiffness_range).greatest};
}

// Lines of plots have no patterns of their own.
class PatternPen {
 public:
  PatternPen(ImDrawList& draw_list, const StiffnessLook& look, Colour colour, float unit)
      : draw_list_(draw_list),
        pattern_(look.pattern),
        colour_(packed(colour)),
        width_(look.width * unit),
        unit_(unit) {}

  void line_to(ImVec2 end) {
    if (!has_place_) {
      has_place_ = true;
      place_ = end;
      return;
    }
    const ImVec2 way{end.x - place_.x, end.y - place_.y};
    const float length = std::hypot(way.x, way.y);
    const auto at = [&](float share) { return ImVec2{place_.x + share * way.x, place_.y + share * way.y}; };
    float done = 0.0F;
    while (done < length) {
      const float step = std::min(left(), length - done);
      if (piece_ % 2 == 0) draw_list_.AddLine(at(done / length), at((done + step) / length), colour_, width_);
      done += step;
      drawn_ += step;
      if (left() <= 0.0F) {
        piece_ = (piece_ + 1) % pattern_.size();
        drawn_ = 0.0F;
      }
    }
    place_ = end;
  }

 private:
  float left() const { return static_cast<float>(pattern_[piece_]) * unit_ - drawn_; }

  ImDrawList& draw_list_;
  LinePattern pattern_;
  ImU32 colour_;
  float width_;
  float unit_;
  bool has_place_ = false;
  ImVec2 place_{};
  std::size_t piece_ = 0;
  float drawn_ = 0.0F;  // of that piece
};

template <typename Value>
void draw_pattern_curve(const std::vector<HandPoint>& points, const StiffnessLook& look, Colour colour, float unit,
                        const Value& value) {
  ImPlot::PushPlotClipRect();
  PatternPen pen(*ImPlot::GetPlotDrawList(), look, colour, unit);
  for (const HandPoint& point : points) {
    if (const std::optional<double> at = value(point)) pen.line_to(ImPlot::PlotToPixels(point.time_s, *at));
  }
  ImPlot::PopPlotClipRect();
}

void draw_known(const PanelContext& context, const std::vector<HandPoint>& points, float unit) {
  for (const KnownRun& run : known_runs(points)) {
    const int count = static_cast<int>(run.time_s.size());
    ImPlotSpec band;
    band.FillColor = unpacked(context.theme.accent);
    band.FillAlpha = static_cast<float>(band_tint);
    ImPlot::PlotShaded("live", run.time_s.data(), run.least.data(), run.greatest.data(), count, band);
    ImPlotSpec line;
    line.LineColor = unpacked(context.theme.accent);
    line.LineWeight = 0.8F * unit;
    ImPlot::PlotLine("live", run.time_s.data(), run.least.data(), count, line);
    ImPlot::PlotLine("live", run.time_s.data(), run.greatest.data(), count, line);
    line.LineWeight = live_look.width * unit;
    ImPlot::PlotLine("live", run.time_s.data(), run.middle.data(), count, line);
  }
}

// The words for the longest time in sight in which nobody knew the hand, where that has room for them.
void draw_unknown(const std::vector<HandPoint>& points, const PlotView& view, double middle_k_u) {
  double known_until_s = view.from_s;
  double longest_s = 0.0;
  double middle_s = 0.0;
  HandUnknown why = HandUnknown::none;
  HandUnknown last_why = HandUnknown::no_tones;
  const auto see_gap = [&](double until_s) {
    const double end_s = std::min(until_s, view.to_s);
    if (end_s - known_until_s <= longest_s) return;
    longest_s = end_s - known_until_s;
    middle_s = 0.5 * (known_until_s + end_s);
    why = last_why;
  };
  for (const HandPoint& point : points) {
    if (!point.estimate.is_known()) {
      last_why = point.estimate.why;
      continue;
    }
    see_gap(point.time_s);
    known_until_s = std::max(known_until_s, point.time_s);
  }
  see_gap(view.to_s);
  const bool was_asked = why != HandUnknown::no_tones && why != HandUnknown::collecting;
  const char* const words = was_asked ? unknown : "— not measured";
  const double per_point = view.span_s() / static_cast<double>(ImPlot::GetPlotSize().x);
  const double width = static_cast<double>(ImGui::CalcTextSize(words).x + 2.0F * ImGui::GetFontSize());
  if (longest_s < std::max(longest_step_s, per_point * width)) return;
  ImPlot::PlotText(words, middle_s, middle_k_u);
}

// A piece of the line, its name, and its value under the cursor.
void draw_legend_entry(const PanelContext& context, const StiffnessLook& look, Colour colour, const std::string& words,
                       Term term) {
  const float unit = context.scale * static_cast<float>(context.theme.thickness);
  const float sample = 2.4F * ImGui::GetFontSize();
  same_line_if_room(sample + ImGui::CalcTextSize(words.c_str()).x + 2.0F * ImGui::GetStyle().ItemSpacing.x);
  ImGui::BeginGroup();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float middle = corner.y + 0.5F * ImGui::GetTextLineHeight();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  if (look.pattern == solid_line) {
    const float half = 0.3F * ImGui::GetFontSize();
    draw_list.AddRectFilled({corner.x, middle - half}, {corner.x + sample, middle + half},
                            packed(mix(context.theme.panel, colour, band_tint)));
    draw_list.AddLine({corner.x, middle}, {corner.x + sample, middle}, packed(colour), look.width * unit);
  } else {
    PatternPen pen(draw_list, look, colour, unit);
    pen.line_to({corner.x, middle});
    pen.line_to({corner.x + sample, middle});
  }
  ImGui::Dummy({sample, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
  ImGui::TextUnformatted(words.c_str());
  ImGui::EndGroup();
  tooltip(term);
}

std::string stiffness_words(const char* name, const std::optional<double>& k_u) {
  return fmt::format("{} {:>4} N/m", name, k_u ? decimal_text(*k_u, 0) : "—");
}

void draw_legend(const PanelContext& context, const HandPoint* point) {
  const HandEstimate hand = point != nullptr ? point->estimate : HandEstimate{};
  ImGui::TextUnformatted("Stiffness of the hand [N/m]");
  tooltip(Term::user_stiffness);
  draw_legend_entry(context, live_look, context.theme.accent,
                    hand.is_known()
                        ? fmt::format("live {:>4} ± {} N/m", decimal_text(hand.k_u, 0), deviation_text(hand.sigma))
                        : stiffness_words("live", {}),
                    Term::live_user_stiffness);
  draw_legend_entry(context, believed_look, believed_colour(context.theme),
                    stiffness_words("believed", point != nullptr ? std::optional(point->believed_k_u) : std::nullopt),
                    Term::believed_user_stiffness);
  draw_legend_entry(context, given_look, context.theme.text,
                    stiffness_words("given", point != nullptr ? point->given_k_u : std::nullopt),
                    Term::given_user_stiffness);
}

}  // namespace

void draw_hand_plot(const PanelContext& context, const History& history) {
  PlotView& view = context.memory.plots;
  bring_times_into_sight(context, history.plots());
  const PlotView before = view;
  const std::vector<HandPoint> points = history.hand().between(view.from_s, view.to_s);
  const std::optional<double> read_at = view.cursor_s ? view.cursor_s : context.session.stage.looks_back_to_s;
  draw_legend(context, history.hand().at(read_at.value_or(view.to_s)));

  std::optional<double> cursor;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float axis = ImGui::GetTextLineHeight() + 4.0F * context.scale;
  if (ImPlot::BeginPlot("##hand", room, quiet_plot)) {
    const float unit = context.scale * static_cast<float>(context.theme.thickness);
    set_up_time_axis(view, true, room.x);
    const PlotRange range = stiffness_range(points);
    set_up_value_axis(range.least, range.greatest, room.y - axis);
    draw_known(context, points, unit);
    draw_pattern_curve(points, given_look, context.theme.text, unit, [](const HandPoint& at) { return at.given_k_u; });
    draw_pattern_curve(points, believed_look, believed_colour(context.theme), unit,
                       [](const HandPoint& at) { return std::optional(at.believed_k_u); });
    draw_unknown(points, view, 0.12 * range.greatest);
    cursor = draw_time_cursor(context);
    ImPlot::EndPlot();
  }
  keep_times(view, before, cursor);
}

}  // namespace ghostforce
