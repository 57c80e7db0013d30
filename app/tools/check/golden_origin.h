// Where a golden came from: the table [golden] of its case. What another renderer draws differs in a few pixels
// although nothing is wrong, and then this is what says so. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

struct GoldenOrigin {
  std::string renderer;  // "llvmpipe (LLVM 15.0.6)"; empty: not known
  std::string mesa;      // version of Mesa; empty: not known
  std::string version;   // of this program

  friend bool operator==(const GoldenOrigin&, const GoldenOrigin&) = default;
};

// Of a picture that is drawn now; `graphics` as Window::graphics_description() has it. How wide the processor's vectors
// are is left out: it changes no pixel.
GoldenOrigin present_origin(std::string_view graphics);

// Why a picture may differ although the program draws what it always did; empty where both were drawn alike, or where
// it is not known by what the golden was.
std::string other_renderer_words(const GoldenOrigin& golden, const GoldenOrigin& present);

// Why a picture may differ: another renderer, or another version of this program; empty where neither is known.
std::string other_origin_words(const GoldenOrigin& golden, const GoldenOrigin& present);

// A case's text with this table in it, and with each byte of the rest as it was. Throws Failure(wrong_call) where the
// table is written in a way that this cannot change; `shown_path` is what the message calls the file.
std::string with_origin(const std::string& case_text, const GoldenOrigin& origin, std::string_view shown_path);

}  // namespace ghostforce
