// The rivals of core/general_tick.h: the same loop on plain numbers, written for one device and one kind of wall each,
// with nothing that could be another one. As the general loop, they work A and what follows from it out in each tick.
// One thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/general_tick.h"

namespace ghostforce::bench {

struct HandState {
  double x = 0.0, y = 0.0;    // device [m]
  double vx = 0.0, vy = 0.0;  // [m/s]
  double px = 0.0, py = 0.0;  // proxy [m]
  double fx = 0.0, fy = 0.0;  // [N]
  double energy = 0.0;        // [J]
};

// What all of them share: the numbers of the settings, and the step of device and hand.
struct HandNumbers {
  explicit HandNumbers(const GeneralCoefficients& c)
      : dt(c.period),
        damping(c.damping),
        kxx(c.user_stiffness[0][0]),
        kxy(c.user_stiffness[1][0]),
        kyy(c.user_stiffness[1][1]),
        wxx(c.velocity_per_force[0][0]),
        wxy(c.velocity_per_force[1][0]),
        wyy(c.velocity_per_force[1][1]),
        cxx(c.scene.compliances.user[0][0]),
        cxy(c.scene.compliances.user[1][0]),
        cyy(c.scene.compliances.user[1][1]),
        t(c.scene.compliances.tracking[0][0]),
        share(c.scene.compliances.force_share),
        softness(c.scene.compliances.constraint) {}

  void move(double gx, double gy, HandState& s) const {
    const double pull_x = kxx * (gx - s.x) + kxy * (gy - s.y);
    const double pull_y = kxy * (gx - s.x) + kyy * (gy - s.y);
    const double left_x = pull_x + s.fx - damping * s.vx - dt * (kxx * s.vx + kxy * s.vy);
    const double left_y = pull_y + s.fy - damping * s.vy - dt * (kxy * s.vx + kyy * s.vy);
    s.vx += wxx * left_x + wxy * left_y;
    s.vy += wxy * left_x + wyy * left_y;
    s.energy += s.fx * dt * s.vx + s.fy * dt * s.vy;
    s.x += dt * s.vx;
    s.y += dt * s.vy;
  }

  double dt, damping;
  double kxx, kxy, kyy;  // K_u
  double wxx, wxy, wyy;  // velocity per force
  double cxx, cxy, cyy;  // C_u
  double t;              // C_r/τ, the same all round
  double share;          // 1/τ
  double softness;       // 1/k_c
};

// One or two walls and one straight motor. `strategy`: 0 fully actuated, 1 naïve, 2 the cure.
template <std::size_t walls>
class WallsByHand {
 public:
  explicit WallsByHand(const GeneralCoefficients& c) : n_(c) {
    const Vector<2> axis = std::get<FixedAxis>(c.scene.mechanism).direction;
    ax_ = axis.x;
    ay_ = axis.y;
    const Planes<2> planes = linearised(c.scene.constraint, Vector<2>(0.0));
    for (std::size_t i = 0; i < walls; ++i) {
      nx_[i] = planes.walls[i].normal.x;
      ny_[i] = planes.walls[i].normal.y;
      ox_[i] = planes.walls[i].point.x;
      oy_[i] = planes.walls[i].point.y;
    }
  }

  void tick(std::size_t strategy, double gx, double gy, HandState& s) const {
    const double x = s.x;
    const double y = s.y;
    n_.move(gx, gy, s);
    std::array<double, walls> gap;
    bool is_pierced = false;
    for (std::size_t i = 0; i < walls; ++i) {
      gap[i] = nx_[i] * (x - ox_[i]) + ny_[i] * (y - oy_[i]);
      is_pierced |= gap[i] < 0.0;
    }
    s.px = x;
    s.py = y;
    s.fx = s.fy = 0.0;
    if (!is_pierced) return;
    double rx = ax_;  // u = r·f
    double ry = ay_;
    double txx = n_.t, txy = 0.0, tyx = 0.0, tyy = n_.t;
    if (strategy == 2) {
      const double mx = n_.cxx * ax_ + n_.cxy * ay_;
      const double my = n_.cxy * ax_ + n_.cyy * ay_;
      const double square = ax_ * mx + ay_ * my;
      rx = mx / square;
      ry = my / square;
      txx += n_.share * (n_.cxx - mx * rx);
      txy += n_.share * (n_.cxy - mx * ry);
      tyx += n_.share * (n_.cxy - my * rx);
      tyy += n_.share * (n_.cyy - my * ry);
    }
    double px = 0.0;  // the walls' push
    double py = 0.0;
    bool is_found = false;
    for (std::size_t i = 0; i < walls && !is_found; ++i) {
      const double tx = txx * nx_[i] + txy * ny_[i];
      const double ty = tyx * nx_[i] + tyy * ny_[i];
      const double push = -gap[i] / (nx_[i] * tx + ny_[i] * ty + n_.softness);
      if (!(push >= 0.0)) continue;
      is_found = true;
      for (std::size_t k = 0; k < walls; ++k) {
        if (k != i && gap[k] + push * (nx_[k] * tx + ny_[k] * ty) < -negligible_distance) is_found = false;
      }
      px = push * nx_[i];
      py = push * ny_[i];
    }
    if constexpr (walls == 2) {
      if (!is_found) {
        const double t0x = txx * nx_[0] + txy * ny_[0], t0y = tyx * nx_[0] + tyy * ny_[0];
        const double t1x = txx * nx_[1] + txy * ny_[1], t1y = tyx * nx_[1] + tyy * ny_[1];
        const double a = nx_[0] * t0x + ny_[0] * t0y + n_.softness, b = nx_[0] * t1x + ny_[0] * t1y;
        const double c = nx_[1] * t0x + ny_[1] * t0y, d = nx_[1] * t1x + ny_[1] * t1y + n_.softness;
        const double determinant = a * d - b * c;
        const double first = (-gap[0] * d + gap[1] * b) / determinant;
        const double second = (-gap[1] * a + gap[0] * c) / determinant;
        px = first * nx_[0] + second * nx_[1];
        py = first * ny_[0] + second * ny_[1];
      }
    }
    s.px += txx * px + txy * py;
    s.py += tyx * px + tyy * py;
    s.fx = n_.share * px;
    s.fy = n_.share * py;
    if (strategy == 0) return;
    const double effort = rx * s.fx + ry * s.fy;
    s.fx = effort * ax_;
    s.fy = effort * ay_;
  }

 private:
  HandNumbers n_;
  double ax_ = 0.0, ay_ = 0.0;
  std::array<double, walls> nx_{}, ny_{}, ox_{}, oy_{};
};

// One wall and two strings.
class StringsByHand {
 public:
  explicit StringsByHand(const GeneralCoefficients& c) : n_(c) {
    const auto& strings = std::get<Strings>(c.scene.mechanism);
    for (std::size_t i = 0; i < 2; ++i) {
      anchor_x_[i] = strings.anchors[i].x;
      anchor_y_[i] = strings.anchors[i].y;
    }
    const auto& wall = std::get<Wall<2>>(c.scene.constraint);
    nx_ = wall.normal.x;
    ny_ = wall.normal.y;
    ox_ = wall.point.x;
    oy_ = wall.point.y;
  }

  void tick(std::size_t strategy, double gx, double gy, HandState& s) const {
    const double x = s.x;
    const double y = s.y;
    n_.move(gx, gy, s);
    s.px = x;
    s.py = y;
    s.fx = s.fy = 0.0;
    std::array<double, 2> ax, ay;
    for (std::size_t i = 0; i < 2; ++i) {
      const double wx = anchor_x_[i] - x;
      const double wy = anchor_y_[i] - y;
      const double length = std::sqrt(wx * wx + wy * wy);
      ax[i] = wx / length;
      ay[i] = wy / length;
    }
    // B = A⁻¹, in every strategy: what the motors are asked for is told.
    const double determinant = ax[0] * ay[1] - ax[1] * ay[0];
    const double b0x = ay[1] / determinant, b0y = -ax[1] / determinant;
    const double b1x = -ay[0] / determinant, b1y = ax[0] / determinant;
    const double gap = nx_ * (x - ox_) + ny_ * (y - oy_);
    if (gap >= 0.0) return;
    if (strategy != 2) {
      const double push = -gap / (n_.t + n_.softness);
      s.px += n_.t * push * nx_;
      s.py += n_.t * push * ny_;
      s.fx = n_.share * push * nx_;
      s.fy = n_.share * push * ny_;
      if (strategy == 0) return;
      const double u0 = std::fmax(0.0, b0x * s.fx + b0y * s.fy);
      const double u1 = std::fmax(0.0, b1x * s.fx + b1y * s.fy);
      s.fx = u0 * ax[0] + u1 * ax[1];
      s.fy = u0 * ay[0] + u1 * ay[1];
      return;
    }
    const double cnx = n_.cxx * nx_ + n_.cxy * ny_;
    const double cny = n_.cxy * nx_ + n_.cyy * ny_;
    const double ncn = nx_ * cnx + ny_ * cny;
    // Both slack; one of them taut; both taut.
    const auto finish = [&](double push, double u0, double u1) {
      const double missing_x = n_.share * push * nx_ - u0 * ax[0] - u1 * ax[1];
      const double missing_y = n_.share * push * ny_ - u0 * ay[0] - u1 * ay[1];
      const double mx = n_.cxx * missing_x + n_.cxy * missing_y;
      const double my = n_.cxy * missing_x + n_.cyy * missing_y;
      constexpr double slack = 1e-15;
      if ((u0 <= 0.0 && ax[0] * mx + ay[0] * my > slack) || (u1 <= 0.0 && ax[1] * mx + ay[1] * my > slack))
        return false;
      s.px = x + n_.t * push * nx_ + mx;
      s.py = y + n_.t * push * ny_ + my;
      s.fx = u0 * ax[0] + u1 * ax[1];
      s.fy = u0 * ay[0] + u1 * ay[1];
      return true;
    };
    if (finish(-gap / (n_.t + n_.share * ncn + n_.softness), 0.0, 0.0)) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const double mx = n_.cxx * ax[i] + n_.cxy * ay[i];
      const double my = n_.cxy * ax[i] + n_.cyy * ay[i];
      const double square = ax[i] * mx + ay[i] * my;
      const double along = (mx * nx_ + my * ny_);
      const double push = -gap / (n_.t + n_.share * (ncn - along * along / square) + n_.softness);
      const double effort = n_.share * push * along / square;
      if (effort >= 0.0 && finish(push, i == 0 ? effort : 0.0, i == 1 ? effort : 0.0)) return;
    }
    const double push = -gap / (n_.t + n_.softness);
    const double fx = n_.share * push * nx_;
    const double fy = n_.share * push * ny_;
    finish(push, b0x * fx + b0y * fy, b1x * fx + b1y * fy);
  }

 private:
  HandNumbers n_;
  std::array<double, 2> anchor_x_{}, anchor_y_{};
  double nx_ = 0.0, ny_ = 0.0, ox_ = 0.0, oy_ = 0.0;
};

}  // namespace ghostforce::bench
