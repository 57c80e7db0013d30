// `figures` called, and the tables that it writes read back. For tests.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/csv_table.h"
#include "app/tools/figures/figure.h"
#include "tests/support/program.h"

namespace ghostforce {

inline Outcome figures(std::vector<std::string> words) {
  words.insert(words.begin(), "figures");
  return run_ghostforce(std::move(words));
}

inline std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename());
  }
  return names;
}

// No cell of a figure's table needs quotes.
inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

inline double number(const std::string& text) {
  double value = -12345.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc{} && end == text.data() + text.size()) << text;
  return value;
}

struct ReadTable {
  std::vector<std::string> comments;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

inline ReadTable read_table(const std::string& text) {
  ReadTable table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) {
      table.comments.push_back(line);
    } else if (table.columns.empty()) {
      table.columns = cells_of(line);
    } else {
      table.rows.push_back(cells_of(line));
    }
  }
  return table;
}

inline const FigureEntry& entry_named(std::string_view name) {
  return *std::ranges::find(figure_catalog(), name, &FigureEntry::name);
}

inline std::size_t column(const CsvTable& table, std::string_view name) {
  const auto at = std::ranges::find(table.columns, name);
  EXPECT_NE(at, table.columns.end()) << name;
  return static_cast<std::size_t>(at - table.columns.begin());
}

}  // namespace ghostforce
