// The words of the stage that depend on the moment: the one sentence, which is true of what is shown, and the numbers.
// Pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/state/stage_language.h"
#include "app/state/stage_moment.h"

namespace ghostforce {

// Who the words are for.
struct StageAudience {
  bool can_drag = true;                      // the hand follows the pointer
  bool sees_show = false;                    // the stage shows the slide by itself
  bool looks_back = false;                   // an earlier moment is shown
  bool feels_tones = false;                  // they sound in the motor, to measure the hand
  StrategyId heads_for = StrategyId::naive;  // of a moment between two strategies
};

std::string stage_sentence(const Settings& settings, const StageMoment& moment, const StageAudience& audience,
                           const StageLanguage& language);

// That a strategy with one motor comes to no rest.
inline std::string no_rest_sentence(StrategyId id, const StageLanguage& language) {
  return std::string(id == StrategyId::naive ? language.sentences.no_rest : language.sentences.no_rest_for_cure);
}

// What is smaller is shown as nothing, and called so.
inline constexpr double least_shown_force = 0.005;  // [N]
// Less hardly drags the handle, whichever way it points.
inline constexpr double least_dragging_force = 0.05;  // [N]
inline constexpr double least_shown_slide = 0.00005;  // [m]

// What the moment comes to. Empty: it cannot be known.
struct StageNumbers {
  std::optional<double> force{};        // of the motor, along it [N]
  std::optional<double> wall_share{};   // of that force [N]
  std::optional<double> ghost_force{};  // the rest of it; negative: the motor pushes too little [N]
  std::optional<double> slide{};        // along the wall, without a sign [m]
};
StageNumbers stage_numbers(const StageMoment& moment) noexcept;

// What the ghost force's number is called, which has no sign; it may be unknown [N].
std::string_view words_of_ghost_force(const std::optional<double>& newton,
                                      const StageLanguage::Numbers& words) noexcept;

// A size with its sign left out, three digits wide at all sizes: "1.27", "12.7", "127".
std::string force_number(double newton);
std::string slide_number(double metres);

// "left and right", "up and down", or "along its rail", for those who see it.
std::string rail_words(double actuated_angle, const StageLanguage& language);
// "left and right", "up and down", or "at 30°, counted from the right", for those who do not.
std::string motor_direction_words(double actuated_angle, const StageLanguage& language);
// The nearest of eight: "upwards", "up and to the right".
std::string force_direction_words(const Vector<2>& force, const StageLanguage& language);

}  // namespace ghostforce
