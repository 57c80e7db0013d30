#include "app/check/verdict.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "app/check/update.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/input_file.h"
#include "app/files/png_file.h"
#include "app/files/png_writer.h"
#include "app/files/read_error.h"

namespace ghostforce {
namespace {

// The golden, of which only the size has been read. Empty: there is none, and `verdict` says why.
std::unique_ptr<PngFile> open_golden(const Case& checked, Verdict& verdict) {
  const std::string path = checked.golden_path();
  if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
    verdict.reason =
        fmt::format("the golden {} is {}, not a picture; remove it", quoted_text(path, longest_path), kind);
    verdict.is_file_trouble = true;
    return nullptr;
  }
  std::error_code unknown;
  if (std::filesystem::symlink_status(path, unknown).type() == std::filesystem::file_type::not_found) {
    verdict.reason = fmt::format("there is no golden {}", quoted_text(path, longest_path));
    return nullptr;
  }
  return std::make_unique<PngFile>(path);
}

// What the case's picture is held against: the golden, or the other case's picture. Empty: there is none, or it is of
// another size, and `verdict` says so.
std::optional<Image> counterpart(const Case& checked, RenderedCases& rendered, Verdict& verdict) {
  if (checked.expectation != Expectation::golden) return rendered.draw(checked.other).image;
  try {
    const std::unique_ptr<PngFile> golden = open_golden(checked, verdict);
    if (golden == nullptr) return std::nullopt;
    if (golden->width() == checked.width && golden->height() == checked.height) return golden->read();
    verdict.reason = fmt::format("the picture has {}x{} pixels, but the golden has {}x{}", checked.width,
                                 checked.height, golden->width(), golden->height());
  } catch (const ReadError& error) {
    verdict.reason = error.what();
    verdict.is_file_trouble = true;
  }
  return std::nullopt;
}

std::string words_about(const Case& checked, const Comparison& comparison, const Tolerance& tolerance) {
  const std::string words = difference_words(comparison, tolerance);
  if (checked.expectation == Expectation::golden) return words;
  return fmt::format("compared with the picture of {}, which it must {}equal: {}", quoted_text(checked.other),
                     checked.expectation == Expectation::match ? "" : "not ", words);
}

void compare(const Case& checked, const Mask& mask, const Image& expected, const RenderedCase& drawn,
             Verdict& verdict) {
  const Comparison& comparison =
      verdict.comparison.emplace(compare_pictures(expected, drawn.image, verdict.tolerance, mask));
  verdict.passes = is_within(comparison, verdict.tolerance) == (checked.expectation != Expectation::mismatch);
  verdict.reason = words_about(checked, comparison, verdict.tolerance);
  // No renderer changes a picture's size.
  if (!verdict.passes && checked.origin) verdict.remark = other_renderer_words(*checked.origin, drawn.origin);
}

}  // namespace

bool is_for_graphics_card(const Case& checked, std::optional<Renderer> renderer, const GoldenOrigin& present) {
  return renderer == Renderer::gpu && checked.expectation == Expectation::golden && !checked.has_tolerance &&
         checked.origin && !other_renderer_words(*checked.origin, present).empty();
}

Verdict evaluate(const Case& checked, RenderedCases& rendered, std::string_view folder, bool wants_pictures) {
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict;
  verdict.name = checked.name;
  const RenderedCase drawn = rendered.draw(checked.name);
  verdict.drawn_by = drawn.origin;
  const std::optional<Image> expected = counterpart(checked, rendered, verdict);
  verdict.is_lenient = expected && is_for_graphics_card(checked, rendered.renderer(), drawn.origin);
  verdict.tolerance = verdict.is_lenient ? graphics_card_tolerance : checked.tolerance;
  const Mask mask(checked.width, checked.height, checked.mask);
  if (expected) compare(checked, mask, *expected, drawn, verdict);
  if (!verdict.passes) {
    if (checked.expectation == Expectation::golden && kind_instead_of_file(checked.golden_path()).empty()) {
      verdict.remedy = update_command(folder, checked.name);
    }
    if (wants_pictures) {
      verdict.pictures.actual = png_bytes(drawn.image);
      if (expected) {
        verdict.pictures.expected = png_bytes(*expected);
        verdict.pictures.difference = png_bytes(difference_picture(*expected, drawn.image, verdict.tolerance, mask));
      }
    }
  }
  verdict.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace ghostforce
