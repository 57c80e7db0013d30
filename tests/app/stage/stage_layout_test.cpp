// Where words stand on the stage and how large letters are, whatever is said there.
#include "app/stage/stage_layout.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "tests/app/stage/stage_faults.h"

namespace ghostforce::stage_layout_test {
namespace {

class StageLayoutTest : public testing::TestWithParam<const StageLanguage*> {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, StageLayoutTest, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

TEST_P(StageLayoutTest, TheNumbersStandInOnePlaceWhateverIsSaid) {
  const StageFrameWords words{.language = *GetParam(), .keys = {.lessons = "F5", .help = "F1"}, .sentence = {}};
  for (const Vector<2>& size : {Vector<2>(640.0, 700.0), Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0)}) {
    const StageLayout empty = stage_layout(size, 1.0, measure, words);
    for (const std::string_view sentence : words_of(GetParam()->sentences)) {
      StageFrameWords said = words;
      said.sentence = sentence;
      const StageLayout layout = stage_layout(size, 1.0, measure, said);
      EXPECT_EQ(layout.words_end, empty.words_end) << sentence;
      EXPECT_EQ(layout.unit, empty.unit) << sentence;
    }
  }
}

// However many bytes the others have.
TEST_P(StageLayoutTest, TheWidestSentenceDecidesHowLargeLettersAre) {
  StageLanguage language = *GetParam();
  const StageFrameWords words{.language = language, .keys = {.lessons = "F5", .help = "F1"}, .sentence = {}};
  const auto unit = [&] { return stage_layout({700.0, 700.0}, 1.0, measure, words).unit; };
  const double usual = unit();
  const std::string wide = "W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W W";
  language.sentences.push = wide;
  const double with_wide = unit();
  EXPECT_LT(with_wide, usual);
  std::string many_bytes;
  for (int i = 0; i < 45; ++i) many_bytes += "í ";
  ASSERT_GT(many_bytes.size(), wide.size());
  language.sentences.two_motors = many_bytes;
  EXPECT_EQ(unit(), with_wide);
}

TEST(ScaleOverStage, GrowsWithTheWindowAsFarAsDialogsFit) {
  EXPECT_DOUBLE_EQ(scale_over_stage({1280.0, 720.0}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({3840.0, 2160.0}, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({1920.0, 1440.0}, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({640.0, 2000.0}, 1.0), 1.0) << "too narrow for larger ones";
  EXPECT_DOUBLE_EQ(scale_over_stage({800.0, 600.0}, 1.0), 1.0) << "never below what the person has chosen";
  EXPECT_DOUBLE_EQ(scale_over_stage({800.0, 600.0}, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(scale_over_stage({1280.0, 720.0}, 0.75), 0.75);
}

TEST(ScaleOverStage, NeedsOtherLettersOnlyNowAndThen) {
  std::set<double> scales;
  for (double height = 720.0; height <= 1440.0; height += 1.0) {
    const double scale = scale_over_stage({4000.0, height}, 1.0);
    EXPECT_LE(scale, height / 720.0 + 1e-9);
    EXPECT_GT(scale, height / 720.0 - 0.067);
    scales.insert(scale);
  }
  EXPECT_EQ(scales.size(), 16U);
}

}  // namespace
}  // namespace ghostforce::stage_layout_test
