#include "app/shell/visible_state.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "app/state/kiosk_visit.h"
#include "app/state/stiffness_probe_guide.h"
#include "core/belief.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double visible_share_of_point = 0.01;
constexpr double finest_shown_step = 0.0000005;  // half of the last digit of the finest length in a panel [m]
constexpr double finest_shown_force = 0.001;     // less than the last digit of any force [N]

// In the words and to the digits that panels and dialogs show, in any order.
void add_panel_words(const Session& session, const LoopReading& reading, std::string& words) {
  const auto out = std::back_inserter(words);
  fmt::format_to(out, "{}{}{}{}", reading.refused, reading.refused_by_system, reading.device, reading.device_remark);
  for (const ReadinessStepState& step : reading.readiness) fmt::format_to(out, "{}{}", step.is_reached, step.words);
  const RecordingReading& recording = reading.recording;
  fmt::format_to(out, "{:.1f} {:.1f} {}", recording.seconds, 1e-6 * static_cast<double>(recording.bytes),
                 recording.dropped);
  if (const MotorReport& motors = reading.motors; motors.has_motors) {
    fmt::format_to(out, "{:.2f} {:.2f} {:.2f} {:.0f} {:.2f} {:.0f}", glm::length(motors.sent), motors.limit,
                   motors.handle_speed, motors.held_k_r, motors.gain, 100.0 * std::ranges::max(motors.heat));
  }
  if (reading.circle) fmt::format_to(out, "{:.2f}", reading.circle->share);
  fmt::format_to(out, "{}", session.dial_turned_s.has_value());
  const HandReading& hand = reading.hand;
  fmt::format_to(out, "{} {}", static_cast<int>(session.belief_source), hand.tone_gain > 0.0);
  if (hand.is_measuring) {
    fmt::format_to(out, " {} {:.0f} {:.0f} {:.0f} {}", static_cast<int>(hand.estimate.why), hand.estimate.k_u,
                   hand.estimate.sigma, hand.believed_k_u, reading.hand_unknown_s > BeliefFollower::holds_s);
  }
  const UserMeasurement& measurement = session.measurement;
  fmt::format_to(out, "{} {}{}{}", measurement.readings.size(), static_cast<int>(measurement.step),
                 measurement.was_refused, measurement.has_begun_anew);
  if (measurement.drift) fmt::format_to(out, "{:.2f}", mm_per_m * *measurement.drift);
}

std::string shown_words(const Session& session, const LoopReading& reading) {
  const MotorReport& motors = reading.motors;
  const auto step = std::ranges::find_if(reading.readiness, &ReadinessStepState::is_current);
  std::string words = fmt::format(
      "{}{}{}{}{}{}{}{}{} {} {}{}{}{}{} {} {}", reading.diverged, motors.has_motors, motors.has_focus,
      motors.is_checking, motors.is_ready,
      motors.waits_for_zero_pose && motors.zero_pose_moved ? 2
      : motors.waits_for_zero_pose                         ? 1
                                                           : 0,
      motors.may_still_push, motors.is_saturated || motors.motor_is_at_limit, static_cast<int>(motors.state),
      static_cast<int>(motors.reason), static_cast<int>(motors.obstacle), static_cast<int>(motors.finding.verdict),
      motors.finding.motor, step != reading.readiness.end() ? step->title : std::string_view(), reading.recording.is_on,
      reading.recording.path, reading.circle ? reading.circle->turns : 0);
  words += reading.shader_problem;
  if (reading.replay) words += fmt::format(" {}/{}", reading.replay->done, reading.replay->all);
  if (const auto& lesson = session.lesson) {
    words += fmt::format(" {} {} {} {} {}", progress_key(*lesson->lesson), session.language, lesson->step,
                         static_cast<int>(lesson->steps[lesson->step].outcome), invites_visitors(session));
  }
  if (const StiffnessProbe& probe = session.stiffness_probe; probe.stage != StiffnessProbe::Stage::off) {
    words += fmt::format(" {} {:.3f} {} {} {}", static_cast<int>(probe.stage), probe.filled,
                         static_cast<int>(probe.why), probe.estimate.k_u, stiffness_probe_is_believed(session));
  }
  if (session.face == Face::workbench || session.dialog != Dialog::none) add_panel_words(session, reading, words);
  return words;
}

}  // namespace

VisibleState visible_state(const Session& session, const ShownMoment& shown, const History& history, double present_s,
                           const LoopReading& reading) {
  VisibleState state{.snapshot = shown.snapshot,
                     .settings = shown.settings,
                     .is_past = shown.is_past,
                     .is_paused = session.paused,
                     .goal = session.goal,
                     .notice = {},
                     .plots_end_s = {},
                     .ribbon_end_s = {},
                     .trail_s = {},
                     .theme = shown_theme(session),
                     .words = shown_words(session, reading)};
  if (session.notice) state.notice = session.notice->words;
  const PlotView& plots = session.plots;
  const bool has_plots = session.face == Face::workbench && plots.is_open && is_over_time(plots.tab);
  if (has_plots && (plots.follows || present_s <= plots.to_s)) state.plots_end_s = present_s;
  const bool has_ribbon = session.face == Face::stage && session.stage.mode == StageMode::ribbon;
  if (has_ribbon) state.ribbon_end_s = history.moments().changed_s();
  const bool has_trail = session.face == Face::workbench && session.options.trails;
  if (has_trail && history.has_trail_at(shown.snapshot.time_s)) state.trail_s = shown.snapshot.time_s;
  return state;
}

bool differs_visibly(const VisibleState& seen, const VisibleState& now, double points_per_metre) noexcept {
  const LeastVisible least{.step = std::min(visible_share_of_point / points_per_metre, finest_shown_step),
                           .force = finest_shown_force};
  return differs_visibly(seen.snapshot, now.snapshot, least) || glm::distance(seen.goal, now.goal) > least.step ||
         seen.settings != now.settings || seen.is_past != now.is_past || seen.is_paused != now.is_paused ||
         seen.notice != now.notice || seen.plots_end_s != now.plots_end_s || seen.ribbon_end_s != now.ribbon_end_s ||
         seen.trail_s != now.trail_s || seen.theme != now.theme || seen.words != now.words;
}

}  // namespace ghostforce
