// PNG files made by hand, good ones and damaged ones, with no library that could refuse to. For tests, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ghostforce {

inline std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

inline std::uint32_t crc32_of(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ (crc % 2 != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

inline std::string png_chunk(std::string_view name, std::string_view data) {
  const std::string named = std::string(name).append(data);
  return big_endian(static_cast<std::uint32_t>(data.size())) + named + big_endian(crc32_of(named));
}

// `rows`: each with its filter's byte, less than 64 KiB in all. `before` are chunks between header and data; `off_by`
// is added to the checksum of the data.
inline std::string png_of(std::uint32_t width, std::uint32_t height, int depth, int colour_type, std::string_view rows,
                          std::string_view before = "", std::uint32_t off_by = 0) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : rows) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const std::size_t size = rows.size();
  const auto byte = [](std::size_t number) { return static_cast<char>(number & 0xFFU); };
  std::string stored = "\x78\x01\x01";  // zlib, one block, stored
  stored += {byte(size), byte(size >> 8U), byte(~size), byte(~size >> 8U)};
  stored.append(rows).append(big_endian((b << 16U | a) + off_by));
  std::string header = big_endian(width) + big_endian(height);
  header += {static_cast<char>(depth), static_cast<char>(colour_type), 0, 0, 0};
  return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header) + std::string(before) + png_chunk("IDAT", stored) +
         png_chunk("IEND", "");
}

// Of the first chunk of this name.
inline std::string with_wrong_crc(std::string png, std::string_view name) {
  const std::size_t at = png.find(name);
  std::size_t length = 0;
  for (std::size_t i = at - 4; i < at; ++i) length = length << 8U | static_cast<unsigned char>(png.at(i));
  png.at(at + 4 + length) ^= 1;
  return png;
}

}  // namespace ghostforce
