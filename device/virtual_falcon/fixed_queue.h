// FixedQueue: first in, first out, in a place of fixed size; never allocates. One thread.
#pragma once

#include <array>
#include <cstddef>

namespace ghostforce {

template <typename T, std::size_t Capacity>
class FixedQueue {
 public:
  std::size_t size() const noexcept { return size_; }
  std::size_t room() const noexcept { return Capacity - size_; }
  bool empty() const noexcept { return size_ == 0; }
  void clear() noexcept { size_ = 0; }

  // Only while there is room.
  void push(const T& value) noexcept { values_[(first_ + size_++) % Capacity] = value; }

  // Only of what is in it.
  const T& operator[](std::size_t index) const noexcept { return values_[(first_ + index) % Capacity]; }
  const T& front() const noexcept { return values_[first_]; }
  T pop() noexcept {
    const T value = values_[first_];
    first_ = (first_ + 1) % Capacity;
    --size_;
    return value;
  }

 private:
  std::array<T, Capacity> values_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace ghostforce
