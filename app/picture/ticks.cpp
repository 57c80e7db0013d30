#include "app/picture/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "app/picture/text.h"

namespace ghostforce {
namespace {

constexpr double round_off = 1e-9;  // of a step: what is that near to a tick is on it

// m · 10^e, rounded once: 3 · 0.1 is not 0.3.
double times_power(double m, int e) {
  return e < 0 ? m / std::pow(10.0, -e) : m * std::pow(10.0, e);
}

std::string superscript(int number) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string words = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) words += digits[static_cast<std::size_t>(digit - '0')];
  return words;
}

std::string power_words(double value) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  const int exponent = static_cast<int>(std::floor(std::log10(size) + round_off));
  const double multiple = size / std::pow(10.0, exponent);
  return fmt::format("{}{}10{}", value < 0.0 ? "−" : "",
                     std::abs(multiple - 1.0) < round_off ? "" : fmt::format("{:.6g}·", multiple),
                     superscript(exponent));
}

constexpr double greatest_plain = 99999.5;
constexpr int finest_plain = -4;  // power of ten

bool have_room(const Ticks& ticks, const TickRequest& request) {
  const auto at = [&](const Tick& tick) {
    return request.length * place_on_axis(tick.value, ticks.least, ticks.greatest, request.is_logarithmic);
  };
  for (std::size_t i = 1; i < ticks.named.size(); ++i) {
    const Tick& before = ticks.named[i - 1];
    const Tick& tick = ticks.named[i];
    const double needed = 0.5 * (request.extent(before.words) + request.extent(tick.words)) + request.gap;
    if (at(tick) - at(before) < needed) return false;
  }
  return true;
}

// Every step · 10^exponent.
Ticks linear_ticks(const TickRequest& request, int step, int exponent) {
  const double width = times_power(step, exponent);
  double first = std::ceil(request.least / width - round_off);
  double last = std::floor(request.greatest / width + round_off);
  Ticks ticks{request.least, request.greatest, {}, {}};
  if (request.rounds_out) {
    first = std::floor(request.least / width + round_off);
    last = std::ceil(request.greatest / width - round_off);
    ticks.least = times_power(first * step, exponent);
    ticks.greatest = times_power(last * step, exponent);
  }
  const bool is_plain =
      exponent >= finest_plain && std::max(std::abs(ticks.least), std::abs(ticks.greatest)) < greatest_plain;
  for (double i = first; i <= last; i += 1.0) {
    const double value = times_power(i * step, exponent) + 0.0;  // −0 is a zero too
    ticks.named.push_back({value, is_plain ? decimal_text(value, std::max(0, -exponent)) : power_words(value)});
  }
  return ticks;
}

// Neighbours so near to each other that not even the gap between their words has room. Words cost too much to be made
// for such. (Rounding out only brings them nearer.)
bool are_crowded(const TickRequest& request, double step) {
  const double range = request.greatest - request.least;
  return 2.0 * step <= range && request.length * step < (1.0 - round_off) * request.gap * range;
}

// Steps from a hundredth of the axis to all of it.
Ticks choose_linear_ticks(const TickRequest& request) {
  Ticks ticks{};
  const int finest = static_cast<int>(std::floor(std::log10((request.greatest - request.least) / 100.0)));
  for (int exponent = finest; exponent <= finest + 3; ++exponent) {
    for (const int step : {1, 2, 5}) {
      if (are_crowded(request, times_power(step, exponent))) continue;
      ticks = linear_ticks(request, step, exponent);
      if (have_room(ticks, request)) return ticks;
    }
  }
  ticks.named.clear();
  return ticks;
}

// The given multiples of every `stride`th power of ten; 1 is among them.
Ticks logarithmic_ticks(const TickRequest& request, const std::vector<int>& multiples, int stride) {
  const int first = static_cast<int>(std::floor(std::log10(request.least) - round_off)) - stride;
  const int last = static_cast<int>(std::ceil(std::log10(request.greatest) + round_off)) + stride;
  std::vector<Tick> all;
  for (int decade = first; decade <= last; ++decade) {
    if (decade % stride != 0) continue;
    for (const int multiple : multiples) {
      const double value = times_power(multiple, decade);
      const bool is_plain = decade >= finest_plain && value < greatest_plain;
      all.push_back({value, is_plain ? decimal_text(value, std::max(0, -decade)) : power_words(value)});
    }
  }
  Ticks ticks{request.least, request.greatest, {}, {}};
  if (request.rounds_out) {
    for (const Tick& tick : all) {
      if (tick.value <= request.least * (1.0 + round_off)) ticks.least = tick.value;
    }
    const auto is_beyond = [&](const Tick& tick) { return tick.value >= request.greatest * (1.0 - round_off); };
    ticks.greatest = std::ranges::find_if(all, is_beyond)->value;
  }
  const auto is_on_axis = [&](double value) {
    return value >= ticks.least * (1.0 - round_off) && value <= ticks.greatest * (1.0 + round_off);
  };
  std::ranges::copy_if(all, std::back_inserter(ticks.named), [&](const Tick& tick) { return is_on_axis(tick.value); });
  // Over many decades they would be a texture.
  if (ticks.greatest / ticks.least <= 1e5) {
    for (int decade = first; decade <= last; ++decade) {
      for (int multiple = 1; multiple <= 9; ++multiple) {
        const double value = times_power(multiple, decade);
        if (is_on_axis(value)) ticks.fine.push_back(value);
      }
    }
  }
  return ticks;
}

Ticks choose_logarithmic_ticks(const TickRequest& request) {
  // Within a third of a decade there may be no such number: evenly spaced ones take over.
  if (request.greatest / request.least < 2.0) return choose_linear_ticks(request);
  Ticks ticks = logarithmic_ticks(request, {1, 2, 5}, 1);
  for (const int stride : {1, 2, 5, 10, 50, 100}) {
    if (have_room(ticks, request)) return ticks;
    ticks = logarithmic_ticks(request, {1}, stride);
  }
  if (!have_room(ticks, request)) ticks.named.clear();
  return ticks;
}

// An axis needs two different ends.
TickRequest with_width(TickRequest request) {
  const double least_width = 1e-12 * std::max(std::abs(request.least), std::abs(request.greatest));
  if (request.greatest - request.least > least_width && request.greatest > request.least) return request;
  if (request.is_logarithmic) {
    request.least /= 2.0;
    request.greatest *= 2.0;
  } else {
    const double half = request.least == 0.0 ? 1.0 : 0.5 * std::abs(request.least);
    request.least -= half;
    request.greatest += half;
  }
  return request;
}

}  // namespace

double place_on_axis(double value, double least, double greatest, bool is_logarithmic) noexcept {
  if (!is_logarithmic) return (value - least) / (greatest - least);
  if (!(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / least) / std::log(greatest / least);
}

Ticks choose_ticks(const TickRequest& request) {
  const TickRequest wide = with_width(request);
  return wide.is_logarithmic ? choose_logarithmic_ticks(wide) : choose_linear_ticks(wide);
}

}  // namespace ghostforce
