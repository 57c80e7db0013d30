// Where everything comes to rest, by solving (6)(7) as they stand: what the closed forms of core/equilibrium.h are
// checked against. Pure, any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/actuation.h"
#include "core/equilibrium.h"

namespace ghostforce {

// Solves the system in place, row by row [A | b], with partial pivoting; the
// solution ends up in the last column.
template <std::size_t N>
void solve(std::array<std::array<double, N + 1>, N>& rows) noexcept {
  for (std::size_t column = 0; column < N; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < N; ++row) {
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    }
    std::swap(rows[column], rows[pivot]);
    for (std::size_t row = 0; row < N; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= N; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  for (std::size_t row = 0; row < N; ++row) rows[row][N] /= rows[row][row];
}

// (6)   K_t (q_h − q_p) + n λ = 0,   λ/k_c = n·(o − q_p)       (k_c = ∞: the proxy is on the wall)
// (7)   k_u (q_u − q_h) + K_r (q_p − q_h) = 0
// One linear system of 2D + 1 unknowns, by Gaussian elimination; works for any coupling.
template <glm::length_t D>
Equilibrium<D> equilibrium_by_linear_solve(const Wall<D>& wall, const Coupling<D>& coupling, double k_u, double k_c,
                                           const Vector<D>& goal) noexcept {
  const double d = depth(wall, goal);
  if (!(d > 0.0)) return {goal, goal, goal, projection(wall, goal), Vector<D>(0.0), false};

  // Unknowns: q_p − q_u, then q_h − q_u, then λ. Relative to the goal, so that
  // a wall far from the origin costs nothing.
  constexpr std::size_t n = D;
  std::array<std::array<double, 2 * n + 2>, 2 * n + 1> rows{};
  for (std::size_t i = 0; i < n; ++i) {
    const auto gi = static_cast<glm::length_t>(i);
    for (std::size_t j = 0; j < n; ++j) {
      const auto gj = static_cast<glm::length_t>(j);
      const double tracking = coupling.tracking[gj][gi];
      const double rendering = coupling.rendering[gj][gi];
      rows[i][j] = -tracking;  // (6)
      rows[i][n + j] = tracking;
      rows[n + i][j] = rendering;  // (7)
      rows[n + i][n + j] = -rendering;
    }
    rows[i][2 * n] = wall.normal[gi];
    rows[n + i][n + i] -= k_u;
    rows[2 * n][i] = wall.normal[gi];
  }
  rows[2 * n][2 * n] = 1.0 / k_c;
  rows[2 * n][2 * n + 1] = d;
  solve(rows);

  Vector<D> proxy;
  Vector<D> device;
  for (std::size_t i = 0; i < n; ++i) {
    proxy[static_cast<glm::length_t>(i)] = rows[i][2 * n + 1];
    device[static_cast<glm::length_t>(i)] = rows[n + i][2 * n + 1];
  }
  const Vector<D> force = coupling.rendering * (proxy - device);
  return {goal, goal + proxy, goal + device, projection(wall, goal + proxy), force, true};
}

}  // namespace ghostforce
