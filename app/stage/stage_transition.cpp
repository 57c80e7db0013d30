#include "app/stage/stage_transition.h"

#include <cmath>

#include <glm/common.hpp>

#include "core/ghost_force.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// What moves while a strategy is being switched.
struct Fields {
  Vector<2> handle{0.0};
  Vector<2> proxy{0.0};
  Vector<2> ghost_force{0.0};
  Vector<2> slide{0.0};

  Fields operator+(const Fields& other) const noexcept {
    return {handle + other.handle, proxy + other.proxy, ghost_force + other.ghost_force, slide + other.slide};
  }
  Fields operator*(double factor) const noexcept {
    return {factor * handle, factor * proxy, factor * ghost_force, factor * slide};
  }
  Fields operator-(const Fields& other) const noexcept { return *this + other * -1.0; }
};

Fields fields_of(const StrategySnapshot<2>& now) noexcept {
  return {now.device, now.proxy, now.ghost_force, now.proxy_drift};
}

Fields fields_of(const PredictedEquilibrium& rest) noexcept {
  return {rest.at.device, rest.at.proxy, rest.ghost_force, rest.proxy_drift};
}

// At rest with this share of the compliance. Empty: nowhere.
std::optional<PredictedEquilibrium> rest_with_share(const Settings& settings, const Vector<2>& goal, double cure) {
  Settings between = settings;
  between.general.compliance_share *= cure;
  return rest_of(StrategyId::anisotropic, between, goal);
}

// Another wall holds, or another string is slack: between the two nothing is smooth.
bool is_of_one_piece(const Settings& settings, const PredictedEquilibrium& one, const PredictedEquilibrium& other) {
  const auto walls = [&](const Equilibrium<2>& at) { return acting_walls(settings, at.proxy, at.in_contact); };
  const auto tight = [&](const Equilibrium<2>& at) {
    unsigned strings = 0;
    const Efforts efforts = efforts_of(settings, at.device, at.force);
    for (std::size_t i = 0; i < most_motors; ++i) strings |= (efforts[i] > least_tension ? 1U : 0U) << i;
    return strings;
  };
  return walls(one.at) == walls(other.at) && (!has_strings(settings) || tight(one.at) == tight(other.at));
}

// Of a general scene: what both are, in shares, beside the smooth way from one rest to the other, where there is one.
Fields general_between(const Settings& settings, const Vector<2>& goal, const Fields& naive, const Fields& cured,
                       double cure) {
  const Fields straight = naive * (1.0 - cure) + cured * cure;
  const auto from = rest_with_share(settings, goal, 0.0);
  const auto to = rest_with_share(settings, goal, 1.0);
  const auto rest = rest_with_share(settings, goal, cure);
  if (!from || !to || !rest || !is_of_one_piece(settings, *from, *to) || !is_of_one_piece(settings, *from, *rest)) {
    return straight;
  }
  return straight + fields_of(*rest) - fields_of(*from) * (1.0 - cure) - fields_of(*to) * cure;
}

// At rest with this ratio.
Fields rest_at(const Settings& settings, const Vector<2>& goal, double ratio) noexcept {
  const Wall<2> wall = wall_of(settings);
  const Actuation<2> actuation = actuation_of(settings);
  const Equilibrium<2> rest = equilibrium_with_ratio(wall, actuation, settings.stiffnesses, ratio, goal);
  const Vector<2> full_force = equilibrium_fully_actuated(wall, settings.stiffnesses, goal).force;
  return {rest.device, rest.proxy, ghost_force(actuation, rest.force, full_force), proxy_drift(wall, rest.proxy, goal)};
}

}  // namespace

StageBlend stage_blend_of(StrategyId id) noexcept {
  return {id == StrategyId::full ? 1.0 : 0.0, id == StrategyId::anisotropic ? 1.0 : 0.0};
}

double tracking_ratio_at(const Settings& settings, double cure) noexcept {
  return std::pow(tracking_ratio(settings.stiffnesses), cure);
}

StageMoment stage_moment_between(const Settings& settings, const Snapshot& snapshot, const Vector<2>& goal,
                                 const StageBlend& blend) noexcept {
  StageMoment moment = stage_moment(settings, snapshot, goal);
  if (moment.is_measured || blend == stage_blend_of(settings.active)) return moment;

  const auto of = [&](StrategyId id) -> const StrategySnapshot<2>& { return snapshot.strategies[index_of(id)]; };
  const Fields naive = fields_of(of(StrategyId::naive));
  const Fields cured = fields_of(of(StrategyId::anisotropic));
  const auto paper_between = [&] {
    const auto rest = [&](double cure) { return rest_at(settings, snapshot.goal, tracking_ratio_at(settings, cure)); };
    const Fields naive_residual = naive - rest(0.0);
    const Fields anisotropic_residual = cured - rest(1.0);
    return rest(blend.cure) + naive_residual * (1.0 - blend.cure) + anisotropic_residual * blend.cure;
  };
  const Fields one_motor =
      is_general(settings) ? general_between(settings, snapshot.goal, naive, cured, blend.cure) : paper_between();
  const StrategySnapshot<2>& full = of(StrategyId::full);
  const Fields shown = one_motor * (1.0 - blend.fullness) + fields_of(full) * blend.fullness;

  moment.weights = {};
  moment.weights[index_of(StrategyId::full)] = blend.fullness;
  moment.weights[index_of(StrategyId::naive)] = (1.0 - blend.fullness) * (1.0 - blend.cure);
  moment.weights[index_of(StrategyId::anisotropic)] = (1.0 - blend.fullness) * blend.cure;
  moment.handle = shown.handle;
  moment.proxy = shown.proxy;
  moment.ghost_force = shown.ghost_force;
  moment.slide = shown.slide;
  const Vector<2> full_force = full.in_contact ? full.force : Vector<2>(0.0);
  moment.wall_share = glm::mix(motor_share(settings, shown.handle, full_force), full_force, blend.fullness);
  const auto cured_rest = rest_without_ghost(settings, goal);
  const auto full_rest = rest_of(StrategyId::full, settings, goal);
  if (cured_rest && full_rest) {
    moment.expected_rest = glm::mix(cured_rest->device, full_rest->at.device, blend.fullness);
  }
  keep_within_links(settings, moment);
  return moment;
}

void StageTransition::jump_to(StrategyId id) noexcept {
  target_ = id;
  from_ = to_ = stage_blend_of(id);
  elapsed_s_ = duration_s_ = 0.0;
}

void StageTransition::go_to(StrategyId id, bool slowly) noexcept {
  if (id == target_) return;
  from_ = blend();
  target_ = id;
  to_ = stage_blend_of(id);
  // What is not seen need not move: which of the two strategies of one motor it is, where every motor is there.
  if (from_.fullness == 1.0) from_.cure = to_.cure;
  if (to_.fullness == 1.0) to_.cure = from_.cure;
  elapsed_s_ = 0.0;
  duration_s_ = slowly ? slow_s : usual_s;
}

StageBlend StageTransition::blend() const noexcept {
  if (!is_running()) return stage_blend_of(target_);
  const double share = glm::smoothstep(0.0, duration_s_, elapsed_s_);
  return {from_.fullness + share * (to_.fullness - from_.fullness), from_.cure + share * (to_.cure - from_.cure)};
}

}  // namespace ghostforce
