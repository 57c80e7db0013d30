#include "core/ring.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace ghostforce::ring_test {
namespace {

// Larger than a cache line, every word the same: a torn value shows as two words that differ.
struct Whole {
  std::array<std::uint64_t, 24> words;
};

template <typename Ring>
bool put(Ring& ring, std::uint64_t number) {
  Whole* const slot = ring.slot();
  if (slot == nullptr) return false;
  slot->words.fill(number);
  ring.push();
  return true;
}

TEST(RingTest, GivesNothingWhileItIsEmpty) {
  Ring<Whole, 4> ring;
  Whole value{};
  EXPECT_FALSE(ring.try_pop(value));
  ASSERT_TRUE(put(ring, 1));
  EXPECT_TRUE(ring.try_pop(value));
  EXPECT_FALSE(ring.try_pop(value));
}

TEST(RingTest, ASlotThatIsNotPutIsNobodys) {
  Ring<Whole, 4> ring;
  Whole value{};
  ring.slot()->words.fill(1);
  EXPECT_FALSE(ring.try_pop(value));
  ASSERT_TRUE(put(ring, 2));
  ASSERT_TRUE(ring.try_pop(value));
  EXPECT_EQ(value.words[0], 2U);
}

TEST(RingTest, HoldsAsManyAsItSaysAndNoMore) {
  Ring<Whole, 4> ring;
  Whole value{};
  std::uint64_t next = 0;
  std::uint64_t oldest = 0;
  for (int round = 0; round < 10; ++round) {
    while (put(ring, next)) ++next;
    EXPECT_EQ(next - oldest, 4U);
    for (int i = 0; i <= round % 4; ++i) {
      ASSERT_TRUE(ring.try_pop(value));
      EXPECT_EQ(value.words[0], oldest++);
    }
  }
}

// One writer, one reader: every value whole, in order, none lost and none twice.
TEST(RingTest, TwoThreadsLoseNothing) {
  constexpr std::uint64_t count = 500'000;
  Ring<Whole, 64> ring;
  std::thread writer([&] {
    for (std::uint64_t number = 0; number < count;) {
      if (put(ring, number)) {
        ++number;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::uint64_t wrong = 0;
  Whole value{};
  for (std::uint64_t number = 0; number < count;) {
    if (!ring.try_pop(value)) {
      std::this_thread::yield();
      continue;
    }
    for (const std::uint64_t word : value.words) {
      if (word != number) ++wrong;
    }
    ++number;
  }
  writer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_FALSE(ring.try_pop(value));
}

static_assert(noexcept(std::declval<Ring<Whole, 4>&>().slot()));
static_assert(noexcept(std::declval<Ring<Whole, 4>&>().push()));
static_assert(noexcept(std::declval<Ring<Whole, 4>&>().try_pop(std::declval<Whole&>())));

}  // namespace
}  // namespace ghostforce::ring_test
