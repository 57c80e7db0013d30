// A page's worker: nothing happens but when it is looked at.
#include <gtest/gtest.h>

#include "app/base/worker.h"

namespace ghostforce::worker_page_test {
namespace {

TEST(WorkerPage, MakesOneStepALook) {
  int steps = 0;
  Worker worker("steps", 0.0, [&steps] {
    ++steps;
    return true;
  });
  EXPECT_EQ(steps, 0);
  worker.poll();
  worker.poll();
  EXPECT_EQ(steps, 2);
}

}  // namespace
}  // namespace ghostforce::worker_page_test
