// The slider of a lesson's step: where its number is in the settings, where its knob stands, and what is said of it. Values
// are in the file's unit. Pure, any thread.
#pragma once

#include <optional>
#include <string>

#include "app/state/lesson.h"
#include "app/state/stage_language.h"
#include "core/settings.h"

namespace ghostforce {

// Empty: the number is left to the program.
std::optional<double> slider_value(const LessonSlider& slider, const Settings& settings);
// What lies beyond its ends becomes the nearer end.
Settings with_slider_value(const LessonSlider& slider, const Settings& settings, double value);

// Along its length, 0 to 1, and back. Long ranges of positive numbers go by their logarithm.
double slider_share(const LessonSlider& slider, double value) noexcept;
double slider_value_at(const LessonSlider& slider, double share) noexcept;

// What the number is, where the language has words for it.
std::string slider_words(const LessonSlider& slider, const StageLanguage& language);
// With its unit.
std::string slider_text(const LessonSlider& slider, double value);

}  // namespace ghostforce
