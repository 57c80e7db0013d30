// The pieces that a PNG file consists of, as bytes. Pure, any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/files/png_text.h"

namespace ghostforce {

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1A\n";

// A number in network order, of so many bytes.
std::string in_network_order(std::uint32_t number, int bytes);

// `name` has four letters.
std::string png_chunk(std::string_view name, std::string_view data);

// The colour type of a header.
enum class PngColour : std::uint8_t { rgb = 2, rgb_and_alpha = 6 };
// Of a picture with eight bits a channel.
std::string png_header(int width, int height, PngColour colour);

// UTF-8, not compressed.
std::string png_text_chunk(const PngText& text);

}  // namespace ghostforce
