#include "core/goal_path.h"

#include <gtest/gtest.h>

namespace ghostforce::stiffness_path_test {
namespace {

const StiffnessPath path{{100.0, 400.0, 250.0}, {0.0, 5.0, 6.0}};
const StiffnessPath one_node{{70.0}, {0.0}};

TEST(StiffnessPathTest, IsLinearBetweenItsNodesAndHeldOutside) {
  EXPECT_EQ(stiffness_at(path, -1.0), 100.0);
  EXPECT_EQ(stiffness_at(path, 0.0), 100.0);
  EXPECT_EQ(stiffness_at(path, 2.5), 250.0);
  EXPECT_EQ(stiffness_at(path, 5.0), 400.0);
  EXPECT_EQ(stiffness_at(path, 5.5), 325.0);
  EXPECT_EQ(stiffness_at(path, 100.0), 250.0);
  EXPECT_EQ(stiffness_at(one_node, 3.0), 70.0);
}

TEST(StiffnessPathTest, GoesOnUnderAClockThatStartsLater) {
  EXPECT_EQ(path_since(path, 0.0), path);
  EXPECT_EQ(path_since(path, 2.5), (StiffnessPath{{250.0, 400.0, 250.0}, {0.0, 2.5, 3.5}}));
  EXPECT_EQ(path_since(path, 5.0), (StiffnessPath{{400.0, 250.0}, {0.0, 1.0}}));
  EXPECT_EQ(path_since(path, 60.0), (StiffnessPath{{250.0}, {0.0}}));
  EXPECT_TRUE(path_since({}, 1.0).is_empty());
}

}  // namespace
}  // namespace ghostforce::stiffness_path_test
