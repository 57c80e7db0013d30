#include "device/input_catalog.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/device/servo/servo_scenes.h"

namespace ghostforce {
namespace {

TEST(InputCatalog, EveryKindSaysWhatItIs) {
  std::set<std::string_view> names;
  for (const InputKind& kind : input_catalog()) {
    EXPECT_FALSE(kind.title.empty());
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.sentence;
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " is there twice";
    EXPECT_EQ(find_input(kind.name), &kind);
  }
  EXPECT_EQ(find_input("keyboard"), nullptr);
}

TEST(InputCatalog, EveryKindMakesAnInputThatStartsAtTheGoalOfTheRun) {
  const Scene scene = slanted_wall();
  const Vector<2> start = goal_at(scene.goal, 0.0);
  for (const InputKind& kind : input_catalog()) {
    const std::unique_ptr<Input> input = kind.make(scene, {});
    ASSERT_NE(input, nullptr) << kind.name;
    input->restart(start);
    EXPECT_EQ(input->goal(0, scene.settings.rate), start) << kind.name;
  }
}

}  // namespace
}  // namespace ghostforce
