// The visitor's mode: lessons in a loop, back to the very start when nobody is there any more, and no way to anything
// else. Time comes in as intervals. UI thread.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/state/session.h"

namespace ghostforce {

inline constexpr double kiosk_visit_ends_after_s = 90.0;  // without a hand

// What the session shows comes back at each start. `lessons`: one at least, in their order.
void begin_kiosk_visit(Session& session, std::vector<std::shared_ptr<const Lesson>> lessons);

// A hand somewhere.
struct SignsOfLife {
  bool has_acted = false;    // with keys, buttons, the wheel
  bool has_pointed = false;  // the pointer moved
  std::optional<Vector<2>>
      handle{};  // of a device that a person holds; empty: there is none, or nobody knows where [m]
};

// Often. Starts again, and has the motors turned off, when there has been no hand for kiosk_visit_ends_after_s. Does
// nothing in an ordinary run.
void follow_kiosk_visit(Session& session, const SignsOfLife& signs, double interval_s);

// Nobody has touched anything since the start, and the step that is shown lets the hand be moved without asking
// anything: the stage can show how, and gives nothing away.
bool invites_visitors(const Session& session) noexcept;

// The next language of the lesson that is shown, in a ring; empty: it has no other. Only in a lesson.
std::string_view next_language(const Session& session);
void switch_to_next_language(Session& session);

}  // namespace ghostforce
