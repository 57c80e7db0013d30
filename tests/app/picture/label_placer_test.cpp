// A block of words keeps its place until another one is clearly better.
#include "app/picture/label_placer.h"

#include <optional>
#include <string_view>

#include <gtest/gtest.h>

namespace ghostforce::label_placer_test {
namespace {

constexpr double interval_s = 0.1;

// Words that want to stand at the top, below something that reaches down to some height, for some seconds.
class Picture {
 public:
  double top_of_words(double height_of_obstacle, double duration_s) {
    std::optional<LabelPlacer::PlacedBlock> placed;
    for (double time_s = 0.0; time_s < duration_s; time_s += interval_s) {
      LabelPlacer placer({400.0, 400.0}, 1.0, measure_, memory_, interval_s);
      placer.keep_clear(ScreenBox{{0.0, 0.0}, {400.0, height_of_obstacle}});
      placed = placer.place_block(
          {.id = LabelId{}, .extent = {40.0, 20.0}, .region = {{0.0, 0.0}, {400.0, 400.0}}, .wanted = {0.0, 0.0}});
    }
    EXPECT_TRUE(placed);
    return placed ? placed->box.least.y : 0.0;
  }

 private:
  MeasureText measure_ = [](std::string_view, const TextStyle&) { return Vector<2>(10.0); };
  LabelMemory memory_;
};

TEST(LabelPlacer, ABlockOfWordsMovesForAPlaceThatIsClearlyBetterOnly) {
  Picture picture;
  // The first picture may have less air around its words than those that follow it.
  picture.top_of_words(60.0, interval_s);
  const double top = picture.top_of_words(200.0, 5.0);
  EXPECT_EQ(picture.top_of_words(180.0, 5.0), top) << "20 points are not worth the unrest";
  EXPECT_LT(picture.top_of_words(140.0, 5.0), top - 30.0);
}

}  // namespace
}  // namespace ghostforce::label_placer_test
