// The numbers of a lesson. The catalog of quantities that a task can be about: what each is called in files, and how it
// is read from what is shown; a new one is an identifier in lesson.h and a row here. And the slider of a step, whose
// values are in the file's unit. Pure, any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/state/lesson.h"
#include "app/state/stage_language.h"
#include "app/state/stage_moment.h"
#include "core/loop_energy.h"
#include "core/settings.h"

namespace ghostforce {

// What is on the stage while a task is open.
struct LessonReading {
  const StageMoment& moment;
  const Settings& settings;
  const CircleReading* circle = nullptr;  // null: the hand does not go round
  std::optional<double> hand_k_u{};       // as it was measured [N/m]; empty: it was not
};

struct LessonQuantityEntry {
  LessonQuantity id;
  std::string_view name;                          // in files, with its unit
  std::string_view sentence;                      // what it is
  double (*read)(const LessonReading&) noexcept;  // in the name's unit; NaN: nobody can know it now
};
std::span<const LessonQuantityEntry> lesson_quantity_catalog() noexcept;
const LessonQuantityEntry& lesson_quantity(LessonQuantity id) noexcept;

// By how much it is missed, in its unit; 0: it is met. NaN: it cannot be known.
double missed_by(const LessonCondition& condition, const LessonReading& reading) noexcept;

bool is_met(const LessonCondition& condition, const LessonReading& reading) noexcept;

// Whether all conditions of a task are met, with the strategy that it asks for.
bool is_done(const LessonStep& task, const LessonReading& reading) noexcept;

// The slider's number in the settings; empty: it is left to the program.
std::optional<double> slider_value(const LessonSlider& slider, const Settings& settings);
// The settings with another number. What lies beyond the slider's ends becomes the nearer end.
Settings with_slider_value(const LessonSlider& slider, const Settings& settings, double value);

// Where the knob stands along the slider's length, 0 to 1, and back. Long ranges of positive numbers go by their
// logarithm.
double slider_share(const LessonSlider& slider, double value) noexcept;
double slider_value_at(const LessonSlider& slider, double share) noexcept;

// What the number is, where the language has words for it.
std::string slider_words(const LessonSlider& slider, const StageLanguage& language);
// The number with its unit.
std::string slider_text(const LessonSlider& slider, double value);

}  // namespace ghostforce
