#include "tests/core/reference_hand_estimate.h"

#include <cmath>
#include <complex>
#include <initializer_list>
#include <numbers>

#include <Eigen/Dense>

namespace ghostforce {
namespace {

using Complex = std::complex<double>;

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double omega_1 = turn * 3.0;
constexpr double omega_2 = turn * 16.0;

// What is left of a signal without its best parabola, by Hann's weights.
Eigen::VectorXd weighted_rest(const Eigen::VectorXd& signal) {
  const Eigen::Index count = signal.size();
  Eigen::MatrixXd powers(count, 3);
  Eigen::VectorXd weights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double way = static_cast<double>(i) / static_cast<double>(count);  // 0 to 1
    powers.row(i) << 1.0, way - 0.5, (way - 0.5) * (way - 0.5);
    weights[i] = 0.5 - 0.5 * std::cos(turn * way);
  }
  const Eigen::VectorXd parabola = powers.colPivHouseholderQr().solve(signal);
  return weights.cwiseProduct(signal - powers * parabola);
}

Complex fourier_sum(const Eigen::VectorXd& signal, double omega, double period) {
  Complex sum = 0.0;
  for (Eigen::Index i = 0; i < signal.size(); ++i) {
    sum += signal[i] * std::polar(1.0, -omega * period * static_cast<double>(i));
  }
  return sum;
}

}  // namespace

ReferenceHandEstimate reference_hand_estimate(std::span<const HandSample> samples, double rate, double window_s) {
  const auto block = static_cast<std::size_t>(std::lround(rate / 250.0));
  const double period = static_cast<double>(block) / rate;
  const auto count = static_cast<std::size_t>(std::lround(window_s / period));
  const std::size_t first = samples.size() - count * block;
  Eigen::VectorXd place = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  Eigen::VectorXd force = place;
  for (std::size_t i = 0; i < count * block; ++i) {
    const HandSample& now = samples[first + i];
    const HandSample& before = samples[first + i - 1];
    place[static_cast<Eigen::Index>(i / block)] += 0.5 * (before.position + now.position) / static_cast<double>(block);
    force[static_cast<Eigen::Index>(i / block)] += before.force / static_cast<double>(block);
  }
  const Eigen::VectorXd x = weighted_rest(place);
  const Eigen::VectorXd f = weighted_rest(force);

  const Complex x_1 = fourier_sum(x, omega_1, period);
  const Complex x_2 = fourier_sum(x, omega_2, period);
  const Complex z_1 = fourier_sum(f, omega_1, period) / x_1;
  const Complex z_2 = fourier_sum(f, omega_2, period) / x_2;
  const double apart = omega_2 * omega_2 - omega_1 * omega_1;
  ReferenceHandEstimate estimate{};
  estimate.mass = (z_1.real() - z_2.real()) / apart;
  estimate.k_u = z_1.real() + omega_1 * omega_1 * estimate.mass;
  estimate.damping = (omega_1 * z_1.imag() + omega_2 * z_2.imag()) / (omega_1 * omega_1 + omega_2 * omega_2);

  // The noise beside a tone: what the hand so estimated does not explain.
  const auto noise = [&](double tone, std::initializer_list<int> bins) {
    double sum_of_logarithms = 0.0;
    for (const int bin : bins) {
      const double omega = tone + turn * bin / window_s;
      const Complex z(estimate.k_u - omega * omega * estimate.mass, omega * estimate.damping);
      sum_of_logarithms += std::log(std::norm(fourier_sum(f, omega, period) - z * fourier_sum(x, omega, period)));
    }
    return 1.78 * std::exp(sum_of_logarithms / static_cast<double>(bins.size()));
  };
  const double noise_1 = noise(omega_1, {-3, -2, 2, 3});
  const double noise_2 = noise(omega_2, {-5, -4, -3, -2, 2, 3, 4, 5});
  estimate.sigma =
      std::sqrt((std::pow(omega_2, 4) * noise_1 / std::norm(x_1) + std::pow(omega_1, 4) * noise_2 / std::norm(x_2)) /
                (2.0 * apart * apart));
  return estimate;
}

}  // namespace ghostforce
