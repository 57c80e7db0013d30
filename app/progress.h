// How far long work is, on the error output when that is a terminal; nothing
// when the work is short or nobody is there to read it.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace ghostforce {

class Progress {
 public:
  // `what` is done, with an article: "the simulation". `shows` false: never a
  // word.
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
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ghostforce
