#include "app/files/png_chunks.h"

#include "app/files/deflate.h"

namespace ghostforce {
namespace {

constexpr int word_bytes = 4;

}  // namespace

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

}  // namespace ghostforce
