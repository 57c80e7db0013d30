// The guide through a lesson: what buttons, keys and time do to it. What a step does not allow cannot be done. All is a
// function of the session and of the intervals that are handed in; UI thread.
#pragma once

#include <memory>

#include "app/state/lesson_quantities.h"
#include "app/state/session.h"

namespace ghostforce {

// Shows the first step on the stage. What the person had is kept and comes back at the end.
void begin_lesson(Session& session, std::shared_ptr<const Lesson> lesson);
// Settings, hand, view and face are again as they were before the lesson. Does nothing where there is none.
void leave_lesson(Session& session);
// The same, but for what is on the screen: another scene takes its place.
void abandon_lesson(Session& session);

// Goes on: a question that is still open is answered for the person, without a score; else the next step is shown.
// After the last one the lesson is finished, and the picker of lessons opens, or a visitor's next lesson begins.
void next_lesson_step(Session& session);
// Back to the step before, as it was last stated; before the first nothing happens.
void previous_lesson_step(Session& session);
// The step that is shown, as it was last stated; what was answered stays so.
void begin_lesson_step_anew(Session& session);
// A step and what is on the stage in it, at once and with nothing before it answered: for pictures.
void show_lesson_step(Session& session, std::size_t step);
// Answers the step's question for a picture, at once: a choice with that answer; a guess or a task rightly with 0, else
// wrongly.
void settle_in_lesson(Session& session, std::size_t answer);
// What Enter means: the answer to a guess, else to go on.
void confirm_in_lesson(Session& session);

// A choice, from 0; only while the question is open, and only one that there is.
void answer_in_lesson(Session& session, std::size_t answer);
// The ring is where the person thinks that the handle comes to rest.
void guess_in_lesson(Session& session);
// Gives the answer to the step's question away.
void show_answer_in_lesson(Session& session);

// Of the file's unit; what lies beyond its ends becomes the nearer end. Nothing happens in a step without a slider.
void move_lesson_slider(Session& session, double value);
// By so many hundredths of its length.
void nudge_lesson_slider(Session& session, double hundredths);

// Once a frame: the hand glides on, and a task is looked at. A task is done when its conditions have been met for a
// moment while nothing glides, so that nobody solves it in passing.
void follow_lesson(Session& session, const LessonReading& reading, double interval_s);

// Without a lesson everything is allowed, and nothing is hidden.
bool is_allowed(const Session& session, LessonControl control) noexcept;
bool is_hidden(const Session& session, LessonSecret secret) noexcept;
bool has_open_question(const Session& session, LessonQuestion question) noexcept;

// Of the shipped lessons, the number of the one to go on with: the next that is not done after the one that was gone
// through last, and the first of these after the last one; where all are done, the one that follows.
std::size_t lesson_to_go_on_with(const Session& session);

// The mode of the stage in which that step begins.
StageMode mode_of_step(const Lesson& lesson, std::size_t step) noexcept;

// Of the step that is shown; only in a lesson.
const LessonStep& lesson_step(const LessonState& lesson) noexcept;
const LessonStepState& lesson_step_state(const LessonState& lesson) noexcept;

// What of the world the stage shows when it shows everything. In a step of a lesson its hand, before and after the
// question is answered: the picture stands still.
SceneView stage_view_of(const Session& session);
// Whose arrow has the usual length: in a lesson the strongest push of all of it, so that arrows of its steps can be
// compared [N].
double reference_force_of(const Session& session);

}  // namespace ghostforce
