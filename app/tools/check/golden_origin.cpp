#include "app/tools/check/golden_origin.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/toml_document.h"
#include "app/files/toml_parse.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr std::string_view table_name = "golden";

std::string_view after(std::string_view text, std::string_view piece) {
  const std::size_t at = text.find(piece);
  return at == std::string_view::npos ? std::string_view{} : text.substr(at + piece.size());
}

// "llvmpipe (LLVM 15.0.6, 256 bits)" -> "llvmpipe (LLVM 15.0.6)"
std::string without_vector_width(std::string_view renderer) {
  constexpr std::string_view end = " bits)";
  const std::size_t comma = renderer.rfind(", ");
  if (comma == std::string_view::npos || !renderer.ends_with(end)) return std::string(renderer);
  const std::string_view width = renderer.substr(comma + 2, renderer.size() - end.size() - comma - 2);
  const bool is_number = !width.empty() && width.find_first_not_of("0123456789") == std::string_view::npos;
  return is_number ? fmt::format("{})", renderer.substr(0, comma)) : std::string(renderer);
}

// Where toml++ counts to: lines by newlines, columns by characters of UTF-8.
std::size_t offset_of(const std::string& text, toml::source_position position) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (toml::source_index line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
  const auto continues = [&](std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
  };
  for (toml::source_index column = 1; column < position.column && at < text.size(); ++column) {
    ++at;
    while (continues(at)) ++at;
  }
  return at;
}

std::array<std::pair<std::string_view, std::string_view>, 3> entries_of(const GoldenOrigin& origin) {
  return {{{"renderer", origin.renderer}, {"mesa", origin.mesa}, {"version", origin.version}}};
}

// The table as it is asked for, and all else equal.
bool is_as_wanted(const toml::table& before, const std::string& text, const GoldenOrigin& origin) {
  const ParsedToml parsed = parse_toml(text);
  if (parsed.problem) return false;
  toml::table wanted = before;
  wanted.insert_or_assign(table_name, toml::table{});
  for (const auto& [name, value] : entries_of(origin)) wanted[table_name].as_table()->insert_or_assign(name, value);
  return parsed.table == wanted;
}

}  // namespace

GoldenOrigin present_origin(std::string_view graphics) {
  constexpr std::string_view opengl = ", OpenGL ";
  const std::string_view mesa = after(graphics, " Mesa ");
  return {without_vector_width(graphics.substr(0, graphics.find(opengl))), std::string(mesa.substr(0, mesa.find(' '))),
          std::string(version)};
}

std::string other_renderer_words(const GoldenOrigin& golden, const GoldenOrigin& present) {
  const auto differ = [](const std::string& a, const std::string& b) { return !a.empty() && !b.empty() && a != b; };
  if (!differ(golden.renderer, present.renderer) && !differ(golden.mesa, present.mesa)) return "";
  const auto words = [](const GoldenOrigin& origin) {
    if (origin.renderer.empty()) return fmt::format("Mesa {}", origin.mesa);
    return origin.mesa.empty() ? origin.renderer : fmt::format("{}, Mesa {}", origin.renderer, origin.mesa);
  };
  return fmt::format("the cause may be another renderer: the golden was drawn by {}, this picture by {}",
                     quoted_text(words(golden), longest_path), quoted_text(words(present), longest_path));
}

std::string other_origin_words(const GoldenOrigin& golden, const GoldenOrigin& present) {
  const std::string words = other_renderer_words(golden, present);
  if (!words.empty() || golden.version.empty() || golden.version == present.version) return words;
  return fmt::format(
      "the cause may be another version of this program: the golden was drawn by version {}, this picture by {}",
      quoted_text(golden.version), present.version);
}

std::string with_origin(const std::string& case_text, const GoldenOrigin& origin, std::string_view shown_path) {
  const toml::table before = parse_toml(case_text).table;
  const std::string newline = case_text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  std::string text = case_text;
  std::string absent;  // lines that are not there yet
  const toml::table* const table = before[table_name].as_table();
  std::vector<std::pair<const toml::node*, std::string>> values;
  for (const auto& [name, value] : entries_of(origin)) {
    if (const toml::node* const node = table == nullptr ? nullptr : table->get(name)) {
      values.emplace_back(node, toml_string(value));
    } else {
      absent += fmt::format("{} = {}{}", name, toml_string(value), newline);
    }
  }
  // From the end of the file, so that places before it stay what they are.
  const auto begin_of = [](const auto& entry) { return entry.first->source().begin; };
  std::ranges::sort(
      values, [](const auto& a, const auto& b) { return b < a; }, begin_of);
  for (const auto& [node, value] : values) {
    const std::size_t begin = offset_of(case_text, node->source().begin);
    text.replace(begin, offset_of(case_text, node->source().end) - begin, value);
  }
  if (table == nullptr) {
    if (!text.empty() && !text.ends_with('\n')) text += newline;
    text += fmt::format("{}[{}]{}{}", newline, table_name, newline, absent);
  } else if (!absent.empty()) {
    // The header stands before every value of its table.
    const std::size_t end_of_header = text.find('\n', offset_of(case_text, table->source().begin));
    if (end_of_header == std::string::npos) {
      text += newline + absent;
    } else {
      text.insert(end_of_header + 1, absent);
    }
  }
  if (is_as_wanted(before, text, origin)) return text;
  throw Failure(ExitCode::wrong_call, fmt::format("{}: its table [golden] is written in a form that --update cannot "
                                                  "change; remove it, and --update will write a new one",
                                                  quoted_text(shown_path, longest_path)));
}

}  // namespace ghostforce
