// FakeLogind: a system bus of its own with a service on it that answers as logind does when it is asked to delay sleep.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

#include "app/files/descriptor.h"
#include "tests/support/private_bus.h"

namespace ghostforce {

class FakeLogind : public PrivateBus {
 public:
  FakeLogind() : PrivateBus([this](sd_bus* bus) { return offer(bus); }) {}

  std::vector<std::string> locks;  // each that was ever asked for, its words separated by bars
  bool refuses = false;

  // Whoever has the lock has not given it back.
  bool is_delayed() const {
    if (lock_.number() < 0) return false;
    pollfd waits{lock_.number(), 0, 0};
    return poll(&waits, 1, 0) == 0;  // the last one that could write has closed it
  }
  void prepare_for_sleep(bool is_coming) {
    sd_bus_emit_signal(bus(), "/org/freedesktop/login1", "org.freedesktop.login1.Manager", "PrepareForSleep", "b",
                       static_cast<int>(is_coming));
    sd_bus_flush(bus());
  }

 private:
  bool offer(sd_bus* bus) {
    static const sd_bus_vtable methods[] = {
        SD_BUS_VTABLE_START(0), SD_BUS_METHOD("Inhibit", "ssss", "h", on_inhibit, SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_VTABLE_END};
    return sd_bus_add_object_vtable(bus, nullptr, "/org/freedesktop/login1", "org.freedesktop.login1.Manager", methods,
                                    this) >= 0 &&
           sd_bus_request_name(bus, "org.freedesktop.login1", 0) >= 0;
  }

  static int on_inhibit(sd_bus_message* message, void* self, sd_bus_error* error) {
    FakeLogind& logind = *static_cast<FakeLogind*>(self);
    const char* what = nullptr;
    const char* who = nullptr;
    const char* why = nullptr;
    const char* mode = nullptr;
    sd_bus_message_read(message, "ssss", &what, &who, &why, &mode);
    logind.locks.push_back(std::string(what) + '|' + who + '|' + why + '|' + mode);
    if (logind.refuses) return sd_bus_error_set(error, SD_BUS_ERROR_ACCESS_DENIED, "no");
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return -errno;
    const Descriptor given(ends[1]);
    logind.lock_.reset(ends[0]);
    return sd_bus_reply_method_return(message, "h", given.number());
  }

  Descriptor lock_;  // where the end of the newest one shows
};

}  // namespace ghostforce
