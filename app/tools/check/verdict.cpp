#include "app/tools/check/verdict.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/quoted.h"
#include "app/files/input_file.h"
#include "app/files/png_file.h"
#include "app/files/png_writer.h"
#include "app/files/read_error.h"
#include "app/tools/check/case_folder.h"

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
  if (!verdict.passes && checked.origin) verdict.remark = other_origin_words(*checked.origin, drawn.origin);
}

}  // namespace

CheckedNumbers check_numbers(const Case& checked, const StrategySnapshot<2>& actual) {
  CheckedNumbers numbers{};
  for (std::size_t i = 0; i < quantity_count; ++i) {
    if (!checked.numbers[i]) continue;
    numbers[i] = CheckedNumber{*checked.numbers[i], quantity_catalog()[i].value(actual), checked.number_tolerance};
  }
  return numbers;
}

std::string wrong_numbers(const CheckedNumbers& numbers) {
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < quantity_count; ++i) {
    const std::optional<CheckedNumber>& number = numbers[i];
    if (!number || number->passes()) continue;
    wrong.push_back(fmt::format("{} is {}, not {} ± {}", quantity_catalog()[i].column, number->actual, number->expected,
                                number->tolerance));
  }
  return fmt::format("{}", fmt::join(wrong, "; "));
}

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
  verdict.numbers = check_numbers(checked, drawn.numbers);
  const std::string wrong = wrong_numbers(verdict.numbers);
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
  const bool has_number = std::ranges::any_of(verdict.numbers, [](const auto& number) { return number.has_value(); });
  if (has_number && wrong.empty()) verdict.reason += "; the numbers are as stated";
  // A new golden mends no number.
  if (!wrong.empty()) {
    verdict.reason = verdict.passes ? wrong : fmt::format("{}; {}", wrong, verdict.reason);
    verdict.passes = false;
  }
  verdict.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

namespace {

// Every member of these, for both ways. A member that is forgotten here does not compile.
auto members_of(auto& value) {
  using Type = std::remove_cvref_t<decltype(value)>;
  if constexpr (std::is_same_v<Type, Verdict>) {
    auto& [name, passes, is_file_trouble, is_lenient, tolerance, reason, remark, remedy, comparison, numbers, drawn_by,
           duration_s, pictures] = value;
    return std::tie(name, passes, is_file_trouble, is_lenient, tolerance, reason, remark, remedy, comparison, numbers,
                    drawn_by, duration_s, pictures);
  } else if constexpr (std::is_same_v<Type, GoldenOrigin>) {
    auto& [renderer, mesa, version] = value;
    return std::tie(renderer, mesa, version);
  } else {
    static_assert(std::is_same_v<Type, VerdictPictures>);
    auto& [expected, actual, difference] = value;
    return std::tie(expected, actual, difference);
  }
}

template <typename Value>
void append(std::string& bytes, const Value& value) {
  if constexpr (std::is_trivially_copyable_v<Value>) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    append(bytes, value.size());
    bytes += value;
  } else if constexpr (std::is_same_v<Value, std::optional<std::string>>) {
    append(bytes, value.has_value());
    if (value) append(bytes, *value);
  } else {
    std::apply([&](const auto&... each) { (append(bytes, each), ...); }, members_of(value));
  }
}

std::string_view take(std::string_view& bytes, std::size_t count) {
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

template <typename Value>
void extract(std::string_view& bytes, Value& value) {
  if constexpr (std::is_trivially_copyable_v<Value>) {
    std::memcpy(&value, take(bytes, sizeof value).data(), sizeof value);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    std::size_t size = 0;
    extract(bytes, size);
    value = take(bytes, size);
  } else if constexpr (std::is_same_v<Value, std::optional<std::string>>) {
    bool is_there = false;
    extract(bytes, is_there);
    if (is_there) extract(bytes, value.emplace());
  } else {
    std::apply([&](auto&... each) { (extract(bytes, each), ...); }, members_of(value));
  }
}

}  // namespace

std::string bytes_of(const Verdict& verdict) {
  std::string bytes;
  append(bytes, verdict);
  return bytes;
}

Verdict verdict_of(std::string_view bytes) {
  Verdict verdict;
  extract(bytes, verdict);
  return verdict;
}

}  // namespace ghostforce
