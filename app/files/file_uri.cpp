#include "app/files/file_uri.h"

#include <array>
#include <charconv>

namespace ghostforce {

std::optional<std::string> path_of_file_uri(std::string_view uri) {
  constexpr std::array<std::string_view, 2> beginnings{"file:///", "file://localhost/"};
  for (const std::string_view beginning : beginnings) {
    if (!uri.starts_with(beginning)) continue;
    std::string path;
    for (std::size_t i = beginning.size() - 1; i < uri.size(); ++i) {
      if (uri[i] != '%') {
        path += uri[i];
        continue;
      }
      const std::string_view digits = uri.substr(i + 1, 2);
      unsigned char byte = 0;
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
      const bool is_byte = digits.size() == 2 && end == digits.data() + 2 && error == std::errc();
      if (!is_byte || byte == 0) return std::nullopt;
      path += static_cast<char>(byte);
      i += 2;
    }
    return path;
  }
  return std::nullopt;
}

}  // namespace ghostforce
