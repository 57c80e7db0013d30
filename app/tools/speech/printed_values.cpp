#include "app/tools/speech/printed_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ghostforce {
namespace {

constexpr std::string_view unknown = "-";

std::string with_sign(double value, double least_shown, std::string digits) {
  return value <= -least_shown ? "-" + digits : digits;
}

std::string force_column(const std::optional<double>& newton) {
  if (!newton || !std::isfinite(*newton)) return std::string(unknown);
  return with_sign(*newton, least_shown_force, force_number(*newton));
}

std::string slide_column(const std::optional<double>& metres) {
  if (!metres || !std::isfinite(*metres)) return std::string(unknown);
  return slide_number(*metres);
}

// What would end a column or a line becomes a space.
std::string on_one_line(std::string words) {
  std::ranges::replace_if(
      words, [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
  return words;
}

// All columns but the time's, which is the last.
std::string columns_of(const StageReading& reading) {
  const StageNumbers& numbers = reading.numbers;
  return fmt::format("{}\t{}\t{}\t{}\t{}\t{}", on_one_line(reading.sentence), strategy(reading.strategy).name,
                     force_column(numbers.force), force_column(numbers.wall_share), force_column(numbers.ghost_force),
                     slide_column(numbers.slide));
}

std::string with_time(const std::string& columns, double time_s) {
  return fmt::format("{}\t{:.3f}\n", columns, time_s);
}

}  // namespace

std::string printed_header() {
  return "# sentence\tstrategy\tforce N\twall's share N\tghost force N\tslide mm\ttime s\n";
}

std::string printed_line(const StageReading& reading, double time_s) {
  return with_time(columns_of(reading), time_s);
}

bool PrintedValues::advance(double interval_s) noexcept {
  since_s_ += interval_s;
  return since_s_ >= period_s_;
}

std::optional<std::string> PrintedValues::poll(const StageReading& reading, double time_s) {
  std::string columns = columns_of(reading);
  if (columns == printed_) return std::nullopt;
  printed_ = std::move(columns);
  since_s_ = 0.0;
  return with_time(printed_, time_s);
}

}  // namespace ghostforce
