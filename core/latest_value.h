// LatestValue: wait-free exchange of the newest whole value between one writing and one reading thread (a triple
// buffer); and copy_whole(), the fast copy that it is made with. Nothing here waits, allocates or throws.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace ghostforce {

// `to` = `from`, piece by piece; two different values. The servo copies values of a few hundred bytes several times per
// tick, and gcc turns an assignment of that size into `rep movs`, which takes ten nanoseconds to begin. Any thread.
template <typename T>
void copy_whole(const T& from, T& to) noexcept {
  static_assert(std::is_trivially_copyable_v<T>);
  constexpr std::size_t piece = 128;  // which compilers still turn into plain moves
  constexpr std::size_t whole_pieces = sizeof(T) / piece * piece;
  const auto* source = reinterpret_cast<const std::byte*>(&from);
  auto* target = reinterpret_cast<std::byte*>(&to);
  for (std::size_t at = 0; at < whole_pieces; at += piece) std::memcpy(target + at, source + at, piece);
  std::memcpy(target + whole_pieces, source + whole_pieces, sizeof(T) - whole_pieces);
}

// One thread calls publish(), one thread calls latest(); neither ever sees half a value. Values that the reader was too
// slow for are overwritten: this carries state, not a log. Plain acquire and release, no fences, so that
// ThreadSanitizer can check it.
template <typename T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>, "a value that crosses threads is copied whole, byte for byte");

 public:
  explicit LatestValue(const T& initial) noexcept : slots_{{{initial}, {initial}, {initial}}} {}

  LatestValue(const LatestValue&) = delete;
  LatestValue& operator=(const LatestValue&) = delete;

  // Writer only.
  void publish(const T& value) noexcept {
    copy_whole(value, slots_[write_].value);
    // Release: the value above is complete before the reader can take the slot.
    // Acquire: the slot that comes back has been left by the reader for good.
    write_ = middle_.exchange(write_ | fresh, std::memory_order_acq_rel) & slot_mask;
  }

  // Reader only. True if the next latest() would be a value not seen before.
  bool has_news() const noexcept { return (middle_.load(std::memory_order_relaxed) & fresh) != 0; }

  // Reader only. The newest value; the reference stays valid until the next call.
  const T& latest() noexcept {
    if (has_news()) read_ = middle_.exchange(read_, std::memory_order_acq_rel) & slot_mask;
    return slots_[read_].value;
  }

 private:
  // A slot's number, and whether it is fresh. A whole word: to exchange a byte was seen to take twice as long on x86,
  // copy included.
  using Number = std::uint32_t;
  static constexpr Number fresh = 4;
  static constexpr Number slot_mask = 3;

  // A cache line each, so that writer and reader do not slow each other down.
  struct alignas(64) Slot {
    T value;
  };

  std::array<Slot, 3> slots_;
  alignas(64) std::atomic<Number> middle_{1};  // the slot in neither side's hands, and whether it is fresh
  alignas(64) Number write_ = 0;               // the writer's own slot
  alignas(64) Number read_ = 2;                // the reader's own slot
};

}  // namespace ghostforce
