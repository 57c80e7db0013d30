// The last minute as marks: in its box, readable, true, and still where nothing moves.
#include "app/stage/ribbon_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace ghostforce::ribbon_layer_test {
namespace {

// Letters of a fixed width: close to DejaVu Sans, and the same everywhere.
const MeasureText measure = [](std::string_view text, const TextStyle& style) {
  return Vector<2>((style.is_bold ? 0.64 : 0.58) * style.height * static_cast<double>(text.size()),
                   1.17 * style.height);
};

struct Drawn {
  Camera camera;
  ScreenBox box;
  Marks marks;

  Vector<2> on_screen(const Vector<2>& world) const { return to_screen(camera, world); }
  ScreenBox extent_of(const Label& label) const {
    const Vector<2> corner = on_screen(label.anchor) + label.offset;
    return {corner, corner + measure(label.text, label.style)};
  }
  std::vector<std::string> words() const {
    std::vector<std::string> all;
    for (const Mark& mark : marks) {
      if (const auto* label = std::get_if<Label>(&mark.form)) all.push_back(label->text);
    }
    return all;
  }
  bool says(std::string_view text) const { return std::ranges::count(words(), text) == 1; }
  std::vector<Line> curve(StrategyId id) const {
    std::vector<Line> lines;
    for (const Mark& mark : marks) {
      if (mark.role != Role::ghost_force || mark.strategy != id) continue;
      Line line = std::get<Line>(mark.form);
      line.from = on_screen(line.from);
      line.to = on_screen(line.to);
      lines.push_back(line);
    }
    return lines;
  }
};

Drawn draw(const MomentHistory& moments, std::optional<double> looks_back_to_s = {}, Vector<2> size = {1280.0, 720.0},
           std::optional<ScreenBox> box = {}, std::string_view theme = "light") {
  Drawn drawn{camera_on({0.01, 0.02}, 0.12, size), box.value_or(ScreenBox{{40.0, 560.0}, {1240.0, 700.0}}), {}};
  const Ribbon ribbon{moments, looks_back_to_s, english_stage, *find_theme(theme), measure, drawn.camera, drawn.box};
  add_ribbon(ribbon, drawn.marks);
  return drawn;
}

// 100 ticks a second; the naïve ghost force is as given, the others have none.
template <typename Force>
MomentHistory history_of(double seconds, Force&& force) {
  MomentHistory moments;
  Settings settings;
  settings.rate = 100.0;
  for (int tick = 0; tick <= static_cast<int>(100.0 * seconds); ++tick) {
    Snapshot snapshot;
    snapshot.tick = tick;
    snapshot.time_s = 0.01 * tick;
    snapshot.goal.x = 1e-4 * (tick % 100);  // something moves all the time
    snapshot.strategies[index_of(StrategyId::naive)].ghost_force = {force(snapshot.time_s), 0.0};
    moments.add(snapshot, settings);
  }
  return moments;
}

// Equal words for equal marks.
std::string in_words(const Drawn& drawn) {
  std::string all;
  const auto add = [&](const Vector<2>& at) { all += fmt::format(" {},{}", at.x, at.y); };
  for (const Mark& mark : drawn.marks) {
    all += fmt::format("\n{} {}", role_name(mark.role), mark.form.index());
    if (const auto* line = std::get_if<Line>(&mark.form)) {
      add(line->from);
      add(line->to);
      all += fmt::format(" {}", line->pattern_start);
    } else if (const auto* marker = std::get_if<Marker>(&mark.form)) {
      add(marker->center);
    } else if (const auto* label = std::get_if<Label>(&mark.form)) {
      add(label->anchor);
      all += label->text;
    } else if (const auto* ground = std::get_if<Box>(&mark.form)) {
      add(ground->corner);
    }
  }
  return all;
}

TEST(Ribbon, PointerAndTimeLeadBackAndForth) {
  const MomentHistory moments = history_of(100.0, [](double) { return 1.0; });
  const Theme& theme = *find_theme("light");
  const Camera camera = camera_on({0.0, 0.0}, 0.1, {1280.0, 720.0});
  const RibbonAxis axis =
      ribbon_axis({moments, {}, english_stage, theme, measure, camera, {{40.0, 600.0}, {1240.0, 700.0}}});
  EXPECT_EQ(axis.end_s, 100.0);
  EXPECT_EQ(axis.x_at(100.0), axis.right);
  EXPECT_EQ(axis.x_at(40.0), axis.left);
  EXPECT_NEAR(axis.x_at(70.0), 0.5 * (axis.left + axis.right), 1e-9);
  for (double time_s = 40.5; time_s < 100.0; time_s += 1.7) {
    ASSERT_TRUE(axis.time_at(axis.x_at(time_s)).has_value());
    EXPECT_NEAR(*axis.time_at(axis.x_at(time_s)), time_s, 1e-9);
  }
  EXPECT_FALSE(axis.time_at(axis.right)) << "now";
  EXPECT_FALSE(axis.time_at(5000.0));
  EXPECT_EQ(axis.time_at(-300.0), 40.0);
  EXPECT_EQ(axis.x_at(-1e9), axis.left);
  EXPECT_EQ(axis.x_at(1e9), axis.right);
}

TEST(Ribbon, APointerFindsNothingFromBeforeTheMotionBegan) {
  const MomentHistory moments = history_of(20.0, [](double) { return 1.0; });
  const Theme& theme = *find_theme("light");
  const Camera camera = camera_on({0.0, 0.0}, 0.1, {1280.0, 720.0});
  const RibbonAxis axis =
      ribbon_axis({moments, {}, english_stage, theme, measure, camera, {{40.0, 600.0}, {1240.0, 700.0}}});
  const double oldest_s = moments.oldest()->snapshot.time_s;
  EXPECT_GT(axis.x_at(oldest_s), axis.left + 100.0);
  EXPECT_EQ(axis.time_at(axis.left), oldest_s);
  EXPECT_EQ(axis.time_at(axis.x_at(oldest_s) - 50.0), oldest_s);
}

TEST(Ribbon, SaysWhenAndHowMuch) {
  const MomentHistory moments = history_of(100.0, [](double time_s) { return time_s < 70.0 ? 0.0 : 1.2; });
  const Drawn now = draw(moments);
  for (const char* const words : {"now", "60 s ago", "30 s ago", "10 s ago", "ghost force, 0 to 2 N"}) {
    EXPECT_TRUE(now.says(words)) << words;
  }
  const Drawn back = draw(moments, 87.6);
  EXPECT_TRUE(back.says("12.4 s ago"));
  EXPECT_FALSE(back.says("10 s ago")) << "no room beside what matters more";
  EXPECT_TRUE(back.says("now"));
  EXPECT_TRUE(draw(moments, 99.988).says("12 ms ago")) << "a tick must show";
  EXPECT_TRUE(draw(moments, -5.0).says("60.0 s ago"));
  EXPECT_TRUE(draw(moments, 100.0).says("now"));
}

TEST(Ribbon, ItsCurvesAreTheGhostForces) {
  const MomentHistory moments = history_of(100.0, [](double time_s) { return time_s < 70.0 ? 0.0 : 1.2; });
  const Drawn drawn = draw(moments);
  const std::vector<Line> naive = drawn.curve(StrategyId::naive);
  const std::vector<Line> anisotropic = drawn.curve(StrategyId::anisotropic);
  ASSERT_FALSE(naive.empty());
  ASSERT_FALSE(anisotropic.empty());
  const double zero = anisotropic.front().from.y;
  double highest = zero;
  for (const Line& line : naive) {
    highest = std::min({highest, line.from.y, line.to.y});
    // All of the height is in the middle, where the step was.
    if (line.from.y != line.to.y) {
      EXPECT_NEAR(0.5 * (line.from.x + line.to.x), 640.0, 4.0);
    }
  }
  for (const Line& line : anisotropic) {
    EXPECT_EQ(std::max(line.from.y, line.to.y), zero);
  }
  // 1.2 N of 2 N.
  const double top = zero - (zero - highest) * 2.0 / 1.2;
  EXPECT_GT(top, drawn.box.least.y);
  EXPECT_LT(top, drawn.box.least.y + 60.0) << "below the line of words";
  EXPECT_EQ(naive.front().pattern, strategy_style(StrategyId::naive).pattern);
  EXPECT_EQ(naive.front().colour, find_theme("light")->strategy[index_of(StrategyId::naive)]);
}

TEST(Ribbon, LeavesAGapWhereNobodyKnows) {
  MomentHistory moments;
  for (int tick = 0; tick < 6000; ++tick) {
    Snapshot snapshot;
    snapshot.time_s = 0.01 * tick;
    snapshot.goal.x = 1e-4 * (tick % 100);
    snapshot.measured = StrategyId::naive;
    moments.add(snapshot, {});
  }
  const Drawn drawn = draw(moments);
  EXPECT_TRUE(drawn.says("ghost force: cannot be known"));
  for (const Strategy& each : strategy_catalog()) {
    EXPECT_TRUE(drawn.curve(each.id).empty()) << each.name;
  }
  EXPECT_FALSE(draw(MomentHistory()).marks.empty()) << "nor is anything wrong with no history at all";
}

TEST(Ribbon, StandsStillAtRest) {
  MomentHistory moments = history_of(20.0, [](double time_s) { return 0.05 * time_s; });
  const std::string live = in_words(draw(moments));
  const std::string back = in_words(draw(moments, 12.3));
  Snapshot rest = moments.newest()->snapshot;
  const Settings settings = moments.newest()->settings;
  for (int tick = 0; tick < 20'000; ++tick) {
    rest.time_s += 0.01;
    moments.add(rest, settings);
    if (tick % 1000 != 0) continue;
    ASSERT_EQ(in_words(draw(moments)), live);
    ASSERT_EQ(in_words(draw(moments, 12.3)), back);
  }
  rest.goal.x += 0.001;
  rest.time_s += 0.01;
  moments.add(rest, settings);
  EXPECT_NE(in_words(draw(moments)), live);
}

// Dashes go along with the times that they lie at.
TEST(Ribbon, ItsDashesDoNotCrawl) {
  MomentHistory moments = history_of(80.0, [](double time_s) { return time_s < 50.0 ? 0.2 : 0.4; });
  const auto phase_at_step = [](const Drawn& drawn) {
    const LinePattern pattern = strategy_style(StrategyId::naive).pattern;
    const double period = pattern[0] + pattern[1] + pattern[2] + pattern[3];
    const std::vector<Line> curve = drawn.curve(StrategyId::naive);
    const auto step = std::ranges::find_if(curve, [](const Line& line) { return line.from.y - line.to.y > 5.0; });
    return std::remainder(step->pattern_start * drawn.camera.points_per_metre, period);
  };
  const double before = phase_at_step(draw(moments));
  Snapshot later = moments.newest()->snapshot;
  for (int tick = 1; tick <= 777; ++tick) {
    later.time_s += 0.01;
    later.goal.x = 1e-4 * (tick % 100);
    moments.add(later, {});
  }
  EXPECT_NEAR(phase_at_step(draw(moments)), before, 1.5) << "buckets begin anew: to a bucket's width";
}

TEST(Ribbon, NoWordsOverlapOrAreCutOffInAnySize) {
  std::mt19937 random(20261122);
  const auto any = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  const MomentHistory moments = history_of(90.0, [](double time_s) { return 20.0 * std::abs(std::sin(time_s)); });
  int most_words = 0;
  for (int round = 0; round < 400; ++round) {
    const Vector<2> size{any(200.0, 4000.0), any(150.0, 2400.0)};
    const Vector<2> corner{any(0.0, 0.4) * size.x, any(0.0, 0.6) * size.y};
    const ScreenBox box{corner, corner + Vector<2>{any(0.05, 0.6) * size.x, any(0.05, 0.4) * size.y}};
    const std::optional<double> back = round % 3 == 0 ? std::nullopt : std::optional(any(20.0, 95.0));
    const Drawn drawn = draw(moments, back, size, box, theme_catalog()[static_cast<std::size_t>(round % 3)].name);
    const ScreenBox inside = box.grown(1e-6);
    std::vector<ScreenBox> words;
    for (const Mark& mark : drawn.marks) {
      if (const auto* label = std::get_if<Label>(&mark.form)) {
        const ScreenBox extent = drawn.extent_of(*label);
        EXPECT_TRUE(contains(inside, extent.least) && contains(inside, extent.most)) << round << ' ' << label->text;
        for (const ScreenBox& other : words) {
          EXPECT_EQ(overlap(other, extent), 0.0) << round << ' ' << label->text;
        }
        words.push_back(extent);
        // 1.164 is the height of a line of DejaVu Sans over its em.
        EXPECT_GE(label->style.height / 1.164, std::min(size.y / 30.0, size.x / 24.0) - 1e-9);
      } else if (const auto* line = std::get_if<Line>(&mark.form)) {
        EXPECT_TRUE(contains(inside, drawn.on_screen(line->from))) << round;
        EXPECT_TRUE(contains(inside, drawn.on_screen(line->to))) << round;
      }
    }
    // Words stand beside the curves.
    for (const Strategy& each : strategy_catalog()) {
      for (const Line& line : drawn.curve(each.id)) {
        for (const ScreenBox& extent : words) {
          EXPECT_FALSE(contains(extent.grown(-1.0), line.from)) << round;
        }
      }
    }
    most_words = std::max(most_words, static_cast<int>(words.size()));
  }
  EXPECT_GE(most_words, 8) << "all of them, where there is room";
}

TEST(Ribbon, TheHeightItAsksForHasRoomForAll) {
  const MomentHistory moments = history_of(90.0, [](double) { return 1.0; });
  const Camera camera = camera_on({0.0, 0.0}, 0.1, {1024.0, 640.0});
  const Ribbon ribbon{moments, {}, english_stage, *find_theme("light"), measure, camera, {}};
  const double height = ribbon_height(ribbon);
  EXPECT_LT(height, 0.25 * 640.0);
  const Drawn drawn = draw(moments, {}, {1024.0, 640.0}, ScreenBox{{20.0, 630.0 - height}, {1004.0, 630.0}});
  EXPECT_TRUE(drawn.says("ghost force, 0 to 1 N"));
  EXPECT_TRUE(drawn.says("now"));
  EXPECT_TRUE(drawn.says("60 s ago"));
}

// A reset, round and round and another scene leave nothing of what was before.
TEST(Ribbon, SaysWhereTheMotionBegan) {
  const StageLanguage::Ribbon& words = english_stage.ribbon;
  const auto force = [](double) { return 1.0; };
  EXPECT_TRUE(draw(history_of(5.0, force)).says(words.begins));
  EXPECT_TRUE(draw(history_of(45.0, force)).says(words.begins_shortly)) << "where there is less room";
  for (const double seconds : {59.9, 61.0, 100.0}) {
    const Drawn drawn = draw(history_of(seconds, force));
    EXPECT_FALSE(drawn.says(words.begins) || drawn.says(words.begins_shortly)) << seconds;
  }
}

}  // namespace
}  // namespace ghostforce::ribbon_layer_test
