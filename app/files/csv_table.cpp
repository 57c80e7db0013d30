#include "app/files/csv_table.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace ghostforce {
namespace {

std::string in_one_line(std::string words) {
  std::ranges::replace_if(
      words, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return words;
}

std::string quoted_if_needed(std::string words, bool begins_row) {
  words = in_one_line(std::move(words));
  const bool has_blank_end = !words.empty() && (words.front() == ' ' || words.back() == ' ');
  const bool looks_like_comment = begins_row && words.starts_with('#');
  if (words.find_first_of(",\"") == std::string::npos && !has_blank_end && !looks_like_comment) return words;
  std::string quoted = "\"";
  for (const char c : words) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void append(fmt::memory_buffer& text, const CsvCell& cell, bool begins_row) {
  if (const auto* number = std::get_if<double>(&cell)) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{}"), *number);
  } else {
    const std::string words = quoted_if_needed(std::get<std::string>(cell), begins_row);
    text.append(words.data(), words.data() + words.size());
  }
}

}  // namespace

std::string csv_text(const CsvTable& table) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const std::string& comment : table.comments) fmt::format_to(out, FMT_COMPILE("# {}\n"), in_one_line(comment));
  const auto append_row = [&](const auto& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text.push_back(',');
      append(text, CsvCell(cells[i]), i == 0);
    }
    text.push_back('\n');
  };
  append_row(table.columns);
  for (const std::vector<CsvCell>& row : table.rows) append_row(row);
  return fmt::to_string(text);
}

}  // namespace ghostforce
