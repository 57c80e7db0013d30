// The beginning and the end of a mode of the stage, and of the circle test, whoever asks for it. Edits the session; UI
// thread.
#pragma once

#include <optional>

#include "app/state/session.h"

namespace ghostforce {

// Another mode ends. The stage is to be shown already.
void begin_stage_mode(Session& session, StageMode mode);
void leave_stage_mode(Session& session);
// For the workbench, which looks at the same moment.
void leave_stage(Session& session);

inline constexpr int last_why_step = 4;

// The picture is seen again, and the landscape's dial is at the strategy.
void choose_strategy(Session& session, StrategyId id, bool slowly);

// The nearer end of the landscape's dial.
StrategyId strategy_of_dial(double dial) noexcept;
// Of the landscape, 0 naïve to 1 anisotropic, as it was dragged. Empty: it was not, or the strategy has been changed
// since by something else, such as Undo.
std::optional<double> dragged_landscape_dial(const Session& session) noexcept;

// In the circle test another input leads the goal round a circle inside the wall, near to where the person had it; at
// the end the goal is the person's again, and where it was. Beginning it while it is on does nothing.
void begin_circle_test(Session& session);
void end_circle_test(Session& session);

// The circle that the goal goes round, or would.
Circle circle_of(const Session& session) noexcept;

}  // namespace ghostforce
