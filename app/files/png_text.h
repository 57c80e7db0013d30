// Words that a PNG file carries beside its pixels, as chunks of the format: a keyword and a text each. Pure, any thread.
#pragma once

#include <string>

namespace ghostforce {

struct PngText {
  std::string keyword;  // one of the format's where one fits: "Description", "Software" …; 1 to 79 letters of ASCII
  std::string text;     // UTF-8

  friend bool operator==(const PngText&, const PngText&) = default;
};

// By which program, in which version, a file was made.
PngText software_text();

}  // namespace ghostforce
