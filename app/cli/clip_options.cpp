#include "app/cli/clip_options.h"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/console/typed_text.h"
#include "app/files/clip_file.h"
#include "core/scene.h"

namespace ghostforce {
namespace {

// Up to the next colon, and past it; the last part has none.
std::string_view take_part(std::string_view& text) {
  const std::size_t colon = text.find(':');
  const std::string_view part = trimmed(text.substr(0, colon));
  text = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  return part;
}

}  // namespace

ClipTimes clip_times_from(std::string_view text) {
  std::string_view rest = text;
  const std::optional<double> from = number_in<double>(take_part(rest));
  const std::optional<double> to = number_in<double>(take_part(rest));
  const std::optional<int> frames_per_second = number_in<int>(trimmed(rest));
  const auto refuse = [&](std::string_view why) {
    return Failure(ExitCode::wrong_call,
                   fmt::format("--clip {}: {}; give FROM:TO:FPS, for example 0:3:30", quoted_text(text), why));
  };
  const auto is_time = [](const std::optional<double>& time) { return time && *time >= 0.0 && *time <= longest_s; };
  if (!is_time(from) || !is_time(to)) throw refuse("FROM and TO are times in seconds");
  if (!(*from < *to)) throw refuse("TO must be later than FROM");
  if (!frames_per_second || *frames_per_second < 1 || *frames_per_second > most_frames_per_second) {
    throw refuse(fmt::format("FPS is a whole number of pictures a second, 1 to {}", most_frames_per_second));
  }
  return {*from, *to, *frames_per_second};
}

}  // namespace ghostforce
