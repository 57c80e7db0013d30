// Predict: a ring to drag to where one thinks that the handle comes to rest. The answer is hidden until one asks.
#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double guess_radius = 20.0;

}  // namespace

void keep_guess_clear(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!content.guess.at) return;
  const Vector<2> at = canvas.at(*content.guess.at);
  canvas.labels.keep_clear(at, at, canvas.points(guess_radius) + canvas.width(2.0));
}

void add_guess(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageGuess& guess = content.guess;
  if (!guess.at) return;
  // A lesson has other things to say above.
  const StageLanguage::Labels& all = content.language.labels;
  const std::string words = guess.is_open                       ? std::string(all.guess_to_drag)
                            : content.lesson && guess.missed_by ? filled(all.guess_off, slide_number(*guess.missed_by))
                                                                : std::string(all.guess);
  const Theme& theme = content.theme;
  const Vector<2> at = canvas.at(*guess.at);
  const double radius = canvas.points(guess_radius);
  canvas.disc(Role::guess, at, radius, theme.background.with_alpha(0), faded(theme.accent, guess.is_open ? 1.0 : 0.55),
              canvas.width(4.0));
  canvas.label(Role::guess,
               {StageLabel::guess,
                {words},
                layout.letters.bold_words,
                at,
                at,
                radius + canvas.width(2.0),
                Vector<2>(-0.4, -1.0)},
               theme.accent);
}

bool hides_rest(const StageContent& content) {
  return (content.mode == StageMode::predict && content.guess.is_open) || content.hides.handle;
}

StageMoment moment_of_question(const StageContent& content) {
  StageMoment moment = content.moment;
  moment.handle = moment.proxy = content.moment.goal;
  return moment;
}

namespace {

void add_predict(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  keep_guess_clear(layer);
  if (!hides_rest(content)) {
    add_whole_scene(layer);
    add_guess(layer);
    return;
  }
  // The spring leads to the guess.
  StageContent question = content;
  question.moment = moment_of_question(content);
  question.linkage.reset();  // its links meet at the answer
  const StageLayer asked{question, layout, canvas};
  add_stage_wall(asked);
  add_rail(asked);
  add_mechanism(asked);
  if (content.guess.at) {
    canvas.coil(Role::hand_spring, canvas.at(*content.guess.at), canvas.at(content.moment.goal), 9, canvas.width(3.0),
                content.theme.text);
  }
  add_stage_hand(layer);
  add_rail_grips(asked);
  add_guess(layer);
  add_hand_words(layer);
  add_motor_words(asked);
}

std::string predict_sentence(const StageContent& content) {
  const StageLanguage::Sentences& all = content.language.sentences;
  if (!content.moment.has_rest && !content.guess.is_open)
    return no_rest_sentence(content.settings.active, content.language);
  if (content.guess.missed_by) return filled(all.guess_was_off, slide_number(*content.guess.missed_by));
  if (!content.guess.is_open) return std::string(all.guess_is_tried);
  if (depth_in_wall(content.settings, content.moment.goal) <= 0.0) return std::string(all.guess_needs_wall);
  if (has_strings(content.settings)) return std::string(all.guess_with_strings);
  const bool has_two = content.settings.active == StrategyId::full;
  return std::string(has_two ? all.guess_with_two_motors : all.guess_with_one_motor);
}

}  // namespace

const StageModeLayers predict_layers{StageMode::predict, add_predict, predict_sentence};

}  // namespace ghostforce
