#include "app/cli/desktop_inputs.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/device/servo/servo_scenes.h"

namespace ghostforce::desktop_inputs_test {
namespace {

TEST(DesktopInputs, EveryKindSaysWhatItIs) {
  const std::vector<InputEntry> inputs = desktop_inputs();
  std::set<std::string_view> names;
  for (const InputEntry& kind : inputs) {
    EXPECT_FALSE(kind.title.empty());
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.sentence;
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " is there twice";
    EXPECT_EQ(find_input(inputs, kind.name), &kind);
  }
  EXPECT_EQ(find_input(inputs, "keyboard"), nullptr);
}

TEST(DesktopInputs, EveryKindMakesAnInputThatStartsAtTheGoalOfTheRun) {
  const Scene scene = slanted_wall();
  const Vector<2> start = goal_at(scene.goal, 0.0);
  const std::vector<InputEntry> inputs = desktop_inputs();
  for (const InputEntry& kind : inputs) {
    const LinkedInput made = kind.make(scene, {});
    ASSERT_NE(made.input, nullptr) << kind.name;
    ASSERT_NE(made.link, nullptr) << kind.name;
    made.input->restart(start);
    EXPECT_EQ(made.input->goal(0, scene.settings.rate), start) << kind.name;
  }
}

// As --help and the panel Input list them, and as pictures name the hand that they are made with.
TEST(DesktopInputs, StandInTheirOrder) {
  std::vector<std::string_view> names;
  for (const InputEntry& kind : desktop_inputs()) names.push_back(kind.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"mouse", "script", "replay", "circle", "spacemouse", "falcon",
                                                  "haply", "virtual-falcon", "virtual-haply"}));
  EXPECT_TRUE(find_input(desktop_inputs(), scripted_hand.name));
  EXPECT_EQ(choices_of(desktop_inputs(), true).size(), names.size());
  for (const InputChoice& choice : choices_of(desktop_inputs(), false)) EXPECT_NE(choice.name, "replay");
}

}  // namespace
}  // namespace ghostforce::desktop_inputs_test
