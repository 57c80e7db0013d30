#include "app/stage/idle_show.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "app/stage/stage_transition.h"
#include "core/prediction.h"

namespace ghostforce {
namespace {

constexpr double fades_in_s = 1.2;
constexpr double fades_out_s = 0.25;

}  // namespace

void IdleShow::update(bool is_touched, bool may_begin, double interval_s) noexcept {
  may_begin_ = may_begin;
  if (is_touched || !may_begin) idle_s_ = 0.0;
  if (idle_s_ >= begins_after_s) {
    show_s_ += interval_s;
    strength_ = std::min(1.0, strength_ + interval_s / fades_in_s);
    return;
  }
  strength_ = std::max(0.0, strength_ - interval_s / fades_out_s);
  if (strength_ == 0.0) show_s_ = 0.0;
}

StageShow IdleShow::shown_instead_of(const StageMoment& moment, const Session& session) const {
  StageShow show = session.lesson ? hand_show(session.settings, session.goal, show_s_)
                                  : stage_show(*session.scene, session.settings, show_s_);
  show.moment = mixed_moment(moment, show.moment, strength_);
  if (strength_ < 0.5) show.settings.active = session.settings.active;
  return show;
}

namespace {

// When each part of it ends [s].
constexpr double goes_in = 3.0;
constexpr double slides = 6.0;
constexpr double is_cured = 8.5;
constexpr double rests = 11.5;
constexpr double comes_back = 13.5;

Snapshot snapshot_at_rest(const Settings& settings, const Vector<2>& goal) {
  Snapshot snapshot;
  snapshot.goal = goal;
  const auto equilibria = predicted_equilibria(settings, goal);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const PredictedEquilibrium& rest = equilibria[i];
    snapshot.strategies[i] = {.device = rest.at.device,
                              .proxy = rest.at.proxy,
                              .contact = rest.at.contact,
                              .force = rest.at.force,
                              .ghost_force = rest.ghost_force,
                              .proxy_drift = rest.proxy_drift,
                              .in_contact = rest.at.in_contact};
  }
  return snapshot;
}

// 0 outside, 1 in the wall.
double way_inwards(double time_s) {
  const double time = std::fmod(time_s, comes_back);
  return glm::smoothstep(0.0, goes_in, time) - glm::smoothstep(rests, comes_back, time);
}

}  // namespace

StageShow stage_show(const Scene& scene, const Settings& settings, double time_s) {
  const double time = std::fmod(time_s, comes_back);
  const Vector<2> goal = glm::mix(scene.goal.points.front(), scene.goal.points.back(), way_inwards(time_s));
  StageShow show{settings, {}};
  show.settings.active = time < slides ? StrategyId::naive : StrategyId::anisotropic;
  const double cure = glm::smoothstep(slides, is_cured, time);
  show.moment =
      stage_moment_between(show.settings, snapshot_at_rest(show.settings, goal), goal, {.fullness = 0.0, .cure = cure});
  return show;
}

StageShow hand_show(const Settings& settings, const Vector<2>& goal, double time_s) {
  constexpr double least_height = 0.010;  // [m]
  constexpr double least_depth = 0.006;   // little, so that the hand stays in the picture of its step
  const Wall<2> wall = wall_of(settings);
  const Vector<2> on_wall = projection(wall, goal);
  const double goal_depth = depth(wall, goal);
  const Vector<2> outside = on_wall + std::max(least_height, -goal_depth) * wall.normal;
  const Vector<2> inside = on_wall - std::max(least_depth, goal_depth) * wall.normal;
  const Vector<2> now = glm::mix(outside, inside, way_inwards(time_s));
  return {settings,
          stage_moment_between(settings, snapshot_at_rest(settings, now), now, stage_blend_of(settings.active))};
}

StageMoment mixed_moment(const StageMoment& first, const StageMoment& second, double share) noexcept {
  StageMoment moment = share < 0.5 ? first : second;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    moment.weights[i] = glm::mix(first.weights[i], second.weights[i], share);
  }
  for (const auto field :
       {&StageMoment::goal, &StageMoment::handle, &StageMoment::proxy, &StageMoment::wall_share,
        &StageMoment::ghost_force, &StageMoment::slide, &StageMoment::expected_rest, &StageMoment::expected_contact}) {
    moment.*field = glm::mix(first.*field, second.*field, share);
  }
  return moment;
}

}  // namespace ghostforce
