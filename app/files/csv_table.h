// CsvTable: columns and rows of numbers and words, with comment lines that say where they come from; and its text.
// Numbers stand in the shortest form that reads back exactly, whatever the locale. Pure, any thread.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace ghostforce {

using CsvCell = std::variant<double, std::string>;

struct CsvTable {
  std::vector<std::string> comments;  // one line each, without "# "
  std::vector<std::string> columns;   // names, with their units
  std::vector<std::vector<CsvCell>> rows;
};

// The comments, one line of names, the rows. A number that is none reads nan or inf; words are quoted where commas,
// quotes or blanks at their ends would be taken for something else; line breaks become blanks.
std::string csv_text(const CsvTable& table);

}  // namespace ghostforce
