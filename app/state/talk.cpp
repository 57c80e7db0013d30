#include "app/state/talk.h"

#include <array>

#include "app/state/mode_changes.h"
#include "app/state/permit.h"

namespace ghostforce {
namespace {

template <StrategyId id>
void show_strategy(Session& session) {
  leave_stage_mode(session);
  choose_strategy(session, id, true);
}

template <StageMode mode, StrategyId id>
void show_stage_mode(Session& session) {
  if (session.stage.mode == mode) {
    // It goes on.
  } else if (const auto refusal = permit(session, ToggleMode{mode})) {
    leave_stage_mode(session);
    session.notice = Notice{std::string(stage_language(session.language).refusals.*refusal->words)};
  } else {
    begin_stage_mode(session, mode);
  }
  choose_strategy(session, id, false);
}

template <int step>
void show_why(Session& session) {
  show_stage_mode<StageMode::why, StrategyId::naive>(session);
  session.stage.why_step = step;
}

constexpr std::array<void (*)(Session&), 9> talk{show_strategy<StrategyId::full>,
                                                 show_strategy<StrategyId::naive>,
                                                 show_why<1>,
                                                 show_why<2>,
                                                 show_why<3>,
                                                 show_why<4>,
                                                 show_strategy<StrategyId::anisotropic>,
                                                 show_stage_mode<StageMode::landscape, StrategyId::naive>,
                                                 show_stage_mode<StageMode::round, StrategyId::anisotropic>};

}  // namespace

void go_to_talk_step(Session& session, int step) {
  if (step < 0 || step >= static_cast<int>(talk.size())) return;
  session.face = Face::stage;
  session.stage.is_black = false;
  session.stage.demo_step = step;
  talk[static_cast<std::size_t>(step)](session);
}

std::size_t talk_length() noexcept {
  return talk.size();
}

}  // namespace ghostforce
