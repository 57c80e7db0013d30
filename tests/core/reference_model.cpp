#include "tests/core/reference_model.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace ghostforce {
namespace {

ReferenceVector solution_of(const ReferenceMatrix& lhs, const ReferenceVector& rhs) {
  return lhs.fullPivLu().solve(rhs);
}

// The proxy of a device that the wall acts on, on whichever side of it.
ReferenceVector proxy_in_contact(const ReferenceModel& model, const ReferenceVector& device) {
  const Eigen::Index D = device.size();
  ReferenceMatrix lhs(D + 1, D + 1);
  ReferenceVector rhs(D + 1);
  lhs << -model.K_t, model.n, model.n.transpose(), 1.0L / model.k_c;
  rhs << -(model.K_t * device), model.n.dot(model.o);
  return solution_of(lhs, rhs).head(D);
}

}  // namespace

double distance(const ReferenceVector& a, const ReferenceVector& b) {
  return static_cast<double>((a - b).norm());
}

double distance(const ReferenceMatrix& a, const ReferenceMatrix& b) {
  return static_cast<double>((a - b).cwiseAbs().maxCoeff());
}

ReferenceMatrix reference_identity(glm::length_t dimension) {
  return ReferenceMatrix::Identity(dimension, dimension);
}

ReferenceMatrix reference_projector_of(const ReferenceMatrix& basis) {
  const ReferenceMatrix gram = basis.transpose() * basis;
  return basis * gram.fullPivLu().solve(ReferenceMatrix(basis.transpose()));
}

ReferenceModel reference_of(const ReferenceVector& o, const ReferenceVector& n, const ReferenceMatrix& P_A,
                            const Stiffnesses& k, Extended ratio) {
  const ReferenceMatrix P_N = ReferenceMatrix::Identity(o.size(), o.size()) - P_A;
  return {o, n, k.k_r * P_A, k.k_t * P_A + k.k_t / ratio * P_N, k.k_u, k.k_c};
}

ReferenceEquilibrium reference_equilibrium(const ReferenceModel& model, const ReferenceVector& goal) {
  const Eigen::Index D = goal.size();
  ReferenceMatrix lhs = ReferenceMatrix::Zero(2 * D + 1, 2 * D + 1);
  ReferenceVector rhs = ReferenceVector::Zero(2 * D + 1);
  lhs.block(0, 0, D, D) = -model.K_t;
  lhs.block(0, D, D, D) = model.K_t;
  lhs.block(0, 2 * D, D, 1) = model.n;
  lhs.block(D, 0, D, D) = model.K_r;
  lhs.block(D, D, D, D) = -model.K_r - model.k_u * ReferenceMatrix::Identity(D, D);
  rhs.segment(D, D) = -model.k_u * goal;
  lhs.block(2 * D, 0, 1, D) = model.n.transpose();
  lhs(2 * D, 2 * D) = 1.0L / model.k_c;
  rhs[2 * D] = model.n.dot(model.o);
  const ReferenceVector x = solution_of(lhs, rhs);
  const ReferenceVector proxy = x.head(D);
  const ReferenceVector device = x.segment(D, D);
  return {proxy, device, model.K_r * (proxy - device)};
}

ReferenceVector reference_proxy(const ReferenceModel& model, const ReferenceVector& device) {
  return model.n.dot(device - model.o) < 0.0L ? proxy_in_contact(model, device) : device;
}

ReferenceState reference_start(const ReferenceVector& goal) {
  const ReferenceVector zero = ReferenceVector::Zero(goal.size());
  return {goal, goal, zero, zero};
}

ReferenceState reference_tick(const ReferenceLoop& loop, const ReferenceState& before, const ReferenceVector& goal) {
  const ReferenceModel& model = loop.model;
  const Extended dt = loop.period;
  const ReferenceMatrix I = ReferenceMatrix::Identity(goal.size(), goal.size());
  const ReferenceMatrix inertia = (loop.mass + dt * loop.damping + dt * dt * model.k_u) * I;
  const ReferenceVector momentum = loop.mass * before.velocity + dt * (model.k_u * goal + model.K_r * before.proxy -
                                                                       (model.k_u * I + model.K_r) * before.device);
  ReferenceState now;
  now.velocity = solution_of(inertia, momentum);
  now.device = before.device + dt * now.velocity;
  now.proxy = reference_proxy(model, before.device);
  now.force = model.K_r * (now.proxy - now.device);
  now.energy = before.energy + before.force.dot(now.device - before.device);
  return now;
}

double reference_slowest_mode(const ReferenceLoop& loop) {
  const Eigen::Index D = loop.model.n.size();
  ReferenceModel at_origin = loop.model;
  at_origin.o.setZero();
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(D, D);
  Eigen::MatrixXd contact(D, D);  // a linear map is known by what it does to each axis
  for (Eigen::Index i = 0; i < D; ++i) {
    contact.col(i) = proxy_in_contact(at_origin, ReferenceVector::Unit(D, i)).cast<double>();
  }
  const auto dt = static_cast<double>(loop.period);
  const auto k_u = static_cast<double>(loop.model.k_u);
  const auto mass = static_cast<double>(loop.mass);
  const double inertia = mass + dt * static_cast<double>(loop.damping) + dt * dt * k_u;
  const Eigen::MatrixXd K_r = loop.model.K_r.cast<double>();
  const Eigen::MatrixXd from_device = -dt / inertia * (k_u * I + K_r);
  const Eigen::MatrixXd from_proxy = dt / inertia * K_r;
  const Eigen::MatrixXd from_velocity = mass / inertia * I;
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(D, D);
  double slowest = 0.0;
  for (const Eigen::MatrixXd& proxy : {I, contact}) {
    Eigen::MatrixXd A(3 * D, 3 * D);
    A << I + dt * from_device, dt * from_proxy, dt * from_velocity,  // q_h,k
        proxy, none, none,                                           // q_p,k
        from_device, from_proxy, from_velocity;                      // v_k
    slowest = std::max(slowest, Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues().cwiseAbs().maxCoeff());
  }
  return slowest;
}

}  // namespace ghostforce
