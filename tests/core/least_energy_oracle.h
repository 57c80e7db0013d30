// Where any device should rest, by an oracle that knows no rendering law: the fully actuated rest is the proxy of least
// energy that the walls allow, and the cure's motors make of its force what leaves the hand nearest in energy. Dense
// matrices in extended precision, solved by Eigen; candidates are compared by their energy, not by the signs of
// multipliers. Shares no formula and no code with core/.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Dense>

namespace ghostforce {

using Exact = long double;
using ExactVector = Eigen::Matrix<Exact, Eigen::Dynamic, 1>;
using ExactMatrix = Eigen::Matrix<Exact, Eigen::Dynamic, Eigen::Dynamic>;

struct OracleDevice {
  ExactMatrix user;       // C_u [m/N]
  ExactMatrix rendering;  // C_r [m/N]
  Exact scale;            // τ
  Exact softness;         // 1/k_c [m/N]
  ExactMatrix normals;    // a row for each wall
  ExactVector offsets;    // n·o of each
  ExactMatrix actuation;  // A
  std::vector<Exact> least;
  std::vector<Exact> greatest;
};

struct OracleRest {
  ExactVector proxy;
  ExactVector full_force;  // f_F [N]
  ExactVector full_device;
  ExactVector force;  // of the motors that exist, at their best [N]
  ExactVector device;
  unsigned walls = 0;  // that act
  bool has_slack_motor = false;
  bool is_found = false;
};

inline OracleRest oracle_rest(const OracleDevice& device, const ExactVector& goal) {
  const Eigen::Index D = goal.size();
  const Eigen::Index walls = device.normals.rows();
  const ExactMatrix metric = device.scale * (device.user + device.rendering).inverse();
  OracleRest best;
  Exact least_energy = std::numeric_limits<Exact>::infinity();
  for (unsigned set = 1; set < (1U << walls); ++set) {
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < walls; ++i) {
      if ((set >> i & 1U) != 0) rows.push_back(i);
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    if (count > D) continue;
    // Stationary energy with just these walls, as one system for proxy and pushes.
    ExactMatrix system = ExactMatrix::Zero(D + count, D + count);
    ExactVector right(D + count);
    system.topLeftCorner(D, D) = metric;
    right.head(D) = metric * goal;
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto normal = device.normals.row(rows[static_cast<std::size_t>(k)]);
      system.block(0, D + k, D, 1) = -normal.transpose();
      system.block(D + k, 0, 1, D) = normal;
      system(D + k, D + k) = device.softness;
      right(D + k) = device.offsets(rows[static_cast<std::size_t>(k)]);
    }
    const ExactVector solution = system.fullPivLu().solve(right);
    const ExactVector proxy = solution.head(D);
    const ExactVector gaps = device.normals * proxy - device.offsets;
    bool is_allowed = true;
    for (Eigen::Index i = 0; i < walls; ++i) {
      const bool acts = (set >> i & 1U) != 0;
      // A wall that acts is touched or, where it is soft, pierced; the others are in front.
      is_allowed &= acts ? (device.softness == 0 || gaps(i) <= 0) : gaps(i) >= -1e-17L;
    }
    if (!is_allowed) continue;
    Exact energy = 0.5L * (proxy - goal).dot(metric * (proxy - goal));
    if (device.softness > 0) {
      for (const Eigen::Index i : rows) energy += 0.5L * gaps(i) * gaps(i) / device.softness;
    }
    if (energy >= least_energy) continue;
    least_energy = energy;
    best.proxy = proxy;
    best.full_force = metric * (proxy - goal) / device.scale;
    best.walls = set;
    best.is_found = true;
  }
  if (!best.is_found) return best;
  best.full_device = goal + device.user * best.full_force;

  const Eigen::Index motors = device.actuation.cols();
  unsigned states = 1;
  for (Eigen::Index i = 0; i < motors; ++i) states *= 3;
  Exact nearest = std::numeric_limits<Exact>::infinity();
  for (unsigned state = 0; state < states; ++state) {
    std::vector<Eigen::Index> free;
    ExactVector efforts = ExactVector::Zero(motors);
    bool is_possible = true;
    unsigned rest = state;
    for (Eigen::Index i = 0; i < motors; ++i, rest /= 3) {
      const auto motor = static_cast<std::size_t>(i);
      if (rest % 3 == 0) free.push_back(i);
      if (rest % 3 == 1) efforts(i) = device.least[motor];
      if (rest % 3 == 2) efforts(i) = device.greatest[motor];
      is_possible &= std::isfinite(static_cast<double>(efforts(i)));
    }
    if (!is_possible) continue;
    const ExactVector missing = best.full_force - device.actuation * efforts;
    if (!free.empty()) {
      ExactMatrix columns(D, static_cast<Eigen::Index>(free.size()));
      for (std::size_t k = 0; k < free.size(); ++k) {
        columns.col(static_cast<Eigen::Index>(k)) = device.actuation.col(free[k]);
      }
      const ExactMatrix square = columns.transpose() * device.user * columns;
      const ExactVector solved = square.fullPivLu().solve(columns.transpose() * device.user * missing);
      for (std::size_t k = 0; k < free.size(); ++k) efforts(free[k]) = solved(static_cast<Eigen::Index>(k));
    }
    for (Eigen::Index i = 0; i < motors; ++i) {
      const auto motor = static_cast<std::size_t>(i);
      const Exact slack = 1e-16L * (1 + std::abs(efforts(i)));
      is_possible &= efforts(i) >= device.least[motor] - slack && efforts(i) <= device.greatest[motor] + slack;
    }
    if (!is_possible) continue;
    const ExactVector off = device.actuation * efforts - best.full_force;
    const Exact distance = off.dot(device.user * off);
    if (distance >= nearest) continue;
    nearest = distance;
    best.force = device.actuation * efforts;
    best.has_slack_motor = static_cast<Eigen::Index>(free.size()) < motors;
  }
  best.device = goal + device.user * best.force;
  return best;
}

}  // namespace ghostforce
