// Lesson: a session that teaches itself: steps on the stage, each with a text, perhaps a question, and a check that the
// program makes. A value, read from one file (lesson_file.h) and never changed; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/state/set_up.h"
#include "core/scene.h"

namespace ghostforce {

// What a person can change on the stage while a step is shown. Nothing else can be changed then.
enum class LessonControl : std::uint8_t { hand, strategies, wall, motor };

// What a picture keeps back until the question is answered.
enum class LessonSecret : std::uint8_t { numbers, force, slide, rest };

// What the small picture of a lesson shows large: all of the stage, or a part of it.
enum class LessonSubject : std::uint8_t { everything, handle, hand, forces, ghost_force, slide, loop };

// A quantity that a task can be about, of the moment that is shown; see the catalog in lesson_quantities.h.
enum class LessonQuantity : std::uint8_t {
  depth,             // of the hand in the wall [mm]
  force,             // [N]
  ghost_force,       // its magnitude [N]
  slide,             // the proxy drift's magnitude [mm]
  handle_to_target,  // from the handle to where it would rest without a ghost force [mm]
  angle,             // between the wall's normal and the motor's axis, 0 to 90 [deg]
  energy,            // that the rendering gave to the hand in the newest turn of the circle [mJ]
  turns,             // of the circle, completed
  belief,            // believed hand stiffness over the hand's true one
  hand,              // how stiff the hand is, as it was measured in this step [N/m]
  effort,            // of the motor that works hardest, its magnitude [N, or N·m where motors turn joints]
  slack_strings,     // of a handle on strings: how many pull nothing
  active_walls,      // how many hold the proxy
};

// Met while the quantity lies between these, both ends included, in its unit.
struct LessonCondition {
  LessonQuantity quantity{};
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

// None: only a text. Choose: one of some answers is right. Guess: where the handle will come to rest. Task: to be done
// until the program sees that it is.
enum class LessonQuestion : std::uint8_t { none, choose, guess, task };

// A control of its own for one number of the scene.
struct LessonSlider {
  const SceneKey* key = nullptr;
  double least = 0.0;  // [the file's unit]
  double greatest = 1.0;
};

struct LessonStep {
  std::string name;
  std::shared_ptr<const SetUp> set_up;  // null: goes on with what is there
  std::set<LessonControl> controls;
  std::optional<LessonSlider> slider;
  LessonQuestion question = LessonQuestion::none;
  std::set<LessonSecret> secrets;           // while the question is open
  std::size_t right_answer = 0;             // of a choice, from 0
  double within = 0.0;                      // of a guess [m]
  std::vector<LessonCondition> conditions;  // of a task, all of them at once,
  std::optional<StrategyId> with;           // and with this strategy
  std::shared_ptr<const SetUp> reveal;      // once it is answered; null: what is there stays
};

// What a step says in one language. Texts may be empty where nothing is said.
struct LessonStepWords {
  std::string text;
  std::vector<std::string> answers;  // of a choice
  std::string right;                 // after a right answer, a good guess, a task that is done
  std::string wrong;                 // after another
};

struct LessonWords {
  std::string title;
  std::string about;
  std::vector<LessonStepWords> steps;  // as many as the lesson has
};

struct Lesson {
  std::string name;         // the file's, without .toml
  std::string file;         // as a person has named it; empty: the lesson comes with the program
  std::string path;         // of that file: absolute, and printable
  double number = 0;        // its place among others
  std::size_t picture = 0;  // the step that is shown for it, from 0
  LessonSubject picture_of = LessonSubject::everything;  // what of it is shown
  std::set<LessonSecret> secrets;                        // in all of its steps, whether or not a question is open
  std::vector<LessonStep> steps;                         // one at least
  std::map<std::string, LessonWords> words;              // by language, "en", "es" …; English or one other at least
};

}  // namespace ghostforce
