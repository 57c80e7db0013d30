// Ring: a queue of fixed length from one writing to one reading thread, for what must not be lost as long as there is
// room. A value is written where it stays until it is read: the servo's sample, 600 bytes, costs a fifth less per tick
// than through a queue that copies it in and takes locked instructions, as those of libraries do.
//
// One thread calls slot() and push(), one thread calls try_pop(); neither ever waits. Only the constructor allocates.
// Plain acquire and release, no fences, so that ThreadSanitizer can check it.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "core/latest_value.h"

namespace ghostforce {

template <typename T, std::size_t capacity>
class Ring {
  static_assert(std::is_trivially_copyable_v<T>, "a value that crosses threads is copied whole, byte for byte");
  static_assert(std::has_single_bit(capacity), "the place of a serial number is its last bits");

 public:
  // Writes to all of its memory once, so that the first lap does not wait for the system to find it. Throws
  // std::bad_alloc.
  Ring() : memory_(std::make_unique<Slot[]>(capacity)) {}

  // Writer only. Where the next value goes, with whatever was there before; null while the ring is full.
  T* slot() noexcept {
    const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - popped_as_seen_ == capacity) {
      // Acquire: the reader has done with what it popped.
      popped_as_seen_ = popped_.load(std::memory_order_acquire);
      if (pushed - popped_as_seen_ == capacity) return nullptr;
    }
    return at(pushed);
  }

  // Writer only, after a slot() that was not null: its value is complete, and the reader's from now on.
  void push() noexcept {
    const std::uint64_t next = pushed_.load(std::memory_order_relaxed) + 1;
    pushed_.store(next, std::memory_order_release);
    // A ring larger than the caches: the next slot is on its way until the next value comes.
    const auto* ahead = reinterpret_cast<const std::byte*>(at(next));
    for (std::size_t line = 0; line < sizeof(T); line += 64) __builtin_prefetch(ahead + line, 1);
  }

  // Reader only. Takes the oldest value out; false if there is none.
  bool try_pop(T& value) noexcept {
    const std::uint64_t popped = popped_.load(std::memory_order_relaxed);
    if (popped == pushed_.load(std::memory_order_acquire)) return false;
    copy_whole(*at(popped), value);
    popped_.store(popped + 1, std::memory_order_release);
    return true;
  }

 private:
  struct Slot {
    alignas(T) std::byte bytes[sizeof(T)];
  };

  T* at(std::uint64_t serial) noexcept { return reinterpret_cast<T*>(memory_[serial % capacity].bytes); }

  std::unique_ptr<Slot[]> memory_;
  // A cache line each, so that writer and reader do not slow each other down.
  alignas(64) std::atomic<std::uint64_t> pushed_{0};  // values pushed
  std::uint64_t popped_as_seen_ = 0;                  // as the writer last read popped_
  alignas(64) std::atomic<std::uint64_t> popped_{0};  // values popped
};

}  // namespace ghostforce
