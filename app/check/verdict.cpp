#include "app/check/verdict.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "app/check/shell_word.h"
#include "app/failure.h"
#include "app/file_kind.h"
#include "app/png_file.h"
#include "app/printable.h"

namespace ghostforce {
namespace {

// What the case's picture is held against: the golden, or the other case's picture. Empty: there is none, and `verdict`
// says why.
std::optional<Image> counterpart(const Case& judged, Gallery& gallery, Verdict& verdict) {
  if (judged.wanted != Wanted::golden) return gallery.draw(judged.other).image;
  const std::string path = judged.golden_path();
  if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
    verdict.reason = fmt::format("the golden {} is {}, no picture; remove it", printable(path, longest_path), kind);
    verdict.is_file_trouble = true;
    return std::nullopt;
  }
  std::error_code unknown;
  if (std::filesystem::symlink_status(path, unknown).type() == std::filesystem::file_type::not_found) {
    verdict.reason = fmt::format("there is no golden {}", printable(path, longest_path));
    return std::nullopt;
  }
  try {
    return read_png(path);
  } catch (const Failure& failure) {
    verdict.reason = failure.what();
    verdict.is_file_trouble = true;
    return std::nullopt;
  }
}

std::string words_about(const Case& judged, const Image& expected, const Image& actual, const Comparison& comparison) {
  if (!comparison.has_one_size) {
    return fmt::format("the picture has {} pixels and the golden {}", size_words(actual), size_words(expected));
  }
  const std::string words = difference_words(comparison, judged.tolerance);
  if (judged.wanted == Wanted::golden) return words;
  return fmt::format("against the picture of {}, which it must {}be equal to: {}", printable(judged.other),
                     judged.wanted == Wanted::match ? "" : "not ", words);
}

void compare(const Case& judged, const Image& expected, const Image& actual, Verdict& verdict) {
  const Comparison comparison = compare_pictures(expected, actual, judged.tolerance);
  verdict.passes = is_within(comparison, judged.tolerance) == (judged.wanted != Wanted::mismatch);
  verdict.reason = words_about(judged, expected, actual, comparison);
}

}  // namespace

Verdict judge(const Case& judged, Gallery& gallery, std::string_view folder, bool wants_pictures) {
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict;
  verdict.name = judged.name;
  const DrawnCase drawn = gallery.draw(judged.name);
  const std::optional<Image> expected = counterpart(judged, gallery, verdict);
  if (expected) compare(judged, *expected, drawn.image, verdict);
  if (!verdict.passes) {
    if (judged.wanted == Wanted::golden && kind_instead_of_file(judged.golden_path()).empty()) {
      verdict.remedy = update_command(folder, judged.name);
    }
    if (expected && judged.origin) verdict.remark = other_renderer_words(*judged.origin, drawn.origin);
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
