// What those tests share that let somebody do whatever there is, in any order: how long, and what must stay true.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "app/picture/marks.h"
#include "tests/support/long_run.h"

namespace ghostforce {

inline int number_from_environment(const char* name, int otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::stoi(text);
}

// How long one goes on: as often as the variable `name` says, else as usual.
inline int length_of_run(const char* name, int usual) {
  return number_from_environment(name, trials(usual));
}

// A word that C prints for what is no number; empty: there is none.
inline std::string_view no_number_in(std::string_view text) {
  for (const std::string_view word : {"nan", "inf"}) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const auto is_letter = [&](std::size_t i) {
        return i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) || (text[i] & 0x80) != 0);
      };
      if (!is_letter(at + word.size()) && (at == 0 || !is_letter(at - 1))) {
        const std::size_t begin = at < 40 ? 0 : at - 40;
        return text.substr(begin, at + word.size() - begin);
      }
    }
  }
  return {};
}

// Of a mark: it is somewhere, and says no number that is none.
struct IsSound {
  static bool at(const Vector<2>& place) { return std::isfinite(place.x) && std::isfinite(place.y); }
  bool operator()(const HalfPlane& plane) const { return at(plane.point) && at(plane.normal); }
  bool operator()(const Line& line) const { return at(line.from) && at(line.to) && std::isfinite(line.pattern_start); }
  bool operator()(const Marker& marker) const { return at(marker.center) && at(marker.offset); }
  bool operator()(const Arrow& arrow) const { return at(arrow.tail) && at(arrow.tip); }
  bool operator()(const Box& box) const { return at(box.corner) && at(box.size) && at(box.offset); }
  bool operator()(const Area& area) const { return std::ranges::all_of(area.corners, at); }
  bool operator()(const Raster& raster) const { return at(raster.corner) && at(raster.size); }
  bool operator()(const Label& label) const {
    return at(label.anchor) && at(label.offset) && no_number_in(label.text).empty();
  }
};

}  // namespace ghostforce
