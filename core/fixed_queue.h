// FixedQueue: first in, first out, in a place of fixed size; what crosses threads has a Ring. Allocates and throws nothing;
// one thread.
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

  // False, and nothing has happened: it is full.
  bool push(const T& value) noexcept {
    if (size_ == Capacity) return false;
    values_[(first_ + size_++) % Capacity] = value;
    return true;
  }

  // Only of what is in it.
  const T& operator[](std::size_t index) const noexcept { return values_[(first_ + index) % Capacity]; }
  const T& front() const noexcept { return values_[first_]; }
  const T& back() const noexcept { return (*this)[size_ - 1]; }
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
