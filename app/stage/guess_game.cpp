#include "app/stage/guess_game.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/scene_shape.h"

namespace ghostforce {

void GuessGame::update(Session& session, double interval_s) {
  if (session.lesson) {
    is_on_ = false;  // its guesses are its own
    return;
  }
  StageChoice& stage = session.stage;
  const bool was_on = is_on_;
  is_on_ = stage.mode == StageMode::predict;
  if (!is_on_) {
    stage.guess.reset();
    stage.guess_is_open = true;
    reveal_s_ = reveal_lasts_s;
    return;
  }
  const bool is_new = !was_on || session.settings != settings_ || session.goal != goal_ || !stage.guess;
  if (is_new) {
    settings_ = session.settings;
    goal_ = session.goal;
    stage.guess_is_open = true;
    reveal_s_ = reveal_lasts_s;
    reveals_ = stage.reveals_asked;
    if (!was_on || !stage.guess) stage.guess = neutral_guess(settings_now(session), session.goal);
    return;
  }
  if (stage.reveals_asked != reveals_) {
    reveals_ = stage.reveals_asked;
    // Asked again while the answer is on its way: at once. After it: a new guess.
    const bool was_revealing = is_revealing();
    stage.guess_is_open = !stage.guess_is_open && !was_revealing;
    const bool is_at_once = was_revealing || reduces_motion(session);
    reveal_s_ = stage.guess_is_open || is_at_once ? reveal_lasts_s : 0.0;
    return;
  }
  reveal_s_ = std::min(reveal_lasts_s, reveal_s_ + interval_s);
}

StageGuess GuessGame::guess(const Session& session) const {
  StageGuess guess{.at = session.stage.guess, .is_open = session.stage.guess_is_open};
  if (guess.at && !guess.is_open && !is_revealing()) {
    guess.missed_by = glm::distance(*guess.at, stage_moment_at_rest(settings_now(session), session.goal).handle);
  }
  return guess;
}

StageMoment GuessGame::moment(const Session& session) const {
  const double share = std::clamp(reveal_s_ / (0.85 * reveal_lasts_s), 0.0, 1.0);
  const Vector<2> foot = foot_on_edge(session.settings, session.goal);
  return stage_moment_at_rest(settings_now(session), glm::mix(foot, session.goal, share));
}

}  // namespace ghostforce
