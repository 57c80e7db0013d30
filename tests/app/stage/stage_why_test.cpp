// Why?: each step has its words at every angle of the motor, and they stay where they are while others come.
#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "app/stage/stage.h"
#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_why_test {
namespace {

class StageWhy : public StageInEachLanguage {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageWhy, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

// Where the motor pushes nearly straight at the wall, the missing part is too short for its words to stand beside it.
TEST_P(StageWhy, SaysAllStepsOfWhyInTheUsualPictures) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 720.0), Vector<2>(1920.0, 1080.0)}) {
    for (int degrees = 0; degrees < 180; degrees += 5) {
      for (const StrategyId id : {StrategyId::naive, StrategyId::anisotropic}) {
        Settings settings = wall45(id);
        settings.actuated_angle = degrees / degrees_per_radian;
        StageCase shown = case_at(settings, wall45_goal);
        shown.size = size;
        shown.mode = StageMode::why;
        shown.why_step = 4;
        const Drawn drawn(shown.compose());
        for (const char* const number : {"1  ", "2  ", "3  ", "4  "}) {
          EXPECT_TRUE(std::ranges::any_of(drawn.extents.labels,
                                          [&](const LabelExtent& label) { return label.words.starts_with(number); }))
              << number << degrees << "° " << words_for(shown);
        }
      }
    }
  }
}

TEST_P(StageWhy, ShowsEachStepOfWhyWhereItStaysWithTheNext) {
  for (int degrees = 0; degrees < 180; degrees += 10) {
    Settings settings = wall45(degrees % 20 == 0 ? StrategyId::naive : StrategyId::anisotropic);
    settings.actuated_angle = degrees / degrees_per_radian;
    StageCase shown = case_at(settings, wall45_goal);
    shown.mode = StageMode::why;
    std::map<std::string, Vector<2>> before;
    for (shown.why_step = 1; shown.why_step <= 4; ++shown.why_step) {
      std::map<std::string, Vector<2>> now;
      const Drawn drawn(shown.compose());
      for (const LabelExtent& label : drawn.extents.labels) {
        if (label.words.size() > 2 && label.words.substr(1, 2) == "  ") now[label.words] = label.box.least;
      }
      EXPECT_EQ(now.size(), static_cast<std::size_t>(shown.why_step)) << words_for(shown);
      for (const auto& [words, place] : before) {
        ASSERT_TRUE(now.contains(words)) << words << ' ' << words_for(shown);
        EXPECT_EQ(now.at(words), place) << words << ' ' << words_for(shown);
      }
      before = std::move(now);
    }
  }
}

}  // namespace
}  // namespace ghostforce::stage_why_test
