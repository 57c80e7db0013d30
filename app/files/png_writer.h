// PNG files as bytes: the same image gives the same bytes. The pieces are those of the format. Pure, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "app/files/image.h"

namespace ghostforce {

// Words that a PNG file carries beside its pixels, as chunks of the format: a keyword and a text each.
struct PngText {
  std::string keyword;  // one of the format's where one fits: "Description", "Software" …; 1 to 79 letters of ASCII
  std::string text;     // UTF-8

  friend bool operator==(const PngText&, const PngText&) = default;
};

// By which program, in which version, a file was made.
PngText software_text();

// The whole file's content. The texts stand before the pixels, so that a reader need not decode these.
std::string png_bytes(const Image& image, std::span<const PngText> texts = {});

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

// The picture's rows, not compressed yet. They are stored as they are: what is drawn is flat for the most part, and the
// filters that photographs want make such files larger (that of the window by a sixth), in three times the time.
std::string png_rows(const Image& image);

}  // namespace ghostforce
