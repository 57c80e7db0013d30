#include "app/state/kiosk_visit.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"

namespace ghostforce {
namespace {

// A handle that nobody holds trembles less.
constexpr double least_move = 0.002;  // [m]
// A handle sinks once its motors are off, and a window that has just appeared finds a pointer over it.
constexpr double settles_s = 2.0;

void show_first_step(Session& session) {
  begin_lesson(session, session.kiosk_visit->lessons.front());
  show_lesson_step(session, 0);
}

void start_again(Session& session) {
  KioskVisit& visit = *session.kiosk_visit;
  visit = {
      .lessons = std::move(visit.lessons), .language = std::move(visit.language), .departures = visit.departures + 1};
  leave_lesson(session);
  session.lesson_progress = {};
  session.language = visit.language;
  show_first_step(session);
  ++session.restarts_asked;
}

bool has_hand(KioskVisit& visit, const SignsOfLife& signs) {
  const bool is_settling = visit.since_start_s < settles_s;
  const bool is_elsewhere = signs.handle && (!visit.handle || glm::distance(*signs.handle, *visit.handle) > least_move);
  const bool has_moved = is_elsewhere && visit.handle;
  if (is_elsewhere || is_settling) visit.handle = signs.handle;
  return signs.has_acted || (!is_settling && (signs.has_pointed || has_moved));
}

}  // namespace

void begin_kiosk_visit(Session& session, std::vector<std::shared_ptr<const Lesson>> lessons) {
  session.kiosk_visit = KioskVisit{.lessons = std::move(lessons), .language = session.language};
  show_first_step(session);
}

void follow_kiosk_visit(Session& session, const SignsOfLife& signs, double interval_s) {
  if (!session.kiosk_visit) return;
  KioskVisit& visit = *session.kiosk_visit;
  visit.since_start_s += interval_s;
  if (has_hand(visit, signs)) {
    visit.has_visitor = true;
    visit.untouched_s = 0.0;
    return;
  }
  visit.untouched_s += interval_s;
  if (visit.has_visitor && visit.untouched_s >= kiosk_visit_ends_after_s) start_again(session);
}

bool invites_visitors(const Session& session) noexcept {
  return session.kiosk_visit && !session.kiosk_visit->has_visitor && session.lesson &&
         lesson_step(*session.lesson).question == LessonQuestion::none && is_allowed(session, LessonControl::hand);
}

std::string_view next_language(const Session& session) {
  const Lesson& lesson = *session.lesson->lesson;
  const auto& languages = lesson.words;
  if (languages.size() < 2) return {};
  const LessonWords* const shown = &words_in(lesson, session.language);
  const auto present = std::ranges::find_if(languages, [&](const auto& entry) { return &entry.second == shown; });
  const auto next = std::next(present);
  return (next == languages.end() ? languages.begin() : next)->first;
}

void switch_to_next_language(Session& session) {
  if (!session.lesson) return;
  if (const std::string language(next_language(session)); !language.empty()) session.language = language;
}

}  // namespace ghostforce
