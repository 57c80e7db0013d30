#include "core/latest_value.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace ghostforce::latest_value_test {
namespace {

// Larger than a cache line, every word the same: a torn read shows as two words that differ.
struct Whole {
  std::array<std::uint64_t, 24> words;

  static Whole of(std::uint64_t number) {
    Whole whole{};
    whole.words.fill(number);
    return whole;
  }
  bool torn() const {
    for (const std::uint64_t word : words) {
      if (word != words[0]) return true;
    }
    return false;
  }
};

TEST(LatestValueTest, StartsWithTheInitialValueWhichIsNoNews) {
  LatestValue<int> exchange(7);
  EXPECT_FALSE(exchange.has_news());
  EXPECT_EQ(exchange.latest(), 7);
  EXPECT_EQ(exchange.latest(), 7);
}

TEST(LatestValueTest, GivesTheNewestAndKeepsIt) {
  LatestValue<int> exchange(0);
  exchange.publish(1);
  EXPECT_TRUE(exchange.has_news());
  EXPECT_EQ(exchange.latest(), 1);
  EXPECT_FALSE(exchange.has_news());
  EXPECT_EQ(exchange.latest(), 1);
  exchange.publish(2);
  exchange.publish(3);
  exchange.publish(4);
  exchange.publish(5);
  EXPECT_EQ(exchange.latest(), 5);
  EXPECT_EQ(exchange.latest(), 5);
}

// The reader's value is its own until it asks again, however much is published meanwhile.
TEST(LatestValueTest, WriterLeavesTheReadersValueAlone) {
  LatestValue<int> exchange(0);
  exchange.publish(1);
  const int& mine = exchange.latest();
  for (int i = 2; i < 10; ++i) {
    exchange.publish(i);
    EXPECT_EQ(mine, 1);
  }
  EXPECT_EQ(exchange.latest(), 9);
}

// Every order of a few writes and reads gives the last value written.
TEST(LatestValueTest, AnyOrderOfWritesAndReadsGivesTheNewest) {
  for (unsigned order = 0; order < (1U << 12); ++order) {
    LatestValue<int> exchange(0);
    int newest = 0;
    for (unsigned step = 0; step < 12; ++step) {
      if ((order >> step & 1U) != 0) {
        exchange.publish(++newest);
      } else {
        ASSERT_EQ(exchange.latest(), newest) << order;
      }
    }
  }
}

// One writer, one reader, millions of values: none torn, none going backwards, and the last one arrives.
TEST(LatestValueTest, TwoThreadsSeeWholeValuesInOrder) {
  constexpr std::uint64_t last = 2'000'000;
  LatestValue<Whole> exchange(Whole::of(0));
  std::atomic<bool> reader_is_there{false};
  std::thread writer([&] {
    while (!reader_is_there.load()) std::this_thread::yield();
    for (std::uint64_t number = 1; number <= last; ++number) exchange.publish(Whole::of(number));
  });
  std::uint64_t torn = 0;
  std::uint64_t backwards = 0;
  std::uint64_t seen = 0;
  std::uint64_t newest = 0;
  reader_is_there.store(true);
  while (newest != last) {
    const bool news = exchange.has_news();
    const Whole& value = exchange.latest();
    if (value.torn()) ++torn;
    if (value.words[0] < newest || (news && value.words[0] == newest)) ++backwards;
    if (value.words[0] != newest) ++seen;
    newest = value.words[0];
    if (torn + backwards > 0) break;  // enough to fail on, and a torn last value would never end
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(backwards, 0U);
  EXPECT_GT(seen, 0U);
  EXPECT_FALSE(exchange.has_news());
}

static_assert(noexcept(std::declval<LatestValue<int>&>().publish(1)));
static_assert(noexcept(std::declval<LatestValue<int>&>().latest()));

}  // namespace
}  // namespace ghostforce::latest_value_test
