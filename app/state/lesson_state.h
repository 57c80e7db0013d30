// LessonState: where a person is in a lesson, what they have answered, and what they had on the screen before. Part of the
// session; lesson_guide.h is what changes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/state/belief_source.h"
#include "app/state/face.h"
#include "app/state/lesson.h"
#include "core/scene.h"

namespace ghostforce {

// Of a step's question. Shown: the answer was given away, without a score.
enum class LessonOutcome : std::uint8_t { open, right, wrong, shown };

struct LessonStepState {
  LessonOutcome outcome = LessonOutcome::open;
  std::optional<std::size_t> chosen{};  // of the answers, from 0
  std::optional<Vector<2>> guess{};     // of where the handle comes to rest [m]
  std::optional<double> missed_by{};    // its distance from there [m]

  friend bool operator==(const LessonStepState&, const LessonStepState&) = default;
};

struct LessonState {
  // The hand on its way to where a step wants it.
  struct Glide {
    Vector<2> from{0.0};  // [m]
    Vector<2> to{0.0};
    Vector<2> last{0.0};  // where it has put the hand; a hand that is elsewhere has been taken hold of
    double elapsed_s = 0.0;
  };
  // What comes back when the lesson ends.
  struct Before {
    Settings settings;
    Vector<2> goal{0.0};
    SceneView stage_shown;
    Face face = Face::stage;
    double speed = 1.0;
    BeliefSource belief_source = BeliefSource::typed;
  };

  std::shared_ptr<const Lesson> lesson;  // never null
  std::size_t step = 0;                  // of the lesson's, from 0
  std::size_t furthest = 0;              // that was ever shown
  std::vector<LessonStepState> steps;    // as many as the lesson has
  bool is_finished = false;              // the person has gone on from the last step
  std::optional<Glide> glide{};
  double met_s = 0.0;  // for so long the conditions of the task have been met
  Before before{};
};

}  // namespace ghostforce
