#include "app/tools/doctor/operator.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"

namespace ghostforce {

std::string answer_of(const std::optional<std::string>& line) {
  stop_if_interrupted();
  if (!line) {
    throw Failure(ExitCode::answer_is_no,
                  "The input ended before the measurement did. Nothing was written. Give every answer, or type q to "
                  "end with a report of what has been measured.");
  }
  std::string answer(trimmed(*line));
  if (answer == "q") throw LeaveMeasurement{};
  if (answer == "s") throw SkipMeasurement{};
  return answer;
}

std::optional<double> number_of_answer(const std::string& answer, double least, double greatest, std::string_view unit,
                                       std::string& complaint) {
  std::string with_point = answer;
  std::ranges::replace(with_point, ',', '.');
  const std::optional<double> value = number_in<double>(with_point);
  // Written so that NaN is asked again too.
  if (value && *value >= least && *value <= greatest) return value;
  complaint = fmt::format("'{}' is not a number from {} to {} {}. Type the number alone, such as {}.",
                          quoted_text(answer), least, greatest, unit, std::sqrt(least * greatest) > 10.0 ? 60 : 5);
  return std::nullopt;
}

}  // namespace ghostforce
