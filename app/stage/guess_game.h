// GuessGame: predict, then reveal. The person drags a ring to where the handle should come to rest; then the hand
// presses in once more, slowly, and the distance is the score. UI thread.
#pragma once

#include <optional>

#include "app/stage/stage.h"
#include "app/state/session.h"

namespace ghostforce {

class GuessGame {
 public:
  // Keeps up with what the session asks for. Another wall, hand or strategy asks anew.
  void update(Session& session, double interval_s);

  bool is_revealing() const noexcept { return reveal_s_ < reveal_lasts_s; }
  StageGuess guess(const Session& session) const;

  // While the answer is being given: at rest under a hand on its way into the wall.
  StageMoment moment(const Session& session) const;

 private:
  static constexpr double reveal_lasts_s = 4.0;

  bool is_on_ = false;
  std::uint32_t reveals_ = 0;
  double reveal_s_ = reveal_lasts_s;  // since it began
  Settings settings_;                 // that the guess is about,
  Vector<2> goal_{0.0};               // and the hand
};

}  // namespace ghostforce
