#include "app/runs/recording.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <new>
#include <string_view>
#include <system_error>

#include <fmt/compile.h>

#include "app/base/interruption.h"
#include "app/files/descriptor.h"
#include "app/files/output_file.h"

namespace ghostforce {
namespace {

void append_recording_row(fmt::memory_buffer& rows, const Sample& sample, StrategyId id) {
  const bool is_active = id == sample.settings.active;
  const Vector<2> sent = is_active ? sample.sent : Vector<2>(0.0);
  const Vector<2> tone = is_active ? sample.tone : Vector<2>(0.0);
  append_run_row(rows, sample.snapshot, id);
  fmt::format_to(std::back_inserter(rows), FMT_COMPILE(",{},{},{},{},{},{},{},{},{}"), is_active ? 1 : 0,
                 sample.snapshot.measured ? "estimated" : "given",
                 sample.snapshot.measured == id ? "measured" : "simulated", sent.x, sent.y,
                 is_active && sample.is_saturated ? 1 : 0, sample.loop_s, tone.x, tone.y);
  append_efforts(rows, sample.settings, sample.contacts[index_of(id)].efforts);
  rows.push_back('\n');
}

}  // namespace

bool SampleText::follows(const Sample& sample) const noexcept {
  if (!last_ || sample.serial != last_->serial + 1 || sample.restarts != last_->restarts ||
      sample.snapshot.measured != last_->snapshot.measured) {
    return false;
  }
  // As the servo goes on at another rate; more changes of it between two ticks end elsewhere.
  const double rate = sample.settings.rate;
  std::int64_t before = last_->snapshot.tick;
  if (rate != last_->settings.rate) before = std::llround(time_of(before, last_->settings.rate) * rate);
  return sample.snapshot.tick == before + 1;
}

bool SampleText::append(fmt::memory_buffer& lines, const Sample& sample) {
  if (!length_.takes(sample.snapshot.tick, sample.settings.rate)) return false;
  const double time_s = sample.snapshot.time_s;
  if (sample.settings != wanted_) {
    append_set_lines(lines, time_s, known_, sample.settings);
    wanted_ = sample.settings;
  }
  if (last_ && sample.serial != last_->serial + 1) {
    const std::uint64_t lost = sample.serial - last_->serial - 1;
    fmt::format_to(std::back_inserter(lines), FMT_COMPILE("{}{}\n"), dropped_begins, lost);
    dropped_ += lost;
  }
  if (!follows(sample)) {
    RunState state{.velocity = sample.velocity};
    for (std::size_t i = 0; i < strategy_count; ++i) state.energy[i] = sample.snapshot.strategies[i].energy;
    append_state_line(lines, time_s, state);
  }
  for (const Strategy& each : strategy_catalog()) append_recording_row(lines, sample, each.id);
  seconds_ += 1.0 / sample.settings.rate;
  last_ = sample;
  return true;
}

Recording::Recording(const std::string& path, const Scene& scene, Servo& servo, std::uint32_t number)
    : path_(path), servo_(servo), number_(number), text_(scene.settings), found_at_(path) {
  constexpr std::string_view kind = "a recording";
  descriptor_ = open_growing_file(path);
  if (descriptor_ < 0) throw no_growing_file(path, kind, errno);
  lines_.append(run_header(scene, recording_columns));
  if (!write_lines()) {
    close(descriptor_);
    unlink(path.c_str());
    throw no_growing_file(path, kind, error_);
  }
  worker_.emplace("recorder", writing_period_s, [this] {
    write_now_and_then();
    return true;
  });
}

void Recording::end() noexcept {
  if (!worker_) return;
  worker_.reset();
  attempt([this] { write_samples(); });
  attempt([this] {
    if (interrupted()) {
      lines_.append(interrupted_line);
      lines_.push_back('\n');
      write_lines();
    }
    sync();  // whoever ends it has waited for the disk already
    found_at_ = where_it_is();
  });
  // Some file systems tell only now that the disk is full.
  if (close(descriptor_) != 0 && errno != EINTR) fail(errno);
}

// Empty: nowhere. A file that was moved is as good as it was, but not where it will be looked for.
std::string Recording::where_it_is() const {
  struct stat opened {};
  if (fstat(descriptor_, &opened) != 0) return {};
  const auto leads_to_it = [&](const std::string& path) {
    struct stat named {};
    return stat(path.c_str(), &named) == 0 && named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
  };
  if (leads_to_it(path_)) return path_;
  std::error_code error;
  // The name that was removed, where it was, although the file may have another one that nobody knows.
  const std::string moved = std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", descriptor_), error).string();
  return leads_to_it(moved) ? moved : std::string();
}

RecordingProgress Recording::progress() const noexcept {
  return {.seconds = seconds_, .bytes = bytes_, .dropped = dropped_, .error = error_};
}

void Recording::write_now_and_then() noexcept {
  attempt([this] {
    write_samples();
    if (++writes_ % writes_per_sync == 0) sync();
  });
}

template <typename Work>
void Recording::attempt(Work&& work) noexcept {
  try {
    work();
  } catch (const std::bad_alloc&) {
    fail(ENOMEM);
  }
}

void Recording::write_samples() {
  // No more than there can be, however fast more comes.
  Sample sample;
  bool is_too_long = false;
  for (std::size_t i = 0; i < Servo::sample_capacity && servo_.take_record(sample); ++i) {
    if (sample.recording != number_ || error_ != 0 || is_too_long) continue;
    is_too_long = !text_.append(lines_, sample);
  }
  write_lines();
  if (is_too_long) fail(EOVERFLOW);
  seconds_ = text_.seconds();
  dropped_ = text_.dropped();
}

// False, and no more is written from then on, where the file takes no more. What is in it stays: whole lines.
bool Recording::write_lines() noexcept {
  if (error_ == 0) fail(append_whole(descriptor_, {lines_.data(), lines_.size()}));
  if (error_ == 0) {
    written_ += lines_.size();
    bytes_ = written_;
  } else {
    // Where even that fails, a reader leaves the half line out.
    [[maybe_unused]] const int ignored = ftruncate(descriptor_, static_cast<off_t>(written_));
  }
  lines_.clear();
  return error_ == 0;
}

// The recording ends where the disk fails, or where the file has no name any more: more of it would be lost too.
void Recording::sync() {
  if (error_ != 0) return;
  fail(sync_data(descriptor_));
  if (!is_named_) fail(sync_folder(std::filesystem::path(path_).parent_path()));
  is_named_ = true;
  if (where_it_is().empty()) fail(ENOENT);
}

// The first reason counts; 0: there is none.
void Recording::fail(int error) noexcept {
  if (error_ == 0) error_ = error;
}

}  // namespace ghostforce
