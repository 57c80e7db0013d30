// MotionWatch: whether the desktop is set to have programs move less, which is what GNOME's and GTK's "animations off"
// says. It asks the desktop's portal (org.freedesktop.portal.Settings on the person's D-Bus) and hears of changes. On a
// thread of its own. Where there is no such bus, no portal or no libsystemd to talk to them, nothing is reduced.
#pragma once

#include <atomic>
#include <thread>

#include "app/files/descriptor.h"

namespace ghostforce {

class MotionWatch {
 public:
  MotionWatch();
  ~MotionWatch();
  MotionWatch(const MotionWatch&) = delete;
  MotionWatch& operator=(const MotionWatch&) = delete;

  // As far as is known. Any thread.
  bool is_reduced() const noexcept { return is_reduced_; }

 private:
  void watch() noexcept;

  Descriptor news_;  // something to read: it is ending
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_reduced_{false};
  std::thread thread_;  // last: it uses what stands above
};

}  // namespace ghostforce
