#include "app/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include <fmt/core.h>

namespace ghostforce {
namespace {

constexpr std::chrono::milliseconds first_word_after{1000};
constexpr std::chrono::milliseconds between_words{200};

}  // namespace

Progress::Progress(std::string what, std::int64_t total, bool shows)
    : what_(std::move(what)),
      total_(total),
      shows_(shows && total > 0 && isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + first_word_after) {}

Progress::~Progress() {
  if (has_shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::at(std::int64_t done) {
  if (!shows_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + between_words;
  has_shown_ = true;
  fmt::print(stderr, "\r{}: {} % \x1b[K", what_, 100 * done / total_);
}

}  // namespace ghostforce
