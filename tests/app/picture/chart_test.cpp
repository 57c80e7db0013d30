// Charts: whatever is on them, at any size, words stand apart and inside, curves stay in the plot, and the legend
// covers none of them.
#include "app/picture/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/paint/vector/vector_file_painter.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/ticks.h"

namespace ghostforce::chart_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const MeasureText measure = measure_vector_text;
const Theme& light = *find_theme("light");

// ---- Ticks ----------------------------------------------------------------------------------------------------------

std::string words_of(const Ticks& ticks) {
  std::string all;
  for (const Tick& tick : ticks.named) all += (all.empty() ? "" : " ") + tick.words;
  return all;
}

struct Wanted {
  double least, greatest;
  bool is_logarithmic, rounds_out;
  double length;  // a word takes 30
  std::string words;
};

TEST(Ticks, AreRoundNumbersAsManyAsHaveRoom) {
  const std::function<double(std::string_view)> extent = [](std::string_view) { return 30.0; };
  for (const Wanted& wanted : std::vector<Wanted>{
           {0.0, 1.0, false, true, 200.0, "0.0 0.2 0.4 0.6 0.8 1.0"},
           {0.0, 1.0, false, true, 100.0, "0.0 0.5 1.0"},
           {0.0, 1.0, false, true, 500.0, "0.0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1.0"},
           {-0.3, 0.3, false, true, 300.0, "−0.3 −0.2 −0.1 0.0 0.1 0.2 0.3"},
           {7.0, 93.0, false, true, 250.0, "0 20 40 60 80 100"},
           {7.0, 93.0, false, false, 250.0, "20 40 60 80"},
           {1.0, 100.0, true, true, 300.0, "1 2 5 10 20 50 100"},
           {1.0, 100.0, true, true, 100.0, "1 10 100"},
           {0.03, 12.0, true, true, 500.0, "0.02 0.05 0.1 0.2 0.5 1 2 5 10 20"},
           {1e-8, 1e8, true, true, 200.0, "10⁻¹⁰ 10⁻⁵ 1 10⁵ 10¹⁰"},
           {0.0, 2e6, false, true, 200.0, "0 5·10⁵ 10⁶ 1.5·10⁶ 2·10⁶"},
           {1.0, 1.3, true, false, 150.0, "1.0 1.1 1.2 1.3"},
           {5.0, 5.0, false, true, 120.0, "2 4 6 8"},
           {0.0, 1.0, false, true, 5.0, ""},
       }) {
    const Ticks ticks = choose_ticks(
        {wanted.least, wanted.greatest, wanted.is_logarithmic, wanted.rounds_out, wanted.length, 5.0, extent});
    EXPECT_EQ(words_of(ticks), wanted.words);
    EXPECT_LT(ticks.least, ticks.greatest);
    EXPECT_LE(ticks.least, wanted.least);
    EXPECT_GE(ticks.greatest, wanted.greatest);
  }
}

TEST(Ticks, LieWhereTheyShould) {
  EXPECT_EQ(place_on_axis(5.0, 0.0, 10.0, false), 0.5);
  EXPECT_NEAR(place_on_axis(10.0, 1.0, 100.0, true), 0.5, 1e-15);
  EXPECT_TRUE(std::isnan(place_on_axis(0.0, 1.0, 100.0, true)));
  EXPECT_TRUE(std::isnan(place_on_axis(-1.0, 1.0, 100.0, true)));
}

// ---- The picture ----------------------------------------------------------------------------------------------------

struct Box {
  Vector<2> least, most;
};

bool apart(const Box& a, const Box& b) {
  constexpr double touch = 1e-6;
  return a.most.x <= b.least.x + touch || b.most.x <= a.least.x + touch || a.most.y <= b.least.y + touch ||
         b.most.y <= a.least.y + touch;
}

struct Words {
  std::string text;
  Box box;
  Role role;
};

std::vector<Words> words_in(const Pane& pane, double scale) {
  std::vector<Words> all;
  for (const Mark& mark : pane.marks) {
    const auto* label = std::get_if<Label>(&mark.form);
    if (label == nullptr) continue;
    const Vector<2> at = to_screen(pane.camera, label->anchor) + label->offset;
    all.push_back({label->text, {at, at + measure(label->text, {label->style.height * scale})}, mark.role});
  }
  return all;
}

std::vector<Line> lines_in(const Pane& pane, Role role) {
  std::vector<Line> lines;
  for (const Mark& mark : pane.marks) {
    if (mark.role != role) continue;
    if (const auto* line = std::get_if<Line>(&mark.form)) lines.push_back(*line);
  }
  return lines;
}

// Grid lines span the plot.
Box plot_of(const Pane& pane) {
  Box box{Vector<2>(infinity), Vector<2>(-infinity)};
  for (const Line& line : lines_in(pane, Role::grid)) {
    box.least = glm::min(box.least, glm::min(line.from, line.to));
    box.most = glm::max(box.most, glm::max(line.from, line.to));
  }
  return box;
}

Chart sine_chart() {
  Chart chart;
  chart.title = "Force along the motor at rest";
  chart.x = {.title = "wall angle [°]"};
  chart.y = {.title = "force along the motor [N]"};
  for (const Strategy& strategy : strategy_catalog()) {
    Series series{.name = std::string(strategy.title),
                  .colour = light.strategy[index_of(strategy.id)],
                  .points = {},
                  .pattern = strategy_style(strategy.id).pattern,
                  .shape = strategy_style(strategy.id).shape};
    const double size = 1.0 + static_cast<double>(index_of(strategy.id));
    for (int i = 0; i <= 36; ++i) series.points.push_back({5.0 * i, size * std::sin(0.1 * i)});
    chart.series.push_back(series);
  }
  chart.references = {{35.0, true, "optimum"}, {0.5, false, "limit of the motors"}};
  return chart;
}

std::vector<Chart> charts() {
  std::vector<Chart> all;
  all.push_back(sine_chart());
  Chart crowded = sine_chart();
  for (Series& series : crowded.series) {
    const std::vector<Vector<2>> points = series.points;
    for (const double up : {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0}) {
      for (const Vector<2>& point : points) series.points.push_back(point + Vector<2>(0.0, up));
    }
    series.name += " with a name that is rather long";
  }
  all.push_back(crowded);
  Chart logarithmic = sine_chart();
  logarithmic.x.is_logarithmic = logarithmic.y.is_logarithmic = true;
  all.push_back(logarithmic);
  Chart cut = sine_chart();
  cut.x.range = Vector<2>(42.0, 43.0);
  cut.y.range = Vector<2>(-0.1, 0.1);
  all.push_back(cut);
  Chart huge = sine_chart();
  for (Series& series : huge.series) {
    for (Vector<2>& point : series.points) point *= 1e7;
  }
  all.push_back(huge);
  Chart long_words = sine_chart();
  long_words.title = "A title that goes on and on, over the edge of most pictures, and Donaudampfschiff as well";
  long_words.y.title = "an axis whose title is longer than the pane that it stands in is ever going to be wide [N]";
  long_words.x.title = long_words.y.title;
  all.push_back(long_words);
  Chart odd = sine_chart();
  odd.series[0].points = {{0.0, nan}, {infinity, 1.0}, {1.0, 1.0}, {nan, 2.0}};
  odd.series[1].points.clear();
  all.push_back(odd);
  all.push_back(Chart{"Nothing", {"x"}, {"y"}, {}});
  all.push_back(
      Chart{"One point", {"x"}, {"y"}, {Series{"a", rgb(0), {{3.0, 4.0}}, true, solid_line, 2.0, Shape::disc}}});
  return all;
}

const std::vector<Vector<2>> sizes{{300.0, 220.0}, {420.0, 320.0}, {640.0, 400.0}, {1200.0, 300.0}, {260.0, 700.0}};

void for_each_picture(const std::function<void(const Chart&, const Pane&, double scale)>& look) {
  for (const Chart& chart : charts()) {
    for (const Vector<2>& size : sizes) {
      for (const double scale : {0.75, 1.0, 2.0}) {
        SCOPED_TRACE(testing::Message() << chart.title << ", " << size.x << " × " << size.y << ", scale " << scale);
        look(chart, chart_pane(chart, {10.0, 20.0}, size * scale, light, scale, measure), scale);
      }
    }
  }
}

TEST(Chart, HasItsWordsInsideAndApart) {
  for_each_picture([](const Chart&, const Pane& pane, double scale) {
    EXPECT_EQ(pane.corner, Vector<2>(10.0, 20.0));
    const std::vector<Words> words = words_in(pane, scale);
    EXPECT_GE(words.size(), 4U);
    for (std::size_t i = 0; i < words.size(); ++i) {
      EXPECT_GE(words[i].box.least.x, 0.0) << words[i].text;
      EXPECT_GE(words[i].box.least.y, 0.0) << words[i].text;
      EXPECT_LE(words[i].box.most.x, pane.camera.size.x) << words[i].text;
      EXPECT_LE(words[i].box.most.y, pane.camera.size.y) << words[i].text;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_TRUE(apart(words[i].box, words[k].box)) << words[i].text << " on " << words[k].text;
      }
    }
  });
}

TEST(Chart, KeepsCurvesInThePlotAndOutOfTheLegend) {
  for_each_picture([](const Chart&, const Pane& pane, double scale) {
    const Box plot = plot_of(pane);
    std::vector<Box> legend;
    for (const Words& words : words_in(pane, scale)) {
      if (words.role == Role::legend) legend.push_back(words.box);
    }
    for (const Line& line : lines_in(pane, Role::trail)) {
      for (const Vector<2>& end : {line.from, line.to}) {
        EXPECT_GE(end.x, plot.least.x - 1e-3);
        EXPECT_LE(end.x, plot.most.x + 1e-3);
        EXPECT_GE(end.y, plot.least.y - 1e-3);
        EXPECT_LE(end.y, plot.most.y + 1e-3);
      }
      for (int i = 0; i <= 20; ++i) {
        const Vector<2> at = to_screen(pane.camera, line.from + (line.to - line.from) * (i / 20.0));
        for (const Box& box : legend) EXPECT_TRUE(apart({at, at}, box));
      }
    }
  });
}

TEST(Chart, PutsPointsWhereTheAxesSay) {
  Chart chart{"", {"x", false, Vector<2>(0.0, 10.0)}, {"y", true, Vector<2>(1.0, 100.0)}, {}};
  chart.series.push_back({"", rgb(0x102030), {{5.0, 10.0}}, false, solid_line, 2.0, Shape::disc});
  const Pane pane = chart_pane(chart, Vector<2>(0.0), {400.0, 300.0}, light, 1.0, measure);
  const Box plot = plot_of(pane);
  int found = 0;
  for (const Mark& mark : pane.marks) {
    const auto* marker = std::get_if<Marker>(&mark.form);
    if (marker == nullptr) continue;
    ++found;
    EXPECT_NEAR(glm::distance(marker->center, 0.5 * (plot.least + plot.most)), 0.0, 1e-9);
    EXPECT_EQ(marker->fill, rgb(0x102030));
  }
  EXPECT_EQ(found, 1);
}

TEST(Chart, LeavesAGapWhereANumberIsNone) {
  Chart chart{"", {"x"}, {"y"}, {}};
  chart.series.push_back({"", rgb(0), {{0.0, 0.0}, {1.0, 1.0}, {2.0, nan}, {3.0, 1.0}, {4.0, 0.0}}});
  const auto pieces = [&] {
    return lines_in(chart_pane(chart, Vector<2>(0.0), {400.0, 300.0}, light, 1.0, measure), Role::trail).size();
  };
  EXPECT_EQ(pieces(), 2U);
  chart.series[0].points[2].y = 2.0;
  EXPECT_EQ(pieces(), 4U);
  chart.y.is_logarithmic = true;  // has no zero
  EXPECT_EQ(pieces(), 2U);
}

TEST(Chart, NamesEachSeriesWithItsLineAndItsShape) {
  const Chart chart = sine_chart();
  const Pane pane = chart_pane(chart, Vector<2>(0.0), {640.0, 400.0}, light, 1.0, measure);
  const std::vector<Line> samples = lines_in(pane, Role::legend);
  ASSERT_EQ(samples.size(), chart.series.size());
  std::vector<std::string> names;
  for (const Words& words : words_in(pane, 1.0)) names.push_back(words.text);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].colour, chart.series[i].colour);
    EXPECT_EQ(samples[i].pattern, chart.series[i].pattern);
    EXPECT_NE(std::ranges::find(names, chart.series[i].name), names.end());
    EXPECT_TRUE(std::ranges::any_of(pane.marks, [&](const Mark& mark) {
      const auto* marker = std::get_if<Marker>(&mark.form);
      return mark.role == Role::legend && marker != nullptr && marker->shape == chart.series[i].shape;
    }));
  }
}

TEST(Chart, ShowsNothingWhereNothingFits) {
  EXPECT_TRUE(chart_pane(sine_chart(), Vector<2>(0.0), {40.0, 30.0}, light, 1.0, measure).marks.empty());
}

// ---- In pixels ------------------------------------------------------------------------------------------------------

TEST(ImagePainter, PaintsTheSameImageEachTimeAtAnyDensity) {
  const Vector<2> size{300.0, 200.0};
  const std::vector<Pane> panes{chart_pane(sine_chart(), Vector<2>(0.0), size, light, 1.0, measure)};
  const Image once = paint_image(panes, light, size, 1.0, 2.0);
  EXPECT_EQ(once.width, 600);
  EXPECT_EQ(once.height, 400);
  EXPECT_EQ(once.rgb.size(), 3U * 600U * 400U);
  EXPECT_EQ(once, paint_image(panes, light, size, 1.0, 2.0));
  EXPECT_EQ(paint_image(panes, light, size, 1.0, 1.0).width, 300);
}

TEST(ImagePainter, HasTheColoursInTheirPlaces) {
  const Vector<2> size{30.0, 20.0};
  const Camera camera{0.5 * size, 1.0, size};
  const Colour colour = rgb(0x123456);
  // To the right and up.
  const Pane pane{Vector<2>(0.0),
                  camera,
                  StrategyId::full,
                  {{Role::device, std::nullopt, Marker{{22.0, 15.0}, Shape::disc, 4.0, colour, colour, 0.0}}}};
  const Image image = paint_image({pane}, light, size, 1.0, 3.0);
  const auto pixel = [&](std::size_t x, std::size_t y) {
    const std::uint8_t* at = &image.rgb[3 * (y * 90 + x)];
    return Colour{at[0], at[1], at[2]};
  };
  EXPECT_EQ(pixel(66, 15), colour);
  EXPECT_EQ(pixel(66, 45), light.background);
  EXPECT_EQ(pixel(24, 15), light.background);
}

}  // namespace
}  // namespace ghostforce::chart_test
