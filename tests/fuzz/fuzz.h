// What the fuzz targets share. A target aborts where a promise is broken; whatever it returns from is well.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <source_location>
#include <span>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ghostforce {

// Also where NDEBUG is defined.
inline void require(bool is_so, std::string_view promise,
                    const std::source_location& where = std::source_location::current()) {
  if (is_so) return;
  std::fprintf(stderr, "%s:%u: broken promise: %.*s\n", where.file_name(), static_cast<unsigned>(where.line()),
               static_cast<int>(promise.size()), promise.data());
  std::abort();
}

inline std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Takes an input apart from its beginning; past its end come zeros.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) noexcept : rest_(bytes) {}

  bool empty() const noexcept { return rest_.empty(); }
  std::uint8_t next() noexcept {
    if (rest_.empty()) return 0;
    const std::uint8_t byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }
  std::span<const std::uint8_t> take(std::size_t count) noexcept {
    const std::span<const std::uint8_t> taken = rest_.first(count < rest_.size() ? count : rest_.size());
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  // -1 to 1.
  double share() noexcept { return (next() - 128) / 128.0; }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace ghostforce
