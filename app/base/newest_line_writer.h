// NewestLineWriter: lines for another program that may read slowly, or not at all. A thread of its own writes them, so
// that nobody else waits for the reader; a line that it has not begun when the next one comes is never written. Lines
// are written whole. All of it from any one thread.
#pragma once

#include <memory>
#include <string>
#include <thread>

namespace ghostforce {

class NewestLineWriter {
 public:
  // `first` is written in any case. The descriptor must stay open to the end of the process.
  NewestLineWriter(int descriptor, std::string first);
  ~NewestLineWriter() { finish(); }
  NewestLineWriter(const NewestLineWriter&) = delete;
  NewestLineWriter& operator=(const NewestLineWriter&) = delete;

  void put(std::string line);

  // Waits for the last line, for a reader no longer than a second; then it is left to it. Nothing is written after it.
  // Returns problem().
  int finish();

  // errno of what has ended the writing: EPIPE, nobody reads any more; 0: nothing has.
  int problem() const noexcept;

 private:
  struct State;
  static void write_lines(State& state, const std::string& first);

  std::shared_ptr<State> state_;  // the thread's too, which may outlive this
  std::thread thread_;
};

}  // namespace ghostforce
