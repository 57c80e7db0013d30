// HeapGuard: while one stands, any use of the heap by its thread is counted, by whatever road it comes (malloc and its
// relatives, new, delete, free, in our code or in a library), and fails the test when the guard ends. Other threads are
// not looked at. Guards of one thread may be nested; each use counts for all of them. glibc; under the address and
// thread sanitizers too.
//
// A test program that wants it adds support/heap_guard.cpp to its sources.
#pragma once

#include <cstdint>

namespace ghostforce {

class HeapGuard {
 public:
  HeapGuard() noexcept;
  HeapGuard(const HeapGuard&) = delete;
  HeapGuard& operator=(const HeapGuard&) = delete;
  // Adds a failure to the running test if there was any use that nobody took.
  ~HeapGuard();

  // How often the heap was used since this was last asked; what is told here is no failure any more.
  std::uint64_t take_uses() noexcept;

 private:
  std::uint64_t uses_before_;
};

}  // namespace ghostforce
