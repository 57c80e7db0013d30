// HandEstimator: how stiff the hand is while it works, told by two small known tones in the motor's force
// (measuring_tones.h). The wall pushes with a force that follows the handle's place, so that a hand that is only
// watched looks like minus the wall; the tones tell the two apart, because everything that the motor gives is measured.
//
// Over the last T, along the motor, with X and F the Fourier sums of the handle's place x and of the motor's force f at
// ω₁ = 2π·3/s and ω₂ = 2π·16/s (best parabola taken off, Hann's weights), a hand of mass, damping and spring has
//     Z_i = F_i/X_i = k − ω_i² m + j ω_i b
//     m   = (Re Z₁ − Re Z₂)/(ω₂² − ω₁²)
//     k̂   = Re Z₁ + ω₁² m
//     b   = (ω₁ Im Z₁ + ω₂ Im Z₂)/(ω₁² + ω₂²)
//     S_i = 1.78 × the geometric mean of |F − Z(k̂, b, m) X|² over quiet bins: ±{2, 3}/T at ω₁, ±{2 … 5}/T at ω₂
//     σ²  = (ω₂⁴ S₁/|X₁|² + ω₁⁴ S₂/|X₂|²) / (2 (ω₂² − ω₁²)²)
// Derivation, limits and tests: docs/theory.md, "The hand, measured live".
//
// k̂ is the stiffness at 3 Hz, along the motor. A plain value of fixed size: adding a sample takes the same short time
// however long the window is, and allocates nothing. Any one thread. SI units. HandReading tells other threads of it.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace ghostforce {

// What the tones sound at [Hz].
inline constexpr double low_tone_hz = 3.0;
inline constexpr double high_tone_hz = 16.0;

// Why nobody can tell how stiff the hand is.
enum class HandUnknown : std::uint8_t {
  none,             // it is known
  collecting,       // the window is not full yet
  no_tones,         // nothing measures the hand
  no_contact,       // within the window the handle was not at the wall throughout
  at_limit,         // within the window the motor was at its limit
  damaged,          // a sample is missing, or is no number
  rate_too_low,     // fewer samples than the tones need
  too_much_tremor,  // the hand moves too much by itself for the tones to be heard
  out_of_range,     // no hand is like that: the motion does not come from the tones
};
inline constexpr std::size_t hand_unknown_count = 9;
// For a person: what is so, and what to do. A whole sentence; empty for `none`.
std::string_view sentence_of(HandUnknown why) noexcept;

struct HandEstimate {
  HandUnknown why = HandUnknown::collecting;
  // 0 where there is no number. too_much_tremor and out_of_range come with one where k̂ > 0; it is not to be relied on.
  double k_u = 0.0;      // k̂ [N/m]
  double sigma = 0.0;    // of it, one standard deviation [N/m]
  double mass = 0.0;     // m, of hand and device [kg]
  double damping = 0.0;  // b, of hand and device [N·s/m]

  bool is_known() const noexcept { return why == HandUnknown::none; }
  bool has_number() const noexcept { return k_u != 0.0; }
  friend bool operator==(const HandEstimate&, const HandEstimate&) = default;
};

// One tick, along the motor's axis.
struct HandSample {
  double position = 0.0;     // of the handle, at this tick [m]
  double force = 0.0;        // everything that the motor gives from this tick to the next, tones included [N]
  double tone = 0.0;         // of it, the tones [N]
  bool in_contact = false;   // the wall acts
  bool is_at_limit = false;  // the motor gives less than it was asked for
};

class HandEstimator {
 public:
  static constexpr double usual_window_s = 2.0;
  static constexpr double longest_window_s = 4.0;
  // How often it is worth asking [s].
  static constexpr double period_s = 0.1;
  // Fewer samples a second cannot be used; more are averaged, down to no fewer than three quarters of this [Hz].
  static constexpr double least_rate = 250.0;
  // Nor can more, which would be ticks that no clock of a computer tells apart [Hz].
  static constexpr double highest_rate = 1e9;

  // `rate`: samples per second [Hz]. `window_s`: T, from the usual to the longest.
  explicit HandEstimator(double rate, double window_s = usual_window_s) noexcept;

  // Forgets all samples, as after a gap. `why`: what is told until the window is full again.
  void reset(HandUnknown why = HandUnknown::collecting) noexcept;

  // The next tick. A sample that cannot be used resets by itself.
  void add(const HandSample& sample) noexcept;

  // How much of the window is filled, 0 to 1.
  double filled() const noexcept;

  HandEstimate estimate() const noexcept;

 private:
  // Bins of 1/T: as far round the tones as the quiet ones reach, and one more for Hann's weights.
  static constexpr std::size_t low_reach = 4;
  static constexpr std::size_t high_reach = 6;
  static constexpr std::size_t low_bins = 2 * low_reach + 1;
  static constexpr std::size_t bin_count = low_bins + 2 * high_reach + 1;
  static constexpr std::size_t longest = 1504;  // averaged samples: longest_window_s at 3/2 of least_rate, and a few
  using Complex = std::complex<double>;
  using Bins = std::array<Complex, bin_count>;

  // Σ x, Σ j x, Σ j² x over some averages, where j counts from their first.
  using Moments = std::array<double, 3>;
  // One signal within the window. Whatever enters the Fourier sums leaves them at the same angle, so that rounding does
  // not add up; where moments slide, it does, and fresh ones replace them once in a window.
  struct Signal {
    std::array<double, longest> window{};
    std::array<double, bin_count> cosines{};
    std::array<double, bin_count> sines{};
    Moments moments{};
    Moments fresh_moments{};
    double sum = 0.0;  // of what is averaged next
  };

  void take_average() noexcept;
  void take(double position, double force) noexcept;
  Bins weighted_bins(const Signal& signal) const noexcept;

  // What follows from rate and window.
  bool is_rate_usable_;
  std::size_t averaged_;                       // samples in one average
  std::size_t length_;                         // of the window, in averages
  double bin_width_;                           // 1/T, as an angular frequency [rad/s]
  std::size_t longest_silence_;                // of the tones [samples]
  double share_per_sample_;                    // of the window
  std::array<std::size_t, bin_count> bins_{};  // as multiples of 1/T
  std::array<double, longest> cosine_{};       // of 2π i / length
  std::array<double, longest> sine_{};
  Bins ramp_{};      // Fourier sums of u = j − (length − 1)/2
  Bins parabola_{};  // those of u²

  HandUnknown why_ = HandUnknown::collecting;  // it is not full
  HandSample before_{};
  bool has_before_ = false;
  std::size_t silence_ = 0;                      // samples without a tone, up to now
  std::size_t in_average_ = 0;                   // samples in the sum that is averaged next
  std::size_t filled_ = 0;                       // averages in the window
  std::size_t fresh_ = 0;                        // averages in the fresh moments
  std::size_t place_ = 0;                        // of the next average in the window
  std::array<std::size_t, bin_count> angles_{};  // bin times place, as an index of the tables
  Signal position_;
  Signal force_;
};

// What the servo tells of the hand that it measures. Trivially copyable: it crosses threads whole.
struct HandReading {
  bool is_measuring = false;  // the tones are wanted
  double tone_gain = 0.0;     // how much of them sounds, 0 to 1
  double filled = 0.0;        // how much of the window is, 0 to 1
  HandEstimate estimate{};    // the newest; a new one every HandEstimator::period_s
  double at_s = 0.0;          // when it was made, model time [s]
  double believed_k_u = 0.0;  // k̂_u in use [N/m]; where it follows the hand, the servo alone changes it
};
static_assert(std::is_trivially_copyable_v<HandReading>);

}  // namespace ghostforce
