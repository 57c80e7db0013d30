#include "app/files/png_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/files/deflate.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr int word_bytes = 4;

// Plain letters need no more than the oldest kind of chunk.
std::string shortest_text_chunk(const PngText& text) {
  const bool is_ascii = std::ranges::all_of(text.text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return is_ascii ? png_chunk("tEXt", text.keyword + '\0' + text.text) : png_text_chunk(text);
}

}  // namespace

PngText software_text() {
  return {"Software", fmt::format("ghostforce {}", version)};
}

std::string png_bytes(const Image& image, std::span<const PngText> texts) {
  constexpr int compression_level = 3;
  constexpr std::size_t piece_size = 8192;  // a reader needs little memory
  std::string bytes(png_signature);
  bytes += png_header(image.width, image.height, image.alpha.empty() ? PngColour::rgb : PngColour::rgb_and_alpha);
  for (const PngText& text : texts) bytes += shortest_text_chunk(text);
  const std::string stream = deflated(png_rows(image), compression_level);
  for (std::size_t at = 0; at < stream.size(); at += piece_size) {
    bytes += png_chunk("IDAT", std::string_view(stream).substr(at, piece_size));
  }
  return bytes += png_chunk("IEND", {});
}

std::string in_network_order(std::uint32_t number, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(number >> shift & 0xFFU);
  return text;
}

std::string png_chunk(std::string_view name, std::string_view data) {
  const std::string named = std::string(name).append(data);
  return in_network_order(static_cast<std::uint32_t>(data.size()), word_bytes) + named +
         in_network_order(checksum(named), word_bytes);
}

std::string png_header(int width, int height, PngColour colour) {
  std::string header = in_network_order(static_cast<std::uint32_t>(width), word_bytes) +
                       in_network_order(static_cast<std::uint32_t>(height), word_bytes);
  header += {8, static_cast<char>(colour), 0, 0, 0};  // bits a channel; compression, filter, interlacing: the usual
  return png_chunk("IHDR", header);
}

std::string png_text_chunk(const PngText& text) {
  // Not compressed, no language and no translation of the keyword.
  constexpr std::string_view plain("\0\0\0\0\0", 5);
  return png_chunk("iTXt", std::string(text.keyword).append(plain).append(text.text));
}

std::string png_rows(const Image& image) {
  constexpr char png_filter_none = 0;  // the filter of a row
  std::string rows;
  rows.reserve(image.rgb.size() + image.alpha.size() + static_cast<std::size_t>(image.height));
  const auto columns = static_cast<std::size_t>(image.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    rows += png_filter_none;
    const std::uint8_t* const colours = &image.rgb[3 * row * columns];
    if (image.alpha.empty()) {
      rows.append(reinterpret_cast<const char*>(colours), 3 * columns);
      continue;
    }
    for (std::size_t x = 0; x < columns; ++x) {
      rows.append(reinterpret_cast<const char*>(colours + 3 * x), 3);
      rows += static_cast<char>(image.alpha[row * columns + x]);
    }
  }
  return rows;
}

}  // namespace ghostforce
