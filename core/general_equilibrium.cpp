#include "core/general_equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/rest_stability.h"
#include "core/round_contact.h"

namespace ghostforce {
namespace {

// --- One piece: planes that act, and states of the motors ---------------------------------------------------------------

// What decides how force follows from the planes' push, linearly.
struct Piece {
  PlaneSet planes = 0;
  MotorState nearest{};    // of the efforts that come nearest to what is meant; for s > 0
  MotorState commanded{};  // of the efforts that are commanded; for s < 1
};

// What is asked for. `fading`: how far the motors that do not exist have faded out, above 0 and up to 1.
struct Question {
  const GeneralScene& scene;
  const Vector<2>& goal;
  double share;
  double fading;

  bool needs_nearest() const noexcept { return share > 0.0; }
  bool needs_commanded() const noexcept { return share != 1.0; }
};

// The place of handle and proxy.
struct Place {
  Vector<2> device;
  Vector<2> proxy;
};

struct Solution {
  Place place;
  Vector<2> contact_force;
  Vector<2> force;
  Efforts efforts{};
};

// How the commanded force follows from the force that is meant: linear · f + constant.
struct AffineForce {
  Matrix<2> linear{0.0};
  Vector<2> constant{0.0};
};

AffineForce commanded_force(const ActuationMatrix<2>& actuation, const MotorState& state) noexcept {
  AffineForce force;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    if ((state.free >> i & 1U) != 0) {
      force.linear += glm::outerProduct(actuation.columns[i], actuation.commands[i]);
    } else {
      const bool is_greatest = (state.greatest >> i & 1U) != 0;
      force.constant += actuation.columns[i] * (is_greatest ? actuation.greatest[i] : actuation.least[i]);
    }
  }
  return force;
}

// Whether commands really leave the motors in that state.
bool are_commanded(const ActuationMatrix<2>& actuation, const MotorState& state, const Vector<2>& meant) noexcept {
  constexpr double negligible = 1e-12;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    const double command = glm::dot(actuation.commands[i], meant);
    const double slack = negligible * (1.0 + std::abs(command));
    if ((state.free >> i & 1U) != 0) {
      if (!(command >= actuation.least[i] - slack && command <= actuation.greatest[i] + slack)) return false;
    } else if ((state.greatest >> i & 1U) != 0) {
      if (!(command >= actuation.greatest[i] - slack)) return false;
    } else if (!(command <= actuation.least[i] + slack)) {
      return false;
    }
  }
  return true;
}

// Whether inequalities are looked at: while Newton's method is on its way they are not, so that the piece stays smooth.
enum class Check : std::uint8_t { none, all };

// With A and the planes as they are at `at`: where handle and proxy are then. False: nowhere, or not in this piece.
bool solve_piece(const Question& question, const Piece& piece, const Place& at, Check check,
                 Solution& solution) noexcept {
  const GeneralScene& scene = question.scene;
  const Compliances<2>& compliances = scene.compliances;
  const double share = question.share;
  const double fading = question.fading;
  std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, at.device);
  if (!actuation) return false;

  AffineForce force{Matrix<2>(1.0 - fading), Vector<2>(0.0)};
  Matrix<2> tracking = compliances.tracking;
  Vector<2> shift(0.0);  // of the proxy before the handle
  NearestForce<2> nearest;
  if (question.needs_nearest()) {
    if (!find_nearest_force(*actuation, compliances.user, piece.nearest, nearest)) return false;
    const Matrix<2>& projector = nearest.projection.projector;
    const Vector<2> constant = nearest.limit_force - projector * nearest.limit_force;
    force.linear += (fading * share) * projector;
    force.constant += (fading * share) * constant;
    tracking = tracking_compliance(compliances, projector, fading * share);
    shift = (-fading * share) * (compliances.user * constant);
  }
  if (question.needs_commanded()) {
    if (piece.commanded.free != all_motors(actuation->count) && !is_possible(*actuation, piece.commanded)) return false;
    const AffineForce commanded = commanded_force(*actuation, piece.commanded);
    force.linear += (fading * (1.0 - share)) * commanded.linear;
    force.constant += (fading * (1.0 - share)) * commanded.constant;
  }

  const Planes<2> planes = linearised(scene.constraint, at.proxy);
  const Vector<2> unpushed = question.goal + scene.user_compliance * force.constant + shift;
  PlaneNumbers gaps{};
  for (std::size_t i = 0; i < planes.count; ++i) gaps[i] = signed_distance(planes.walls[i], unpushed);
  const Matrix<2> response = compliances.force_share * (scene.user_compliance * force.linear) + tracking;
  PlaneNumbers multipliers;
  if (!find_multipliers(planes, gaps, response, compliances.constraint, piece.planes, multipliers,
                        solution.contact_force, check == Check::all)) {
    return false;
  }
  const Vector<2> meant = compliances.force_share * solution.contact_force;
  solution.force = force.linear * meant + force.constant;
  solution.place.device = question.goal + scene.user_compliance * solution.force;
  solution.place.proxy = solution.place.device + tracking * solution.contact_force + shift;
  if (check == Check::none) return true;

  if (question.needs_commanded() && !are_commanded(*actuation, piece.commanded, meant)) return false;
  if (question.needs_nearest()) {
    if (!find_efforts(*actuation, compliances.user, piece.nearest, nearest, meant, solution.efforts)) return false;
    if (actuation->count > 1) make_least(*actuation, solution.efforts);
  }
  for (std::size_t i = 0; i < actuation->count; ++i) {
    const double commanded = within_limits(*actuation, i, glm::dot(actuation->commands[i], meant));
    solution.efforts[i] = commanded + share * (solution.efforts[i] - commanded);
  }
  return true;
}

// --- Newton's method ---------------------------------------------------------------------------------------------------

// The unknowns: the device where A turns, the proxy where the wall is round.
class Unknowns {
 public:
  explicit Unknowns(const Question& question) noexcept
      : device_(turns(question.scene.mechanism)), proxy_(is_curved(question.scene.constraint)) {}

  std::size_t count() const noexcept { return (device_ ? 2U : 0U) + (proxy_ ? 2U : 0U); }
  double& in(Place& place, std::size_t i) const noexcept {
    Vector<2>& vector = device_ && i < 2 ? place.device : place.proxy;
    return vector[static_cast<glm::length_t>(i % 2)];
  }
  double in(const Place& place, std::size_t i) const noexcept {
    const Vector<2>& vector = device_ && i < 2 ? place.device : place.proxy;
    return vector[static_cast<glm::length_t>(i % 2)];
  }

 private:
  bool device_;
  bool proxy_;
};

constexpr std::size_t most_unknowns = 4;
using Column = std::array<double, most_unknowns>;

// x of J x = r; the columns of J. False: J is singular.
bool solve_linear(std::array<Column, most_unknowns> columns, Column right, std::size_t count, Column& x) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < count; ++i) {
      if (std::abs(columns[k][i]) > std::abs(columns[k][pivot])) pivot = i;
    }
    if (!(std::abs(columns[k][pivot]) > 1e-14)) return false;
    for (std::size_t j = k; j < count; ++j) std::swap(columns[j][k], columns[j][pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = k + 1; i < count; ++i) {
      const double factor = columns[k][i] / columns[k][k];
      for (std::size_t j = k; j < count; ++j) columns[j][i] -= factor * columns[j][k];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = count; k-- > 0;) {
    double value = right[k];
    for (std::size_t j = k + 1; j < count; ++j) value -= columns[j][k] * x[j];
    x[k] = value / columns[k][k];
  }
  return true;
}

// How far solving moves the place [m].
double residual(const Unknowns& unknowns, const Place& from, const Place& to, Column& way) noexcept {
  double square = 0.0;
  for (std::size_t i = 0; i < unknowns.count(); ++i) {
    way[i] = unknowns.in(to, i) - unknowns.in(from, i);
    square += way[i] * way[i];
  }
  return std::sqrt(square);
}

// The place that solving the piece there does not change, from `start`. False: it was not found, or is not in the piece.
bool find_rest(const Question& question, const Piece& piece, const Place& start, Solution& solution) noexcept {
  const Unknowns unknowns(question);
  const std::size_t count = unknowns.count();
  Place place = start;
  if (!solve_piece(question, piece, place, Check::none, solution)) return false;
  constexpr int most_steps = 40;
  constexpr double step_m = 1e-7;          // of differences
  constexpr double good_enough_m = 1e-11;  // where rounding ends the way
  constexpr double exact_m = 1e-17;
  Column way{};
  double off = residual(unknowns, place, solution.place, way);
  for (int steps = 0; steps < most_steps && off > exact_m; ++steps) {
    std::array<Column, most_unknowns> jacobian{};
    for (std::size_t k = 0; k < count; ++k) {
      Place near = place;
      unknowns.in(near, k) += step_m;
      Solution moved;
      if (!solve_piece(question, piece, near, Check::none, moved)) return false;
      for (std::size_t i = 0; i < count; ++i) {
        jacobian[k][i] = (i == k ? 1.0 : 0.0) - (unknowns.in(moved.place, i) - unknowns.in(solution.place, i)) / step_m;
      }
    }
    Column change{};
    if (!solve_linear(jacobian, way, count, change)) return false;
    bool is_better = false;
    for (double length = 1.0; length > 1e-3 && !is_better; length *= 0.5) {
      Place next = place;
      for (std::size_t i = 0; i < count; ++i) unknowns.in(next, i) += length * change[i];
      Solution there;
      Column next_way{};
      if (!solve_piece(question, piece, next, Check::none, there)) continue;
      const double next_off = residual(unknowns, next, there.place, next_way);
      is_better = next_off < off;
      if (!is_better) {
        if (off < good_enough_m) break;
        continue;
      }
      place = next;
      solution = there;
      way = next_way;
      off = next_off;
    }
    if (!is_better) break;
  }
  return off < good_enough_m && solve_piece(question, piece, place, Check::all, solution);
}

// --- All pieces ----------------------------------------------------------------------------------------------------------

// Calls visit(piece) in the one order until it returns true.
template <typename Visit>
void for_each_piece(const Question& question, const ActuationMatrix<2>& actuation, Visit&& visit) noexcept {
  const std::size_t plane_count = linearised(question.scene.constraint, question.goal).count;
  const std::span<const MotorState> only_free = free_motors(actuation.count);
  const std::span<const MotorState> states = motor_states_of(actuation);
  for (const MotorState& nearest : question.needs_nearest() ? states : only_free) {
    for (const MotorState& commanded : question.needs_commanded() ? states : only_free) {
      for (const PlaneSet planes : plane_sets) {
        if (planes < (1U << plane_count) && visit(Piece{planes, nearest, commanded})) return;
      }
    }
  }
}

double distance(const Place& one, const Place& other) noexcept {
  return std::hypot(glm::length(one.device - other.device), glm::length(one.proxy - other.proxy));
}

// Whether the handle stays there. Half faded motors are only a way to find what exists.
bool stands(const Question& question, const Place& place) noexcept {
  if (question.fading < 1.0) return true;
  return leads_back(question.scene, {.has_every_motor = false, .share = question.share}, place.device, place.proxy);
}

// Of all stable rests that are found from `start` the nearest to it, and how many there are.
struct Search {
  Solution nearest;
  PlaneSet planes = 0;
  int count = 0;
};

Search search(const Question& question, const Place& start, bool is_unique) noexcept {
  Search found;
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(question.scene.mechanism, start.device);
  if (!actuation) return found;
  for_each_piece(question, *actuation, [&](const Piece& piece) {
    Solution solution;
    if (!find_rest(question, piece, start, solution) || !stands(question, solution.place)) return false;
    constexpr double same_m = 1e-9;
    if (found.count > 0 && distance(solution.place, found.nearest.place) < same_m) return false;
    ++found.count;
    if (found.count == 1 || distance(solution.place, start) < distance(found.nearest.place, start)) {
      found.nearest = solution;
      found.planes = piece.planes;
    }
    return is_unique;
  });
  return found;
}

GeneralEquilibrium equilibrium_at(const GeneralScene& scene, const Vector<2>& goal, const Search& found) noexcept {
  const Solution& rest = found.nearest;
  return {{goal, rest.place.proxy, rest.place.device, projection(scene.constraint, rest.place.proxy), rest.force, true},
          rest.contact_force,
          rest.efforts,
          static_cast<std::uint8_t>(found.planes)};
}

// With every motor the proxy is the goal, held in the compliance of hand and renderer together: (a) of docs/theory.md.
// Inside a ring there is one such place; round an obstacle this is the face that the goal's own one leads to.
std::optional<GeneralEquilibrium> full_rest(const GeneralScene& scene, const Vector<2>& goal) noexcept {
  Compliances<2> both = scene.compliances;
  both.tracking += both.force_share * scene.user_compliance;
  const Vector<2> foot = projection(scene.constraint, goal);
  const Contact<2> held = hold_by(scene.constraint, goal, foot,
                                  [&](const Planes<2>& planes) { return solve_isotropic_contact(goal, planes, both); });
  if (held.status != ContactStatus::contact) return std::nullopt;
  const Vector<2> force = both.force_share * held.contact_force;
  const Vector<2> device = goal + scene.user_compliance * force;
  // Its efforts are told where its handle is, not where the hand is.
  const std::optional<ActuationMatrix<2>> actuation = actuation_at(scene.mechanism, device);
  if (!actuation) return std::nullopt;
  GeneralEquilibrium rest{{goal, held.proxy, device, projection(scene.constraint, held.proxy), force, true},
                          held.contact_force,
                          {},
                          held.active};
  for (std::size_t i = 0; i < actuation->count; ++i) rest.efforts[i] = glm::dot(actuation->commands[i], force);
  return rest;
}

// The fully actuated rest, followed while the missing motors fade out.
Search fade(const GeneralScene& scene, const Vector<2>& goal, double share, const Place& start) noexcept {
  constexpr int steps = 40;
  Search found;
  Place place = start;
  for (int i = 1; i <= steps; ++i) {
    found = search({scene, goal, share, static_cast<double>(i) / steps}, place, false);
    if (found.count == 0) return found;
    place = found.nearest.place;
  }
  return found;
}

// From where the handle drifts to when nothing but the balance of forces moves it: far from the fully actuated rest,
// Newton's method may not find its way from there. In the loop it is this rest that a slow hand comes to.
Search search_downstream(const Question& question, const Place& reference, bool is_unique) noexcept {
  const GeneralScene& scene = question.scene;
  const Compliances<2>& compliances = scene.compliances;
  const double softest = std::max(scene.user_compliance[0][0], scene.user_compliance[1][1]);
  const double stiffness = compliances.force_share / (compliances.tracking[0][0] + compliances.constraint);
  constexpr double oblique = 4.0;  // how much longer than the wall's push a motor's force may be [1]
  const double step = 1.0 / (1.0 + oblique * softest * stiffness);
  constexpr double whole_way = 30.0;  // in times of the slowest motion, that of the free hand
  constexpr double most_steps = 20000.0;
  const auto steps = static_cast<int>(std::min(whole_way / step, most_steps));
  Place place = reference;
  const GeneralStrategy strategy{.has_every_motor = false, .share = question.share};
  for (int i = 0; i < steps; ++i) {
    const Contact<2> contact = contact_at(scene, strategy, place.device, place.proxy);
    if (contact.status != ContactStatus::contact && contact.status != ContactStatus::free) return {};
    place.proxy = contact.proxy;
    place.device += step * (question.goal + scene.user_compliance * contact.force - place.device);
  }
  return search(question, place, is_unique);
}

}  // namespace

std::optional<GeneralEquilibrium> general_equilibrium_of(StrategyId id, const GeneralScene& scene,
                                                         const Vector<2>& goal) noexcept {
  if (!(signed_distance(scene.constraint, goal) < 0.0)) {
    return GeneralEquilibrium{{goal, goal, goal, projection(scene.constraint, goal), Vector<2>(0.0), false}, {}, {}, 0};
  }
  const std::optional<GeneralEquilibrium> full = full_rest(scene, goal);
  const GeneralStrategy& own = scene.strategies[index_of(id)];
  if (!full || own.has_every_motor) return full;
  const Place reference{full->at.device, full->at.proxy};
  // With the hand's true compliance the cure is the answer to a convex problem, so the first answer is the only one.
  const bool is_unique = own.share == 1.0 && scene.compliances.user == scene.user_compliance;
  const Question question{scene, goal, own.share, 1.0};
  Search found = search(question, reference, is_unique);
  // Round a curve more rests may be than are found from one place.
  if (found.count == 1 && (is_unique || !is_curved(scene.constraint))) return equilibrium_at(scene, goal, found);
  if (const Search faded = fade(scene, goal, own.share, reference); faded.count > 0) {
    return equilibrium_at(scene, goal, faded);
  }
  if (found.count == 0) found = search_downstream(question, reference, is_unique);
  return found.count > 0 ? std::optional(equilibrium_at(scene, goal, found)) : std::nullopt;
}

PredictedGeneralEquilibrium with_cost(const GeneralScene& scene, StrategyId id, const GeneralEquilibrium& rest,
                                      const GeneralEquilibrium& full) noexcept {
  PredictedGeneralEquilibrium predicted{rest};
  if (!rest.at.in_contact || scene.strategies[index_of(id)].has_every_motor) return predicted;
  predicted.ghost_force = general_ghost_force(scene, rest.at.device, rest.at.force, full.at.force);
  predicted.slide = rest.at.proxy - full.at.proxy;
  return predicted;
}

PerStrategy<std::optional<PredictedGeneralEquilibrium>> predicted_general_equilibria(const GeneralScene& scene,
                                                                                     const Vector<2>& goal) noexcept {
  PerStrategy<std::optional<PredictedGeneralEquilibrium>> predicted;
  const std::optional<GeneralEquilibrium> full = general_equilibrium_of(StrategyId::full, scene, goal);
  for (const Strategy& each : strategy_catalog()) {
    const std::optional<GeneralEquilibrium> rest =
        each.id == StrategyId::full ? full : general_equilibrium_of(each.id, scene, goal);
    if (!rest) continue;
    predicted[index_of(each.id)] = full ? with_cost(scene, each.id, *rest, *full) : PredictedGeneralEquilibrium{*rest};
  }
  return predicted;
}

}  // namespace ghostforce
