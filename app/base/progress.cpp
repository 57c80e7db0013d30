#include "app/base/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "app/base/words.h"

namespace ghostforce {
namespace {

constexpr std::chrono::milliseconds first_word_after{1000};
constexpr std::chrono::milliseconds between_words{200};

constexpr std::int64_t bar_length = 20;

// Coarser the longer it is: a guess needs no more.
std::string shown(std::chrono::duration<double> time) {
  const auto seconds = static_cast<std::int64_t>(std::ceil(time.count()));
  if (seconds < 100) return fmt::format("{} s", seconds);
  const std::int64_t minutes = (seconds + 59) / 60;
  return minutes < 100 ? fmt::format("{} min", minutes) : fmt::format("{} h", (minutes + 59) / 60);
}

}  // namespace

std::string progress_words(std::string_view what, std::int64_t done, std::int64_t total,
                           std::chrono::duration<double> elapsed) {
  const std::string bar(static_cast<std::size_t>(bar_length * done / total), '#');
  const std::string words = fmt::format("{} [{:{}}] {:3} %", what, bar, bar_length, 100 * done / total);
  if (done <= 0) return words;
  const double left = static_cast<double>(total - done) / static_cast<double>(done);
  return fmt::format("{}, {} left", words, shown(elapsed * left));
}

Progress::Progress(std::string what, std::int64_t total, bool shows)
    : what_(std::move(what)),
      total_(total),
      shows_(shows && total > 0 && isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      next_(start_ + first_word_after) {}

Progress::~Progress() {
  if (has_shown_) write_words("\r\x1b[K");
}

void Progress::at(std::int64_t done) {
  if (!shows_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + between_words;
  has_shown_ = true;
  say("\r{} \x1b[K", progress_words(what_, done, total_, now - start_));
}

}  // namespace ghostforce
