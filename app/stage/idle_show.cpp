#include "app/stage/idle_show.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "app/stage/stage_transition.h"
#include "core/scene_shape.h"

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
  const StageLeft left{session.settings, session.goal, moment};
  StageShow show = session.lesson ? hand_show(left, show_s_, strength_) : stage_show(left, show_s_, strength_);
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
  for (const Strategy& each : strategy_catalog()) {
    const auto found = rest_of(each.id, settings, goal);
    if (!found) continue;
    const PredictedEquilibrium& rest = *found;
    snapshot.strategies[index_of(each.id)] = {.device = rest.at.device,
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

// A short way, so that it is in the picture that fits the hand where it was left.
Vector<2> hand_on_its_way(const Settings& settings, const Vector<2>& goal, double time_s) {
  constexpr double least_height = 0.010;  // [m]
  constexpr double least_depth = 0.006;
  const Wall<2> wall = wall_near(settings, goal);
  const Vector<2> on_wall = foot_on_edge(settings, goal);
  const double goal_depth = depth(wall, goal);
  const Vector<2> outside = on_wall + std::max(least_height, -goal_depth) * wall.normal;
  const Vector<2> inside = on_wall - std::max(least_depth, goal_depth) * wall.normal;
  return glm::mix(outside, inside, way_inwards(time_s));
}

// The hand glides to the show's place, and every picture on the way is one at rest: halves of two moments together would
// be true of no device. Only by how far the first moment was from its rest it is off at the beginning.
StageMoment moment_on_the_way(const StageLeft& left, const Settings& settings, const Vector<2>& goal,
                              const StageBlend& blend, double strength) {
  const auto at_rest = [&](const Vector<2>& at, const StageBlend& between) {
    return stage_moment_between(settings, snapshot_at_rest(settings, at), at, between);
  };
  const StageBlend before = stage_blend_of(left.settings.active);
  StageMoment moment =
      at_rest(glm::mix(left.goal, goal, strength), {.fullness = glm::mix(before.fullness, blend.fullness, strength),
                                                    .cure = glm::mix(before.cure, blend.cure, strength)});
  if (strength == 1.0) return moment;
  const StageMoment rest = at_rest(left.goal, before);
  for (const auto field : {&StageMoment::handle, &StageMoment::proxy, &StageMoment::wall_share,
                           &StageMoment::ghost_force, &StageMoment::slide}) {
    moment.*field += (1.0 - strength) * (left.moment.*field - rest.*field);
  }
  return moment;
}

}  // namespace

StageShow stage_show(const StageLeft& left, double time_s, double strength) {
  const double time = std::fmod(time_s, comes_back);
  StageShow show{left.settings, {}};
  show.settings.active = time < slides ? StrategyId::naive : StrategyId::anisotropic;
  show.moment = moment_on_the_way(left, show.settings, hand_on_its_way(left.settings, left.goal, time_s),
                                  {.fullness = 0.0, .cure = glm::smoothstep(slides, is_cured, time)}, strength);
  return show;
}

StageShow hand_show(const StageLeft& left, double time_s, double strength) {
  return {left.settings, moment_on_the_way(left, left.settings, hand_on_its_way(left.settings, left.goal, time_s),
                                           stage_blend_of(left.settings.active), strength)};
}

}  // namespace ghostforce
