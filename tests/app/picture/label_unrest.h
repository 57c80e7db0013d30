// How restless the words of pictures that follow one another are: told from the marks alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/app/picture/picture_extents.h"

namespace ghostforce {

// Two labels of two pictures are the same one: its role, and its words without the numbers in them.
inline std::string name_of(const LabelExtent& label) {
  std::string name = fmt::format("{} ", role_name(label.role));
  if (label.role == Role::number) return name;
  if (label.role == Role::motor_axis) return name;  // "left and right" turns into an angle
  for (const char letter : label.words) {
    if (letter != '.' && (letter < '0' || letter > '9')) name += letter;
  }
  return name;
}

inline bool stands_still_by_itself(Role role) {
  return role == Role::sentence || role == Role::button || role == Role::hint || role == Role::scale;
}

struct Words {
  ScreenBox box;  // of all lines
  double alpha = 0.0;
  Role role{};
};

// What was seen of one frame.
struct Seen {
  std::map<std::string, Words> words;
  PictureExtents extents;

  Seen(const Pane& pane, const MeasureText& measure, double text_scale) : extents(pane, measure, text_scale) {
    const LabelExtent* above = nullptr;
    std::string key;
    for (const LabelExtent& label : extents.labels) {
      if (stands_still_by_itself(label.role) || label.alpha == 0.0) continue;
      // A line below another belongs to it.
      const bool goes_on = above != nullptr && above->mark + 1 == label.mark && above->role == label.role &&
                           label.role != Role::number && std::abs(label.box.least.y - above->box.most.y) < 0.01;
      if (goes_on) {
        words[key].box.include(label.box.least);
        words[key].box.include(label.box.most);
      } else {
        key = name_of(label);
        // The numbers are a block; the first of it stands for all.
        if (label.role == Role::number && words.contains(key)) {
          words[key].box.include(label.box.least);
          words[key].box.include(label.box.most);
          continue;
        }
        words[key] = {label.box, label.alpha, label.role};
      }
      above = &label;
    }
  }

  // What a label's thing has moved by since then [points].
  double moved(Role role, const Seen& before) const {
    if (role == Role::number) return 0.0;
    double most = 0.0;
    std::size_t i = 0;
    for (const Extent& mark : extents.marks) {
      if (mark.role != role) continue;
      while (i < before.extents.marks.size() && before.extents.marks[i].role != role) ++i;
      if (i == before.extents.marks.size()) return most;
      const std::vector<Vector<2>>& was = before.extents.marks[i++].corners;
      for (std::size_t corner = 0; corner < std::min(was.size(), mark.corners.size()); ++corner) {
        most = std::max(most, glm::distance(was[corner], mark.corners[corner]));
      }
    }
    return most;
  }
};

// How often a label changed its place, or came and went.
struct Unrest {
  std::map<std::string, int> changes;
  int jumps = 0;

  int most() const {
    int found = 0;
    for (const auto& [name, count] : changes) found = std::max(found, count);
    return found;
  }
  int sum() const {
    int found = 0;
    for (const auto& [name, count] : changes) found += count;
    return found;
  }
  std::string words() const {
    std::string all;
    for (const auto& [name, count] : changes) all += fmt::format("  {}: {}\n", name, count);
    return all;
  }
};

// What changed from one picture to the next. `bound`: words are as wide as their numbers, and letters stand on whole
// points.
inline void add_unrest(const Seen& before, const Seen& now, double bound, const std::string& where, Unrest& unrest) {
  for (const auto& [name, words] : now.words) {
    const auto was = before.words.find(name);
    if (was == before.words.end()) {
      ++unrest.changes[name];
      EXPECT_LE(words.alpha, 0.2) << name << " is there at once at " << where;
      continue;
    }
    const Vector<2> grown = words.box.extent() - was->second.box.extent();
    const double moved = std::max(glm::distance(words.box.least, was->second.box.least),
                                  glm::distance(words.box.most, was->second.box.most));
    const double allowed = now.moved(words.role, before) + glm::length(grown) + bound;
    if (moved <= allowed) continue;
    if (++unrest.jumps <= 10) {
      ADD_FAILURE() << name << " moves by " << moved << ", " << allowed << " allowed, at " << where;
    }
  }
}

}  // namespace ghostforce
