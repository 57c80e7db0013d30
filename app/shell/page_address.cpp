#include "app/shell/page_address.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/read_error.h"
#include "app/state/stage_language.h"

namespace ghostforce {
namespace {

[[noreturn]] void refuse_part(std::string what) {
  throw ReadError(ReadError::Kind::wrong, {{.what = std::move(what)}});
}

// What an address can ask for. `read` throws ReadError.
struct Wish {
  std::string_view name;
  std::string_view value;  // what has to stand behind its =, for who left it out; empty: nothing, or 1
  std::function<void(std::string value, PageAddress& address)> read;
};

std::string read_wanted_language(std::string value) {
  const std::string_view code = std::string_view(value).substr(0, value.find_first_of("_-.@"));
  std::vector<std::string_view> codes;
  for (const StageLanguage* const each : stage_languages) codes.push_back(each->code);
  if (std::ranges::count(codes, code) == 0) refuse_part(not_one_of(value, codes));
  return std::string(code);
}

std::size_t read_step(const std::string& value) {
  const auto step = number_in<std::size_t>(value);
  if (!step || *step == 0) refuse_part(fmt::format("'{}' is not the number of a step; give 1 or more", value));
  return *step;
}

const std::vector<Wish>& wishes() {
  static const std::vector<Wish> all{
      {"lesson", "the name of a lesson", [](std::string value, PageAddress& into) { into.lesson = std::move(value); }},
      {"step", "the number of a step of the lesson",
       [](const std::string& value, PageAddress& into) { into.lesson_step = read_step(value); }},
      {"language", "en or es",
       [](std::string value, PageAddress& into) { into.language = read_wanted_language(std::move(value)); }},
      {"kiosk", "", [](const std::string&, PageAddress& into) { into.is_kiosk = true; }},
      {"reset", "", [](const std::string&, PageAddress& into) { into.is_for_new_person = true; }},
      {"fit", "", [](const std::string&, PageAddress& into) { into.fits = true; }},
      {"embed", "the origin of the page around this one",
       [](std::string value, PageAddress& into) { into.embedder = std::move(value); }},
      {"notices", "", [](const std::string&, PageAddress&) {}},  // shown without the program
  };
  return all;
}

// What mail and social sites add to the links that they hand on.
bool is_of_others(std::string_view name) noexcept {
  return name.starts_with("utm_") || name.ends_with("clid");
}

void read_wish(std::string_view written, std::set<std::string>& read, PageAddress& address) {
  const std::string name = without_percent_signs(take_until(written, '='));
  const std::string value = without_percent_signs(written);
  if (is_of_others(name)) return;
  const auto wish = std::ranges::find(wishes(), name, &Wish::name);
  if (wish == wishes().end()) {
    std::vector<std::string_view> names = names_of(wishes());
    refuse_part(not_one_of(name, names));
  }
  if (!read.insert(name).second) refuse_part(fmt::format("{} is there twice; the first one counts", name));
  if (value.empty() && !wish->value.empty()) refuse_part(fmt::format("{} has no value; give {}", name, wish->value));
  if (wish->value.empty() && !value.empty() && value != "1") {
    refuse_part(fmt::format("{} takes no value but 1; leave it out where it is not wanted", name));
  }
  if (const auto unshowable = unshowable_in(value, false))
    refuse_part(fmt::format("there is {} in {}", *unshowable, name));
  wish->read(value, address);
}

}  // namespace

PageAddress read_page_address(std::string_view query, const IsOrigin& is_origin) {
  PageAddress address;
  std::set<std::string> read;
  if (query.starts_with('?')) query.remove_prefix(1);
  while (!query.empty()) {
    const std::string_view written = take_until(query, '&');
    if (written.empty()) continue;
    try {
      read_wish(written, read, address);
    } catch (const ReadError& error) {
      address.problems.push_back(
          fmt::format("'{}' in the address of this page cannot be used: {}", quoted_text(written), error.what()));
    }
  }
  const bool takes_step = !address.lesson.empty() && !address.is_kiosk;
  if (address.lesson_step && !takes_step) {
    address.lesson_step.reset();
    address.problems.push_back(fmt::format("'step' in the address of this page is not used: {}",
                                           address.is_kiosk ? "a kiosk begins each lesson at its first step."
                                                            : "no lesson is named; add lesson= and the name of one."));
  }
  if (!address.embedder.empty() && !is_origin(address.embedder)) {
    address.problems.push_back(
        fmt::format("'embed={0}' in the address of this page cannot be used: '{0}' is not the origin of a page; give "
                    "scheme and host alone, as in https://course.example.org, and a port where it is not the usual one",
                    quoted_text(std::exchange(address.embedder, {}))));
  }
  return address;
}

std::string without_percent_signs(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    constexpr int hexadecimal = 16;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto byte = digits.size() == 2 ? number_in<std::uint8_t>(digits, hexadecimal) : std::nullopt;
    if (!byte) {
      refuse_part(fmt::format("two hexadecimal digits have to follow the % of '{}'; a percent sign itself is %25",
                              quoted_text(text.substr(i, 3))));
    }
    plain += static_cast<char>(*byte);
    i += 2;
  }
  return plain;
}

}  // namespace ghostforce
