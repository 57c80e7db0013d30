// Recording: a run written to a file while it is made (the format: run.h, docs/recording.md). A worker beside the
// window takes what the servo hands out and writes it many times a second, so that neither a stalled window nor the end
// of the process loses more than the last moment, and the servo never waits for a disk. Twice a second it waits for the
// disk itself, so that a power cut loses no more than that either.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "app/base/worker.h"
#include "app/files/run.h"
#include "core/scene.h"
#include "device/servo/servo.h"

namespace ghostforce {

// The servo's samples as lines of a recording. One thread.
class SampleText {
 public:
  // `settings` are those of the scene in the header.
  explicit SampleText(const Settings& settings) : known_(settings), wanted_(settings) {}

  // Whole lines: what has changed before this tick, where it does not follow from the one before, and its rows. False,
  // and nothing is appended: with it the run would be longer than a reader takes (RunLength).
  bool append(fmt::memory_buffer& lines, const Sample& sample);

  double seconds() const noexcept { return seconds_; }  // of model time
  std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  bool follows(const Sample& sample) const noexcept;

  Settings known_;   // to a reader of the file
  Settings wanted_;  // of the newest sample
  std::optional<Sample> last_;
  RunLength length_;
  double seconds_ = 0.0;
  std::uint64_t dropped_ = 0;
};

// How far it is. Any thread may look.
struct RecordingProgress {
  double seconds = 0.0;  // of model time
  std::uint64_t bytes = 0;
  std::uint64_t dropped = 0;  // samples lost
  int error = 0;              // errno of what has ended it; EOVERFLOW: it is as long as may be; 0: nothing has
};

// UI thread, but for the worker within.
class Recording {
 public:
  // How often what there is goes to the file [s], and how many times until the disk must have it: 0.5 s at most.
  static constexpr double writing_period_s = 0.05;
  static constexpr int writes_per_sync = 9;

  // Makes the file, which must not exist, and writes its header: `scene`, which must come from a file or from
  // rounded_to_file(), with the settings that the servo runs with. From then on takes the samples that the servo marks
  // with `number`, and leaves out others. The servo must outlive it. Throws Failure(file_trouble).
  Recording(const std::string& path, const Scene& scene, Servo& servo, std::uint32_t number);
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() { end(); }

  // Often (worker.h).
  void poll() {
    if (worker_) worker_->poll();
  }

  // Writes what the servo has handed out so far and closes the file; if the program is interrupted the last line says
  // so. May be called again.
  void end() noexcept;

  const std::string& path() const noexcept { return path_; }
  // Where the file was when it ended: path(), or where it was moved to meanwhile; empty: it was removed.
  const std::string& found_at() const noexcept { return found_at_; }
  RecordingProgress progress() const noexcept;

 private:
  // What the worker does.
  void write_now_and_then() noexcept;
  // Ends the recording where there is no memory for the work.
  template <typename Work>
  void attempt(Work&& work) noexcept;
  void write_samples();
  bool write_lines() noexcept;
  void sync();
  void fail(int error) noexcept;
  std::string where_it_is() const;

  std::string path_;
  Servo& servo_;
  std::uint32_t number_;
  int descriptor_ = -1;

  // The worker's, and whoever's once it has ended.
  SampleText text_;
  fmt::memory_buffer lines_;
  int writes_ = 0;             // since the file was opened
  std::uint64_t written_ = 0;  // whole lines in the file [bytes]
  bool is_named_ = false;      // the folder has its name, also after a power cut
  std::string found_at_;

  std::atomic<double> seconds_{0.0};
  std::atomic<std::uint64_t> bytes_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<int> error_{0};

  std::optional<Worker> worker_;  // empty: it has ended
};

}  // namespace ghostforce
