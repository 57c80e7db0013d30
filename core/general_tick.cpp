#include "core/general_tick.h"

#include <glm/matrix.hpp>

#include "core/round_contact.h"

namespace ghostforce {
namespace {

// Symmetric, with `first` along that direction and `second` across it.
Matrix<2> along_and_across(double angle, double first, double second) noexcept {
  if (first == second) return Matrix<2>(first);
  const Vector<2> along = direction_at(angle);
  return first * glm::outerProduct(along, along) + second * (Matrix<2>(1.0) - glm::outerProduct(along, along));
}

// 1/k for an infinite k too.
double compliance_of(double stiffness) noexcept {
  return 1.0 / stiffness;
}

void use_hand(const Matrix<2>& user_stiffness, GeneralCoefficients& coefficients) noexcept {
  const double dt = coefficients.period;
  coefficients.user_stiffness = user_stiffness;
  const Matrix<2> effective =
      Matrix<2>(coefficients.mass + dt * coefficients.damping) + (dt * dt) * coefficients.user_stiffness;
  coefficients.velocity_per_force = dt * glm::inverse(effective);
}

}  // namespace

// s is even in ρ, as ρ = 1 + s κ says of an isotropic hand: at κ = 1 it is ρ − 1.
GeneralStrategy general_strategy(const Strategy& strategy, const GeneralSettings& general) noexcept {
  Stiffnesses even;
  even.k_u = even.k_r = even.k_t = 1.0;
  return {strategy.has_every_motor, general.compliance_share * (strategy.tracking_ratio(even) - 1.0)};
}

Mechanism mechanism_of(const Settings& settings) noexcept {
  switch (settings.general.mechanism) {
    case MechanismKind::arm:
      return settings.general.arm;
    case MechanismKind::pantograph:
      return settings.general.pantograph;
    case MechanismKind::strings:
      return settings.general.strings;
    case MechanismKind::axes:
      break;
  }
  return FixedAxis{direction_at(settings.actuated_angle)};
}

Constraint constraint_of(const Settings& settings) noexcept {
  const GeneralSettings& general = settings.general;
  switch (general.constraint) {
    case ConstraintKind::corner:
      return CornerWall{settings.wall_point,
                        {direction_at(general.corner_normal_angles[0]), direction_at(general.corner_normal_angles[1])}};
    case ConstraintKind::circle:
      return RoundWall{general.circle_center, general.circle_radius, general.circle_is_free_inside};
    case ConstraintKind::plane:
      break;
  }
  return wall_of(settings);
}

GeneralScene general_scene_of(const Settings& settings) noexcept {
  const Stiffnesses& stiffnesses = settings.stiffnesses;
  const GeneralSettings& general = settings.general;
  GeneralScene scene;
  scene.mechanism = mechanism_of(settings);
  scene.constraint = constraint_of(settings);
  scene.user_compliance = along_and_across(general.k_u_first_angle, compliance_of(stiffnesses.k_u),
                                           compliance_of(general.k_u_second.value_or(stiffnesses.k_u)));
  scene.compliances = {
      stiffnesses.believed_k_u ? Matrix<2>(compliance_of(*stiffnesses.believed_k_u)) : scene.user_compliance,
      Matrix<2>(compliance_of(stiffnesses.k_t)), stiffnesses.k_r / stiffnesses.k_t, compliance_of(stiffnesses.k_c)};
  for (const Strategy& each : strategy_catalog()) {
    scene.strategies[index_of(each.id)] = general_strategy(each, general);
  }
  return scene;
}

GeneralCoefficients general_coefficients_of(const Settings& settings) noexcept {
  GeneralCoefficients coefficients{};
  coefficients.scene = general_scene_of(settings);
  coefficients.mass = settings.mass;
  coefficients.damping = settings.damping;
  coefficients.rate = settings.rate;
  coefficients.period = 1.0 / settings.rate;
  coefficients.encoder_step = settings.encoder_step;
  const double k_u = settings.stiffnesses.k_u;
  use_hand(along_and_across(settings.general.k_u_first_angle, k_u, settings.general.k_u_second.value_or(k_u)),
           coefficients);
  const GeneralScene& scene = coefficients.scene;
  if (turns(scene.mechanism) || is_curved(scene.constraint)) return coefficients;
  const Planes<2> planes = linearised(scene.constraint, Vector<2>(0.0));
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, Vector<2>(0.0));
  coefficients.fixed.emplace();
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const GeneralStrategy& strategy = scene.strategies[i];
    (*coefficients.fixed)[i] =
        fixed_contact(planes, *actuation, scene.compliances, strategy.has_every_motor, strategy.share);
  }
  return coefficients;
}

void set_user_stiffness(GeneralCoefficients& coefficients, double k_u) noexcept {
  use_hand(Matrix<2>(k_u), coefficients);
}

Contact<2> contact_at(const GeneralScene& scene, const GeneralStrategy& strategy, const Vector<2>& q,
                      const Vector<2>& last_proxy) noexcept {
  ActuationMatrix<2> actuation;
  if (!find_actuation(scene.mechanism, q, actuation)) return {.proxy = q, .status = ContactStatus::outside_workspace};
  return hold_by(scene.constraint, q, last_proxy, [&](const Planes<2>& planes) {
    if (strategy.has_every_motor) return solve_full_contact(q, planes, actuation, scene.compliances);
    return solve_contact(q, planes, actuation, scene.compliances, strategy.share);
  });
}

namespace {

Contact<2> solve(const GeneralCoefficients& coefficients, std::size_t strategy, const Vector<2>& q,
                 const Vector<2>& last_proxy) noexcept {
  if (coefficients.fixed) return solve_fixed_contact((*coefficients.fixed)[strategy], q);
  return contact_at(coefficients.scene, coefficients.scene.strategies[strategy], q, last_proxy);
}

}  // namespace

[[gnu::flatten]] void tick(const GeneralCoefficients& coefficients, const Vector<2>& goal,
                           TickState<2>& state) noexcept {
  ++state.tick;
  state.goal = goal;
  state.measured.reset();
  for (std::size_t i = 0; i < strategy_count; ++i) {
    auto& own = state.strategies[i];
    const Vector<2> held = own.force;
    const Vector<2> pull = coefficients.user_stiffness * (goal - own.motion.position);
    // M v = (M + dt B + dt² K_u) v − dt (B + dt K_u) v, so that one matrix does for both.
    const Vector<2> drag = coefficients.damping * own.motion.velocity +
                           coefficients.period * (coefficients.user_stiffness * own.motion.velocity);
    const Vector<2> velocity = own.motion.velocity + coefficients.velocity_per_force * (pull + held + own.tone - drag);
    const Vector<2> before = own.motion.position;
    const Vector<2> position = before + coefficients.period * velocity;
    own.energy += work(held, position - before);
    own.motion = {position, velocity};
    const Vector<2> seen = measured_position(coefficients.encoder_step, before);
    const Contact<2> contact = solve(coefficients, i, seen, own.proxy);
    own.in_contact = contact.status == ContactStatus::contact;
    // Axis by axis, as tick.h says.
    for (glm::length_t axis = 0; axis < 2; ++axis) {
      if (contact.status != ContactStatus::no_solution) own.proxy[axis] = contact.proxy[axis];
      own.force[axis] = contact.force[axis];
    }
    for (std::size_t motor = 0; motor < most_motors; ++motor) own.contact.efforts[motor] = contact.efforts[motor];
    own.contact.active = contact.active;
    own.contact.status = contact.status;
  }
}

Vector<2> general_ghost_force(const GeneralScene& scene, const Vector<2>& q, const Vector<2>& force,
                              const Vector<2>& full_force) noexcept {
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, q);
  if (!actuation) return Vector<2>(0.0);
  return force - force_of_efforts(*actuation, nearest_efforts(*actuation, scene.user_compliance, full_force));
}

void take_snapshot(const GeneralCoefficients& coefficients, const TickState<2>& state, Snapshot& snapshot) noexcept {
  snapshot.tick = state.tick;
  snapshot.time_s = time_of(state.tick, coefficients.rate);
  snapshot.goal = state.goal;
  snapshot.measured = state.measured;
  const auto& full = state.strategies[index_of(StrategyId::full)];
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const auto& own = state.strategies[i];
    StrategySnapshot<2>& shown = snapshot.strategies[i];
    shown.device = own.motion.position;
    shown.proxy = own.proxy;
    shown.contact = projection(coefficients.scene.constraint, own.proxy);
    shown.force = own.force;
    shown.energy = own.energy;
    shown.in_contact = own.in_contact;
    const bool is_compared = own.in_contact && !state.measured && !coefficients.scene.strategies[i].has_every_motor;
    shown.ghost_force = is_compared
                            ? general_ghost_force(coefficients.scene, own.motion.position, own.force, full.force)
                            : Vector<2>(0.0);
    shown.proxy_drift = is_compared ? own.proxy - full.proxy : Vector<2>(0.0);
  }
}

}  // namespace ghostforce
