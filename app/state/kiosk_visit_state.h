// KioskVisit: the visitor's mode, in which lessons follow one another in a loop for whoever comes along. Part of the
// session; visit.h is what changes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/state/lesson.h"
#include "core/conventions.h"

namespace ghostforce {

struct KioskVisit {
  std::vector<std::shared_ptr<const Lesson>> lessons;  // one at least
  std::string language;                                // with which each visit begins
  std::size_t lesson = 0;                              // of the lessons, the one that is shown
  bool has_visitor = false;                            // somebody has touched something since the start
  double untouched_s = 0.0;                            // since somebody last did
  double since_start_s = 0.0;
  std::optional<Vector<2>> handle{};  // of a device, where it was when somebody last moved it [m]
  std::uint32_t departures = 0;       // of visitors, since the program began

  // After the last one comes the first.
  const std::shared_ptr<const Lesson>& take_next_lesson() {
    lesson = (lesson + 1) % lessons.size();
    return lessons[lesson];
  }
};

}  // namespace ghostforce
