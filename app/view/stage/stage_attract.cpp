#include "app/view/stage/stage_attract.h"

#include <cmath>

#include <glm/common.hpp>

#include "app/view/stage/stage_transition.h"
#include "core/prediction.h"

namespace ghostforce {
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

}  // namespace

StageShow stage_show(const Scene& scene, const Settings& settings, double time_s) {
  const double time = std::fmod(time_s, comes_back);
  const Vector<2> outside = scene.goal.points.front();
  const Vector<2> inside = scene.goal.points.back();
  const double way = glm::smoothstep(0.0, goes_in, time) - glm::smoothstep(rests, comes_back, time);
  const Vector<2> goal = glm::mix(outside, inside, way);
  StageShow show{settings, {}};
  show.settings.active = time < slides ? StrategyId::naive : StrategyId::anisotropic;
  const double cure = glm::smoothstep(slides, is_cured, time);
  show.moment =
      stage_moment_between(show.settings, snapshot_at_rest(show.settings, goal), goal, {.fullness = 0.0, .cure = cure});
  return show;
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
