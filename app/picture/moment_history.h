// MomentHistory: the last minute, tick by tick, each with the settings under which it ran, so that a person can look at
// any moment of it again; and what counts as a change that can be seen. Bounded: a window that runs for days holds no
// more. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "app/picture/plot_history.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

// A tick's snapshot and the settings under which it ran, together: what a picture is of. Which strategy is the active
// one is the person's choice, whenever the moment was. Refers to a snapshot that others hold.
struct ShownMoment {
  Settings settings;
  const Snapshot& snapshot;
  bool is_past = false;  // somebody looks back: nothing newer than this is to be seen
};

// It is the minute before the last tick that changed anything that can be seen. Of a rest, in which nothing changes,
// only the newest ticks are kept: however long somebody talks over a picture that stands still, what led to it stays.
class MomentHistory {
 public:
  static constexpr std::size_t capacity = PlotHistory::capacity;  // ticks; over a minute at 1 kHz
  static constexpr double span_s = 60.0;                          // and no more than that, of model time
  static constexpr std::size_t resting_capacity = 4096;           // ticks of a rest

  // `settings`: those under which this tick ran. A tick that is not later than the newest is left out: the one that a
  // run goes on from comes twice. Asks for memory once in a thousand ticks at most, and no more once it is full.
  void add(const Snapshot& snapshot, const Settings& settings);
  void clear();

  bool is_empty() const noexcept { return size() == 0; }
  std::size_t size() const noexcept { return moving_.size() + resting_.size(); }

  // All of these are empty where there is no such moment, and good until the next add() or clear().
  std::optional<ShownMoment> oldest() const;
  std::optional<ShownMoment> newest() const;
  // The newest that is not after that time [s].
  std::optional<ShownMoment> at(double time_s) const;
  // The nearest neighbours of a time [s]: of a tick's own, the ticks beside it.
  std::optional<ShownMoment> before(double time_s) const;
  std::optional<ShownMoment> after(double time_s) const;

  // Of the last tick that changed anything that can be seen [s]; 0 where there is none.
  double changed_s() const noexcept { return moving_.size() == 0 ? 0.0 : moving_.newest().snapshot.time_s; }
  // The quantities up to changed_s().
  const PlotHistory& plots() const noexcept { return plots_; }

 private:
  struct Kept {
    Snapshot snapshot;
    std::uint64_t era = 0;  // which settings
  };

  // First in, first out. Its blocks stay and are used again.
  class Queue {
   public:
    std::size_t size() const noexcept { return size_; }
    const Kept& at(std::size_t i) const noexcept {
      return blocks_[(begin_ + i) / block_size][(begin_ + i) % block_size];
    }
    const Kept& oldest() const noexcept { return at(0); }
    const Kept& newest() const noexcept { return at(size_ - 1); }
    void push(const Kept& kept);
    void pop() noexcept;
    void clear() noexcept { begin_ = size_ = 0; }

   private:
    static constexpr std::size_t block_size = 1024;

    std::vector<std::vector<Kept>> blocks_;
    std::size_t begin_ = 0;  // in the first block
    std::size_t size_ = 0;
  };

  const Kept& kept(std::size_t i) const noexcept {
    return i < moving_.size() ? moving_.at(i) : resting_.at(i - moving_.size());
  }
  std::optional<ShownMoment> moment(std::size_t i) const;
  std::size_t first_not_before(double time_s) const;
  std::size_t first_after(double time_s) const;
  void keep_moving(const Kept& kept);
  void forget_settings() noexcept;

  Queue moving_;   // up to the last tick that changed anything,
  Queue resting_;  // after that tick
  Snapshot seen_;  // that the others are held against
  // In the order of their time; a tick's is eras_[its era - first_era_].
  std::deque<Settings> eras_;
  std::uint64_t first_era_ = 0;
  PlotHistory plots_;
};

// Where a device was in the newest `turn_s` of them, thinned out; fewer points where there is no such time.
std::vector<Vector<2>> last_loop(const MomentHistory& moments, StrategyId id, double turn_s);

// What is less than this nobody sees.
struct LeastVisible {
  double step = 0.0;   // of a place [m]
  double force = 0.0;  // [N]
};

// Whether two ticks look different in a picture. `seen` is the tick that was seen last, not the one before `now`: what
// creeps is then noticed in the end.
bool differs_visibly(const Snapshot& seen, const Snapshot& now, const LeastVisible& least) noexcept;

}  // namespace ghostforce
