// Worker: work that goes on beside the window, a step at a time. On the desktop it has a thread of its own, so that
// neither the window nor the servo waits for it; a page has no threads, and there the UI thread makes the steps, between
// frames. What the steps work on is theirs from the first to the last. UI thread, but for the steps.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace ghostforce {

class Worker {
 public:
  // Makes a step `period_s` after the one before has ended, and the first one so long after now, until one returns false.
  // A step must not throw. `name`: of the thread, 15 letters at most.
  Worker(const std::string& name, double period_s, std::function<bool()> step);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Often: without a thread this is where a step that is due is made.
  void poll();

  // When it returns no step is under way, and none will follow. A last one is the owner's matter. May be called again.
  void end() noexcept;

  // False: none will follow, and what the steps have made is the owner's.
  bool is_running() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace ghostforce
