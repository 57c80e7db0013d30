// The guard itself: it must catch every road to the heap, or what it proves elsewhere is nothing.
#include "tests/support/heap_guard.h"

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace ghostforce::heap_guard_test {
namespace {

// Keeps the compiler from leaving out an allocation that nothing reads.
void* volatile kept = nullptr;

TEST(HeapGuard, StaysSilentWithoutHeap) {
  HeapGuard guard;
  int on_stack[16] = {};
  kept = on_stack;
  EXPECT_EQ(guard.take_uses(), 0U);
}

TEST(HeapGuard, CountsEachAllocationAndEachRelease) {
  HeapGuard guard;
  kept = std::malloc(100);
  EXPECT_GE(guard.take_uses(), 1U) << "malloc";
  kept = std::realloc(kept, 100'000);
  EXPECT_GE(guard.take_uses(), 1U) << "realloc";
  std::free(kept);
  EXPECT_EQ(guard.take_uses(), 1U) << "free";
  kept = std::calloc(10, 10);
  EXPECT_GE(guard.take_uses(), 1U) << "calloc";
  std::free(kept);
  guard.take_uses();
}

TEST(HeapGuard, CountsAlignedAllocations) {
  HeapGuard guard;
  kept = std::aligned_alloc(64, 640);
  EXPECT_GE(guard.take_uses(), 1U) << "aligned_alloc";
  std::free(kept);
  guard.take_uses();
  void* block = nullptr;
  ASSERT_EQ(posix_memalign(&block, 64, 640), 0);
  EXPECT_GE(guard.take_uses(), 1U) << "posix_memalign";
  std::free(block);
  guard.take_uses();
}

TEST(HeapGuard, CountsNewAndDelete) {
  HeapGuard guard;
  int* const number = new int(7);
  kept = number;
  EXPECT_GE(guard.take_uses(), 1U) << "new";
  delete number;
  EXPECT_GE(guard.take_uses(), 1U) << "delete";
  int* const numbers = new int[100];
  kept = numbers;
  EXPECT_GE(guard.take_uses(), 1U) << "new[]";
  delete[] numbers;
  EXPECT_GE(guard.take_uses(), 1U) << "delete[]";
  struct alignas(128) Wide {
    char bytes[128];
  };
  Wide* const wide = new Wide;
  kept = wide;
  EXPECT_GE(guard.take_uses(), 1U) << "aligned new";
  delete wide;
  EXPECT_GE(guard.take_uses(), 1U) << "aligned delete";
}

TEST(HeapGuard, SeesIntoTheStandardLibrary) {
  HeapGuard guard;
  {
    std::string text(1000, 'x');  // its allocation is compiled into libstdc++
    kept = text.data();
  }
  EXPECT_GE(guard.take_uses(), 2U);
}

TEST(HeapGuard, FailsTheTest) {
  EXPECT_NONFATAL_FAILURE(
      {
        HeapGuard guard;
        kept = new int(7);
      },
      "The heap was used");
  delete static_cast<int*>(kept);
}

TEST(HeapGuard, DoesNotLookAtOtherThreads) {
  std::atomic<bool> is_guarded{false};
  std::atomic<bool> has_allocated{false};
  std::thread other([&] {
    while (!is_guarded) std::this_thread::yield();
    kept = std::malloc(100);
    std::free(kept);
    has_allocated = true;
  });
  {
    HeapGuard guard;
    is_guarded = true;
    while (!has_allocated) std::this_thread::yield();
    EXPECT_EQ(guard.take_uses(), 0U);
  }
  other.join();
}

}  // namespace
}  // namespace ghostforce::heap_guard_test
