// What buttons, keys and a clicker do on the stage. Edits the session; UI thread.
#pragma once

#include "app/session/session.h"
#include "app/session/stage_modes.h"
#include "app/view/stage/stage.h"

namespace ghostforce {

// A press on a part of the stage.
void act_on_stage(Session& session, const StageAction& action, const MotorReport& motors);

void show_face(Session& session, Face face);
// Begins a mode, or ends it where it is on. In a lesson the steps say which mode is on.
void toggle_stage_mode(Session& session, StageMode mode);
// The active one. `slowly`: the stage takes 6 s for it instead of 0.6.
void choose_strategy(Session& session, StrategyId id, bool slowly);

// The keys whose names stand on the stage.
StageKeys stage_keys() noexcept;

// What Enter means in the lesson or in the mode that is on: the answer to a guess, the next step.
void confirm_on_stage(Session& session);

// The lesson, or else the talk, that a clicker goes through, step by step; before the talk's first and after its last
// nothing happens.
void next_talk_step(Session& session);
void previous_talk_step(Session& session);
std::size_t talk_length() noexcept;

}  // namespace ghostforce
