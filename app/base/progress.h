// How far long work is, on the error output when that is a terminal; nothing when the work is short or nobody is there
// to read it.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace ghostforce {

// "simulating [######              ]  31 %, 12 s left"; how long is left is told from the time that it took so far.
std::string progress_words(std::string_view what, std::int64_t done, std::int64_t total,
                           std::chrono::duration<double> elapsed);

class Progress {
 public:
  // `what` is done, with an article: "the simulation". `shows` false: never a word.
  Progress(std::string what, std::int64_t total, bool shows);
  // Leaves an empty line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Cheap enough for every thousandth tick, not for every one: it reads a clock.
  void at(std::int64_t done);

 private:
  std::string what_;
  std::int64_t total_;
  bool shows_;
  bool has_shown_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ghostforce
