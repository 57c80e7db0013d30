#include "core/hand_estimator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ghostforce {
namespace {

constexpr double low_tone = 2.0 * std::numbers::pi * low_tone_hz;    // ω₁ [rad/s]
constexpr double high_tone = 2.0 * std::numbers::pi * high_tone_hz;  // ω₂ [rad/s]

// A hand is known where σ/k̂ is below this.
constexpr double greatest_relative_sigma = 0.2;
// Beyond these there is no hand at a handle [N/m], [kg].
constexpr double least_stiffness = 20.0;
constexpr double greatest_stiffness = 2000.0;
constexpr double least_mass = 0.02;
constexpr double greatest_mass = 1.5;

// Far more than any desktop device reaches or gives: numbers beyond are damaged [m], [N].
constexpr double farthest = 10.0;
constexpr double greatest_force = 1e4;

// Tones pass through zero, but never stay there for so long [s]. Less than this is none: along an axis that they do not
// sound along, rounding leaves something [N].
constexpr double longest_silence_s = 0.05;
constexpr double quietest_tone = 1e-6;

// The geometric mean of exponentially distributed powers is lower than their mean by e to Euler's constant.
constexpr double mean_over_geometric_mean = 1.78;

bool is_usable(const HandSample& sample) noexcept {
  // NaN fails every comparison, so it counts as damaged.
  return std::abs(sample.position) <= farthest && std::abs(sample.force) <= greatest_force &&
         std::abs(sample.tone) <= greatest_force;
}

// The next average, the j-th from the first of them.
void append(double x, std::size_t j, std::array<double, 3>& moments) noexcept {
  const double place = static_cast<double>(j);
  moments[0] += x;
  moments[1] += place * x;
  moments[2] += place * place * x;
}

// The first goes, and every j becomes one less.
void remove_oldest(double oldest, std::array<double, 3>& moments) noexcept {
  moments[2] -= 2.0 * moments[1] - moments[0] + oldest;
  moments[1] -= moments[0] - oldest;
  moments[0] -= oldest;
}

std::complex<double> impedance(const HandEstimate& hand, double frequency) noexcept {
  return {hand.k_u - hand.mass * frequency * frequency, hand.damping * frequency};
}

}  // namespace

std::string_view sentence_of(HandUnknown why) noexcept {
  switch (why) {
    case HandUnknown::none:
      break;
    case HandUnknown::collecting:
      return "The measurement has not lasted long enough yet: it takes 2 s.";
    case HandUnknown::no_tones:
      return "The tones did not sound for the whole of the last 2 s. On a real device, turn its motors on.";
    case HandUnknown::no_contact:
      return "The handle was not at the wall throughout the last 2 s: keep pressing into it.";
    case HandUnknown::at_limit:
      return "The force was at its limit within the last 2 s: press less deep.";
    case HandUnknown::damaged:
      return "Samples are missing or damaged within the last 2 s.";
    case HandUnknown::rate_too_low:
      return "The loop is too slow to hear the tones: it needs at least 250 ticks per second.";
    case HandUnknown::too_much_tremor:
      return "The hand moves too much by itself: hold it still.";
    case HandUnknown::out_of_range:
      return "This does not move like a hand in the wall. Hold the handle with a medium grip, and try again.";
  }
  return {};
}

HandEstimator::HandEstimator(double rate, double window_s) noexcept
    : is_rate_usable_(rate >= least_rate && rate <= highest_rate) {
  const double usable_rate = is_rate_usable_ ? rate : least_rate;
  averaged_ = static_cast<std::size_t>(std::max(1L, std::lround(usable_rate / least_rate)));
  const double averaged_rate = usable_rate / static_cast<double>(averaged_);
  const double window = std::clamp(window_s, usual_window_s, longest_window_s);
  length_ = std::min(static_cast<std::size_t>(std::lround(window * averaged_rate)), longest);
  const double length = static_cast<double>(length_);
  const double bins_per_hz = length / averaged_rate;
  bin_width_ = 2.0 * std::numbers::pi / bins_per_hz;
  longest_silence_ = static_cast<std::size_t>(std::ceil(longest_silence_s * usable_rate));
  share_per_sample_ = 1.0 / (length * static_cast<double>(averaged_));
  const auto low_bin = static_cast<std::size_t>(std::lround(low_tone_hz * bins_per_hz));
  const auto high_bin = static_cast<std::size_t>(std::lround(high_tone_hz * bins_per_hz));
  for (std::size_t i = 0; i < bin_count; ++i) {
    bins_[i] = i < low_bins ? low_bin - low_reach + i : high_bin - high_reach + (i - low_bins);
  }
  for (std::size_t i = 0; i < length_; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / length;
    cosine_[i] = std::cos(angle);
    sine_[i] = std::sin(angle);
  }
  // With z = e^(−2πj bin/length), whose power of length is 1:  Σ i z^i = length/(z − 1),
  // Σ i² z^i = (length² − 2 z Σ i z^i)/(z − 1); and Σ z^i = 0.
  for (std::size_t i = 0; i < bin_count; ++i) {
    const Complex z = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(bins_[i]) / length);
    ramp_[i] = length / (z - 1.0);
    parabola_[i] = (length * length - 2.0 * z * ramp_[i]) / (z - 1.0) - (length - 1.0) * ramp_[i];
  }
  reset();
}

void HandEstimator::reset(HandUnknown why) noexcept {
  why_ = is_rate_usable_ ? why : HandUnknown::rate_too_low;
  if (!std::exchange(has_before_, false)) return;
  in_average_ = filled_ = fresh_ = place_ = 0;
  angles_ = {};
  position_ = {};
  force_ = {};
}

void HandEstimator::add(const HandSample& sample) noexcept {
  if (!is_rate_usable_) return;
  silence_ = std::abs(sample.tone) < quietest_tone ? silence_ + 1 : 0;
  if (!is_usable(sample)) return reset(HandUnknown::damaged);
  if (!sample.in_contact) return reset(HandUnknown::no_contact);
  if (sample.is_at_limit) return reset(HandUnknown::at_limit);
  if (silence_ > longest_silence_) return reset(HandUnknown::no_tones);
  // A window begins with a tone.
  if (!has_before_ && silence_ > 0) return;
  const HandSample before = std::exchange(before_, sample);
  if (!std::exchange(has_before_, true)) {
    // They sound now, and it only takes its time.
    if (why_ == HandUnknown::no_tones) why_ = HandUnknown::collecting;
    return;
  }
  // The force of the tick before has acted from there to here, on the average halfway.
  position_.sum += 0.5 * (before.position + sample.position);
  force_.sum += before.force;
  if (++in_average_ == averaged_) take_average();
}

void HandEstimator::take_average() noexcept {
  const double share = 1.0 / static_cast<double>(std::exchange(in_average_, 0));
  take(share * std::exchange(position_.sum, 0.0), share * std::exchange(force_.sum, 0.0));
  filled_ = std::min(filled_ + 1, length_);
  if (++fresh_ == length_) {
    // They are of exactly the window's averages.
    for (Signal* const signal : {&position_, &force_}) signal->moments = std::exchange(signal->fresh_moments, {});
    fresh_ = 0;
  }
  place_ = place_ + 1 < length_ ? place_ + 1 : 0;
  for (std::size_t i = 0; i < bin_count; ++i) {
    const std::size_t angle = angles_[i] + bins_[i];
    angles_[i] = angle < length_ ? angle : angle - length_;
  }
}

void HandEstimator::take(double position, double force) noexcept {
  // Until the window is full, the oldest are 0.
  const double oldest_position = std::exchange(position_.window[place_], position);
  const double oldest_force = std::exchange(force_.window[place_], force);
  for (std::size_t i = 0; i < bin_count; ++i) {
    const double cosine = cosine_[angles_[i]];
    const double sine = sine_[angles_[i]];
    position_.cosines[i] += (position - oldest_position) * cosine;
    position_.sines[i] += (position - oldest_position) * sine;
    force_.cosines[i] += (force - oldest_force) * cosine;
    force_.sines[i] += (force - oldest_force) * sine;
  }
  if (filled_ == length_) {
    remove_oldest(oldest_position, position_.moments);
    remove_oldest(oldest_force, force_.moments);
  }
  const std::size_t newest = std::min(filled_, length_ - 1);
  append(position, newest, position_.moments);
  append(force, newest, force_.moments);
  append(position, fresh_, position_.fresh_moments);
  append(force, fresh_, force_.fresh_moments);
}

double HandEstimator::filled() const noexcept {
  if (filled_ == length_) return 1.0;
  return static_cast<double>(filled_ * averaged_ + in_average_) * share_per_sample_;
}

// The signal less its best parabola, with Hann's weights: the Fourier sums of the inner bins; the outermost ones of each
// tone stay 0.
HandEstimator::Bins HandEstimator::weighted_bins(const Signal& signal) const noexcept {
  const auto& [sum_0, sum_1, sum_2] = signal.moments;
  const double length = static_cast<double>(length_);
  const double middle = 0.5 * (length - 1.0);
  // Least squares over u = j − middle, whose odd powers have no sum.
  const double u_2 = length * (length * length - 1.0) / 12.0;                                   // Σ u²
  const double u_4 = length * (length * length - 1.0) * (3.0 * length * length - 7.0) / 240.0;  // Σ u⁴
  const double x_1 = sum_1 - middle * sum_0;                                                    // Σ u x
  const double x_2 = sum_2 - 2.0 * middle * sum_1 + middle * middle * sum_0;                    // Σ u² x
  const double slope = x_1 / u_2;
  const double bend = (length * x_2 - u_2 * sum_0) / (length * u_4 - u_2 * u_2);
  Bins plain;
  for (std::size_t i = 0; i < bin_count; ++i) {
    // Turned back to the window's first average, which stands at place_.
    const Complex turn{cosine_[angles_[i]], sine_[angles_[i]]};
    plain[i] = Complex(signal.cosines[i], -signal.sines[i]) * turn - slope * ramp_[i] - bend * parabola_[i];
  }
  Bins weighted{};
  const auto weigh = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) weighted[i] = 0.5 * plain[i] - 0.25 * (plain[i - 1] + plain[i + 1]);
  };
  weigh(1, low_bins - 2);
  weigh(low_bins + 1, bin_count - 2);
  return weighted;
}

HandEstimate HandEstimator::estimate() const noexcept {
  if (filled_ < length_) return {.why = why_};
  const Bins X = weighted_bins(position_);
  const Bins F = weighted_bins(force_);
  constexpr std::size_t low = low_reach;
  constexpr std::size_t high = low_bins + high_reach;
  const Complex z_1 = F[low] / X[low];
  const Complex z_2 = F[high] / X[high];
  constexpr double low_2 = low_tone * low_tone;
  constexpr double high_2 = high_tone * high_tone;
  HandEstimate hand;
  hand.mass = (z_1.real() - z_2.real()) / (high_2 - low_2);
  hand.k_u = z_1.real() + low_2 * hand.mass;
  hand.damping = (low_tone * z_1.imag() + high_tone * z_2.imag()) / (low_2 + high_2);

  // What the hand does by itself, as a power beside the tone.
  const auto power_around = [&](std::size_t tone, std::size_t nearest, std::size_t farthest_bin) {
    double logarithms = 0.0;
    for (std::size_t away = nearest; away <= farthest_bin; ++away) {
      for (const std::size_t i : {tone - away, tone + away}) {
        logarithms += std::log(std::norm(F[i] - impedance(hand, bin_width_ * static_cast<double>(bins_[i])) * X[i]));
      }
    }
    const double count = 2.0 * static_cast<double>(farthest_bin - nearest + 1);
    return mean_over_geometric_mean * std::exp(logarithms / count);
  };
  const double noise_1 = power_around(low, 2, low_reach - 1) / std::norm(X[low]);
  const double noise_2 = power_around(high, 2, high_reach - 1) / std::norm(X[high]);
  hand.sigma = std::sqrt(0.5 * (high_2 * high_2 * noise_1 + low_2 * low_2 * noise_2)) / (high_2 - low_2);

  const bool is_finite =
      std::isfinite(hand.k_u) && std::isfinite(hand.sigma) && std::isfinite(hand.mass) && std::isfinite(hand.damping);
  const bool is_hand = hand.k_u > least_stiffness && hand.k_u < greatest_stiffness && hand.mass > least_mass &&
                       hand.mass < greatest_mass && hand.damping > 0.0;
  if (is_finite && !(hand.sigma < greatest_relative_sigma * std::abs(hand.k_u))) {
    hand.why = HandUnknown::too_much_tremor;
  } else {
    hand.why = is_finite && is_hand ? HandUnknown::none : HandUnknown::out_of_range;
  }
  // Less than nothing is no stiffness, however well it is known.
  if (!is_finite || !(hand.k_u > 0.0)) return {.why = hand.why};
  return hand;
}

}  // namespace ghostforce
