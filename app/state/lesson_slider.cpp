#include "app/state/lesson_slider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/files/scene_keys.h"
#include "app/picture/number_text.h"

namespace ghostforce {
namespace {

using SliderTexts = StageLanguage::Lessons;

struct SliderWords {
  std::string_view key;
  std::string_view SliderTexts::*words;
};
constexpr std::array words_of_keys{
    SliderWords{"user.k_u_N_per_m", &SliderTexts::k_u},
    SliderWords{"user.believed_k_u_N_per_m", &SliderTexts::believed_k_u},
    SliderWords{"rendering.k_r_N_per_m", &SliderTexts::k_r},
    SliderWords{"rendering.tracking_ratio", &SliderTexts::tracking_ratio},
    SliderWords{"wall.normal_deg", &SliderTexts::wall_angle},
    SliderWords{"device.actuated_deg", &SliderTexts::motor_angle},
};

bool is_long_range(const LessonSlider& slider) {
  return slider.least > 0.0 && slider.greatest >= 8.0 * slider.least;
}

}  // namespace

std::optional<double> slider_value(const LessonSlider& slider, const Settings& settings) {
  Scene scene;
  scene.settings = settings;
  if (const auto* const number = std::get_if<NumberKey>(&slider.key->value)) return number->in(scene)*number->per_si;
  if (const auto* const optional = std::get_if<OptionalNumberKey>(&slider.key->value)) return optional->in(scene);
  return std::nullopt;
}

Settings with_slider_value(const LessonSlider& slider, const Settings& settings, double value) {
  Scene scene;
  scene.settings = settings;
  const double inside = std::clamp(value, slider.least, slider.greatest);
  if (const auto* const number = std::get_if<NumberKey>(&slider.key->value)) {
    number->in(scene) = inside / number->per_si;
  } else if (const auto* const optional = std::get_if<OptionalNumberKey>(&slider.key->value)) {
    optional->in(scene) = inside;
  }
  return scene.settings;
}

double slider_share(const LessonSlider& slider, double value) noexcept {
  const double inside = std::clamp(value, slider.least, slider.greatest);
  if (is_long_range(slider)) return std::log(inside / slider.least) / std::log(slider.greatest / slider.least);
  return (inside - slider.least) / (slider.greatest - slider.least);
}

double slider_value_at(const LessonSlider& slider, double share) noexcept {
  const double inside = std::clamp(share, 0.0, 1.0);
  if (inside == 1.0) return slider.greatest;
  if (is_long_range(slider)) return slider.least * std::pow(slider.greatest / slider.least, inside);
  return slider.least + inside * (slider.greatest - slider.least);
}

std::string slider_words(const LessonSlider& slider, const StageLanguage& language) {
  const std::string key = dotted_name(*slider.key);
  const auto* const found = std::ranges::find(words_of_keys, key, &SliderWords::key);
  return found == words_of_keys.end() ? key : std::string(language.lessons.*found->words);
}

std::string slider_text(const LessonSlider& slider, double value) {
  const double size = std::max({std::abs(slider.least), std::abs(slider.greatest)});
  const int decimals = size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
  const std::string_view unit = unit_of(slider.key->name);
  const std::string number = decimal_text(value, decimals);
  return unit.empty() ? number : number + " " + std::string(unit);
}

}  // namespace ghostforce
