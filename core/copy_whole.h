// Copying a value of a few hundred bytes, as the servo does several times per tick. An assignment of that size becomes
// `rep movs` with gcc, which takes ten nanoseconds to begin. Pure, never allocates or throws, any thread.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace ghostforce {

// `to` = `from`, piece by piece; two different values.
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

}  // namespace ghostforce
