#include "app/check/verdict.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "app/check/shell_word.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/input_file.h"
#include "app/files/png_file.h"

namespace ghostforce {
namespace {

// The golden, of which only the size has been read. Empty: there is none, and `verdict` says why.
std::unique_ptr<PngFile> open_golden(const Case& judged, Verdict& verdict) {
  const std::string path = judged.golden_path();
  if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
    verdict.reason = fmt::format("the golden {} is {}, no picture; remove it", printable(path, longest_path), kind);
    verdict.is_file_trouble = true;
    return nullptr;
  }
  std::error_code unknown;
  if (std::filesystem::symlink_status(path, unknown).type() == std::filesystem::file_type::not_found) {
    verdict.reason = fmt::format("there is no golden {}", printable(path, longest_path));
    return nullptr;
  }
  return std::make_unique<PngFile>(path);
}

bool is_of_size(const PngFile& golden, const Case& judged) {
  return golden.width() == judged.width && golden.height() == judged.height;
}

// What the case's picture is held against: the golden, or the other case's picture. Empty: there is none, or it is of
// another size, and `verdict` says so.
std::optional<Image> counterpart(const Case& judged, Gallery& gallery, Verdict& verdict) {
  if (judged.wanted != Wanted::golden) return gallery.draw(judged.other).image;
  try {
    const std::unique_ptr<PngFile> golden = open_golden(judged, verdict);
    if (golden == nullptr) return std::nullopt;
    if (is_of_size(*golden, judged)) return golden->read();
    verdict.reason = fmt::format("the picture has {}x{} pixels and the golden {}x{}", judged.width, judged.height,
                                 golden->width(), golden->height());
  } catch (const Failure& failure) {
    verdict.reason = failure.what();
    verdict.is_file_trouble = true;
  }
  return std::nullopt;
}

std::string words_about(const Case& judged, const Comparison& comparison) {
  const std::string words = difference_words(comparison, judged.tolerance);
  if (judged.wanted == Wanted::golden) return words;
  return fmt::format("against the picture of {}, which it must {}be equal to: {}", printable(judged.other),
                     judged.wanted == Wanted::match ? "" : "not ", words);
}

void compare(const Case& judged, const Image& expected, const DrawnCase& drawn, Verdict& verdict) {
  const Comparison comparison = compare_pictures(expected, drawn.image, judged.tolerance);
  verdict.passes = is_within(comparison, judged.tolerance) == (judged.wanted != Wanted::mismatch);
  verdict.reason = words_about(judged, comparison);
  // No renderer changes a picture's size.
  if (!verdict.passes && judged.origin) verdict.remark = other_renderer_words(*judged.origin, drawn.origin);
}

}  // namespace

Verdict judge(const Case& judged, Gallery& gallery, std::string_view folder, bool wants_pictures) {
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict;
  verdict.name = judged.name;
  const DrawnCase drawn = gallery.draw(judged.name);
  const std::optional<Image> expected = counterpart(judged, gallery, verdict);
  if (expected) compare(judged, *expected, drawn, verdict);
  if (!verdict.passes) {
    if (judged.wanted == Wanted::golden && kind_instead_of_file(judged.golden_path()).empty()) {
      verdict.remedy = update_command(folder, judged.name);
    }
    if (wants_pictures) {
      verdict.pictures.actual = png_bytes(drawn.image);
      if (expected) {
        verdict.pictures.expected = png_bytes(*expected);
        verdict.pictures.difference = png_bytes(difference_picture(*expected, drawn.image, judged.tolerance));
      }
    }
  }
  verdict.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace ghostforce
