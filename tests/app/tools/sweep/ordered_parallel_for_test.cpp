// Pieces made on many threads come out in order, each once, whatever happens to the threads or to the taker.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/tools/sweep/ordered_parallel_for.h"

namespace ghostforce::ordered_parallel_for_test {
namespace {

std::vector<std::int64_t> taken_with(std::size_t threads, std::int64_t count) {
  std::vector<std::int64_t> taken;
  OrderedParallelFor<std::int64_t>::run(
      count, threads, [](std::int64_t i) { return i * i; },
      [&](std::int64_t&& piece) {
        taken.push_back(piece);
        return true;
      });
  return taken;
}

TEST(OrderedParallelFor, HandsOverEachPieceOnceAndInOrder) {
  for (const std::int64_t count : {0, 1, 3, 1000}) {
    std::vector<std::int64_t> expected;
    for (std::int64_t i = 0; i < count; ++i) expected.push_back(i * i);
    for (const std::size_t threads : {1U, 2U, 7U}) EXPECT_EQ(taken_with(threads, count), expected) << threads;
  }
}

TEST(OrderedParallelFor, RunsNeverFarAheadOfTheTaker) {
  std::atomic<std::int64_t> made = 0;
  std::int64_t taken = 0;
  std::int64_t farthest = 0;
  OrderedParallelFor<std::int64_t>::run(
      200, 2,
      [&](std::int64_t i) {
        ++made;
        return i;
      },
      [&](std::int64_t&&) {
        if (taken == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));  // time to run ahead
        farthest = std::max(farthest, made - taken);
        ++taken;
        return true;
      });
  EXPECT_EQ(taken, 200);
  EXPECT_LE(farthest, 8 + 2);  // four pieces a thread that wait, and one a thread that may have begun meanwhile
}

// Without one a thread that has used up its own stack ends the process before any handler runs.
TEST(OrderedParallelFor, StopsWhenTheTakerHasEnough) {
  std::int64_t taken = 0;
  OrderedParallelFor<std::int64_t>::run(
      1'000'000, 3, [](std::int64_t i) { return i; },
      [&](std::int64_t&& piece) {
        EXPECT_EQ(piece, taken);
        return ++taken < 10;
      });
  EXPECT_EQ(taken, 10);
}

TEST(OrderedParallelFor, WhatIsThrownOnAThreadComesOut) {
  std::int64_t taken = 0;
  const auto run = [&] {
    OrderedParallelFor<std::int64_t>::run(
        1000, 3,
        [](std::int64_t i) {
          if (i == 100) throw std::runtime_error("piece 100");
          return i;
        },
        [&](std::int64_t&& piece) {
          EXPECT_EQ(piece, taken++);
          return true;
        });
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_LE(taken, 100);
}

TEST(OrderedParallelFor, WhatTheTakerThrowsComesOut) {
  const auto run = [&] {
    OrderedParallelFor<std::int64_t>::run(
        1000, 3, [](std::int64_t i) { return i; }, [](std::int64_t&&) -> bool { throw std::runtime_error("no room"); });
  };
  EXPECT_THROW(run(), std::runtime_error);
}

}  // namespace
}  // namespace ghostforce::ordered_parallel_for_test
