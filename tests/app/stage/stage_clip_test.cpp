// The stage over a past time: each moment as it was, and changes of the strategy as the stage shows them.
#include "app/stage/stage_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/state/stage_view.h"
#include "core/simulate.h"

namespace ghostforce::stage_clip_test {
namespace {

constexpr double frame_s = 1.0 / 30.0;

ClipMoment at_rest(StrategyId active) {
  Scene scene = load_scene("wall45");
  scene.settings.active = active;
  const TickState<2> rest = equilibrium_state(scene.settings, scene.goal.points.back());
  return {scene.settings, snapshot_of(coefficients_of(scene.settings), rest)};
}

StageClip clip() {
  const Scene scene = load_scene("wall45");
  return StageClip({.language = &english_stage,
                    .keys = {.lessons = "F5", .help = "F1"},
                    .theme = &theme_catalog().front(),
                    .measure = measure_vector_text,
                    .shown = stage_view_of(scene.settings, scene.goal.points.back()),
                    .reference_force = 3.0,
                    .size = {1280.0, 720.0}});
}

std::vector<std::string> words_of(const Pane& pane) {
  std::vector<std::string> words;
  for (const Mark& mark : pane.marks) {
    if (const auto* label = std::get_if<Label>(&mark.form)) words.push_back(label->text);
  }
  return words;
}

// The ghost force, as it is written.
std::string number_of(const Pane& pane) {
  const std::vector<std::string> words = words_of(pane);
  const auto unit = std::ranges::find(words, "N");
  return unit == words.begin() || unit == words.end() ? "" : *std::prev(unit);
}

TEST(StageClip, ShowsEachMomentUnderItsOwnStrategy) {
  EXPECT_EQ(number_of(clip().next(at_rest(StrategyId::naive), 0.0)), "1.27");
  EXPECT_EQ(number_of(clip().next(at_rest(StrategyId::anisotropic), 0.0)), "0.00");
}

TEST(StageClip, GlidesFromOneStrategyToTheNext) {
  StageClip both = clip();
  EXPECT_EQ(number_of(both.next(at_rest(StrategyId::naive), 0.0)), "1.27");
  std::vector<double> numbers;
  std::string last = "?";
  for (int i = 0; i < 20; ++i) {
    last = number_of(both.next(at_rest(StrategyId::anisotropic), frame_s));
    ASSERT_FALSE(last.empty()) << "the numbers leave their place at " << i;
    numbers.push_back(std::stod(last));
  }
  EXPECT_EQ(last, "0.00");
  EXPECT_TRUE(std::ranges::is_sorted(numbers, std::ranges::greater()));
  EXPECT_GT(std::ranges::count_if(numbers, [](double number) { return number > 0.1 && number < 1.2; }), 5);
}

TEST(StageClip, IsTheSameTwice) {
  const auto marks = [] {
    StageClip some = clip();
    std::vector<std::string> words;
    for (const StrategyId id : {StrategyId::full, StrategyId::naive, StrategyId::naive}) {
      for (const std::string& word : words_of(some.next(at_rest(id), frame_s))) words.push_back(word);
    }
    return words;
  };
  EXPECT_EQ(marks(), marks());
}

}  // namespace
}  // namespace ghostforce::stage_clip_test
