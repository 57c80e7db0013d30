#include "app/picture/chart.h"

namespace ghostforce {
namespace {

constexpr Colour none{0, 0, 0, 0};

class Painter {
 public:
  Painter(const Chart& chart, const ChartLayout& layout, const Theme& theme, double unit, Pane& pane)
      : chart_(chart), layout_(layout), theme_(theme), unit_(unit), pane_(pane) {}

  // What lies behind comes first.
  void paint() {
    paint_grid();
    for (const ScreenPiece& piece : layout_.references) put(Role::scale, piece, 1.4, theme_.faint_text, dotted_line);
    paint_axes();
    paint_series();
    for (const ChartLayout::Words& line : layout_.title) write(Role::legend, line, theme_.text, normal_text);
    for (const ChartLayout::Words& line : layout_.y_title) write(Role::scale, line, theme_.faint_text);
    for (const ChartLayout::Words& line : layout_.x_title) write(Role::scale, line, theme_.faint_text);
    for (const ChartLayout::Words& words : layout_.reference_words) {
      write(Role::scale, words, theme_.text, small_text, theme_.background);
    }
    paint_legend();
  }

 private:
  double points(double size) const { return size * unit_; }
  Vector<2> in_world(const Vector<2>& screen) const { return to_world(pane_.camera, screen); }

  void put(Role role, ScreenPiece piece, double width, Colour colour, const LinePattern& pattern = solid_line) {
    LinePattern scaled = pattern;
    for (double& length : scaled) length = points(length);
    pane_.marks.push_back({role, std::nullopt,
                           Line{in_world(piece.from), in_world(piece.to), points(width), colour, scaled, piece.start}});
  }

  void write(Role role, const ChartLayout::Words& words, Colour colour, const TextStyle& style = small_text,
             Colour halo = none) {
    pane_.marks.push_back(
        {role, std::nullopt, Label{in_world(words.upper_left), Vector<2>(0.0), words.text, style, colour, halo}});
  }

  void put_shape(Role role, const Vector<2>& at, const Series& series) {
    const bool is_hollow = series.is_hollow;
    pane_.marks.push_back(
        {role, std::nullopt,
         Marker{in_world(at), *series.shape, points(chart_marker_radius), is_hollow ? theme_.background : series.colour,
                is_hollow ? series.colour : theme_.background, points(is_hollow ? 1.6 : 0.8)}});
  }

  void paint_grid() {
    for (const ChartLayout::GridLine& line : layout_.grid) {
      switch (line.kind) {
        case ChartLayout::GridLine::Kind::fine:
          put(Role::grid, line.piece, 1.0, mix(theme_.background, theme_.grid, 0.6));
          break;
        case ChartLayout::GridLine::Kind::named:
          put(Role::grid, line.piece, 1.0, theme_.grid);
          break;
        case ChartLayout::GridLine::Kind::zero:
          put(Role::grid, line.piece, 1.0, mix(theme_.background, theme_.faint_text, 0.45));
          break;
      }
    }
  }

  void paint_axes() {
    const ScreenBox& plot = layout_.plot;
    const Vector<2> origin{plot.least.x, plot.most.y};
    put(Role::scale, {plot.least, origin}, 1.2, theme_.text);
    put(Role::scale, {origin, plot.most}, 1.2, theme_.text);
    for (const auto* ticks : {&layout_.x_ticks, &layout_.y_ticks}) {
      for (const ChartLayout::AxisTick& tick : *ticks) {
        put(Role::scale, tick.line, 1.2, theme_.text);
        write(Role::scale, tick.words, theme_.text);
      }
    }
  }

  // All shapes over all lines.
  void paint_series() {
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      const Series& series = chart_.series[i];
      for (const ScreenPiece& piece : layout_.series[i].line) {
        put(Role::trail, piece, series.width, series.colour, series.pattern);
      }
    }
    for (std::size_t i = 0; i < chart_.series.size(); ++i) {
      for (const Vector<2>& at : layout_.series[i].shapes) put_shape(Role::device, at, chart_.series[i]);
    }
  }

  void paint_legend() {
    for (const ChartLayout::LegendEntry& entry : layout_.legend) {
      const Series& series = chart_.series[entry.series];
      const ScreenPiece& sample = entry.sample;
      if (series.has_line) put(Role::legend, sample, series.width, series.colour, series.pattern);
      if (series.shape) put_shape(Role::legend, 0.5 * (sample.from + sample.to), series);
      write(Role::legend, entry.name, theme_.text);
    }
  }

  const Chart& chart_;
  const ChartLayout& layout_;
  const Theme& theme_;
  const double unit_;  // of the sizes here [points]
  Pane& pane_;
};

}  // namespace

Pane chart_pane(const Chart& chart, const Vector<2>& corner, const Vector<2>& size, const Theme& theme, double scale,
                const MeasureText& measure) {
  Pane pane{corner, Camera{0.5 * size, 1.0, size}, StrategyId::full, {}};
  const double unit = scale * theme.thickness;
  const std::optional<ChartLayout> layout = lay_out(chart, size, unit, measure);
  if (layout) Painter(chart, *layout, theme, unit, pane).paint();
  return pane;
}

}  // namespace ghostforce
