#include "app/stage/landscape_words.h"

namespace ghostforce {
namespace {

std::vector<std::string> pieces_of(std::string_view words, char separator) {
  std::vector<std::string> pieces(1);
  for (const char letter : words) {
    letter == separator ? void(pieces.emplace_back()) : pieces.back().push_back(letter);
  }
  return pieces;
}

}  // namespace

LineBreaks line_breaks_of(std::string_view words) {
  LineBreaks ways;
  for (const std::string& way : pieces_of(words, '|')) ways.push_back(pieces_of(way, '\n'));
  return ways;
}

const std::vector<std::string>& LandscapeWords::way_that_fits(const LineBreaks& ways, double room) const {
  const auto fits = [&](const std::vector<std::string>& lines) {
    return std::ranges::all_of(lines, [&](const std::string& line) { return extent(line, style(1.0)).x <= room; });
  };
  const auto found = std::ranges::find_if(ways, fits);
  return found == ways.end() ? ways.back() : *found;
}

double LandscapeWords::put_lines(Role role, const LineBreaks& ways, Colour colour, const Vector<2>& place, double room,
                                 double across) {
  double top = place.y;
  for (const std::string& line : way_that_fits(ways, room)) {
    put(role, line, fitted(line, style(1.0), room), colour, {place.x, top}, {across, 0.0});
    top += line_height * layout_.em;
  }
  return top;
}

double LandscapeWords::height_of_lines(const LineBreaks& ways, double room) const {
  return static_cast<double>(way_that_fits(ways, room).size()) * line_height * layout_.em;
}

}  // namespace ghostforce
