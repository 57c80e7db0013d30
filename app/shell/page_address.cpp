#include "app/shell/page_address.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <set>
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

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

// As a browser writes it: without zeros before it.
template <typename Number, typename... Base>
std::optional<Number> plain_number_in(std::string_view text, Base... base) {
  return text.starts_with('0') && text.size() > 1 ? std::nullopt : number_in<Number>(text, base...);
}

// A name, or four numbers.
bool is_named_host(std::string_view host) {
  std::vector<std::string_view> labels;
  while (!host.empty()) labels.push_back(take_until(host, '.'));
  const auto is_label = [](std::string_view label) {
    return !label.empty() && std::ranges::all_of(label, [](char c) {
      return (c >= 'a' && c <= 'z') || is_digit(c) || c == '-' || c == '_';
    });
  };
  if (labels.empty() || !std::ranges::all_of(labels, is_label)) return false;
  if (!is_digit(labels.back().front())) return true;
  const auto is_byte = [](std::string_view label) { return plain_number_in<std::uint8_t>(label).has_value(); };
  return labels.size() == 4 && std::ranges::all_of(labels, is_byte);
}

// How many groups of up to four hexadecimal digits, with colons between them; -1: something else.
int groups_of(std::string_view text) {
  constexpr int hexadecimal = 16;
  if (text.ends_with(':')) return -1;
  int count = 0;
  for (; !text.empty(); ++count) {
    const std::string_view group = take_until(text, ':');
    if (!plain_number_in<std::uint16_t>(group, hexadecimal)) return -1;
  }
  return count;
}

// Without its brackets.
bool is_ipv6(std::string_view host) {
  const std::size_t gap = host.find("::");
  if (gap == std::string_view::npos) return groups_of(host) == 8;
  const int before = groups_of(host.substr(0, gap));
  const int after = groups_of(host.substr(gap + 2));
  return before >= 0 && after >= 0 && before + after < 8;
}

// As browsers write the origin of a page: without a path, and without the port that its scheme has anyway. To anything
// else a browser sends no message, or throws.
bool is_origin(std::string_view value) {
  struct Scheme {
    std::string_view words;
    std::uint16_t port;
  };
  constexpr std::array schemes{Scheme{"https://", 443}, Scheme{"http://", 80}};
  const auto* const scheme =
      std::ranges::find_if(schemes, [&](const Scheme& each) { return value.starts_with(each.words); });
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (scheme == schemes.end() || std::ranges::any_of(value, is_capital)) return false;
  value.remove_prefix(scheme->words.size());
  const std::size_t end = value.starts_with('[') ? std::min(value.find(']'), value.size() - 1) + 1 : value.find(':');
  const std::string_view host = value.substr(0, end);
  const bool has_brackets = host.starts_with('[') && host.ends_with(']') && host.size() > 2;
  if (!(has_brackets ? is_ipv6(host.substr(1, host.size() - 2)) : is_named_host(host))) return false;
  if (host.size() == value.size()) return true;
  if (value[host.size()] != ':') return false;
  const auto port = plain_number_in<std::uint16_t>(value.substr(host.size() + 1));
  return port && *port != 0 && *port != scheme->port;
}

std::string read_embedder(std::string value) {
  if (!is_origin(value)) {
    refuse_part(
        fmt::format("'{}' is not the origin of a page; give scheme and host alone, as in https://course.example.org, "
                    "and a port where it is not the usual one",
                    quoted_text(value)));
  }
  return value;
}

const std::vector<Wish>& wishes() {
  static const std::vector<Wish> all{
      {"lesson", "the name of a lesson", [](std::string value, PageAddress& into) { into.lesson = std::move(value); }},
      {"language", "en or es",
       [](std::string value, PageAddress& into) { into.language = read_wanted_language(std::move(value)); }},
      {"kiosk", "", [](const std::string&, PageAddress& into) { into.is_kiosk = true; }},
      {"reset", "", [](const std::string&, PageAddress& into) { into.is_for_new_person = true; }},
      {"fit", "", [](const std::string&, PageAddress& into) { into.fits = true; }},
      {"embed", "the origin of the page around this one",
       [](std::string value, PageAddress& into) { into.embedder = read_embedder(std::move(value)); }},
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

PageAddress read_page_address(std::string_view query) {
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
