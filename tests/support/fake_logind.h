// FakeLogind: a system bus of its own with a service on it that answers as logind does when it is asked to delay sleep. It
// is stepped by hand.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/files/descriptor.h"
#include "tests/support/becomes.h"
#include "tests/support/display.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

class FakeLogind {
 public:
  FakeLogind() {
    std::ofstream(folder_ / "bus.conf")
        << "<busconfig><type>session</type><listen>" << address() << "</listen><auth>EXTERNAL</auth>"
        << "<policy context=\"default\"><allow user=\"*\"/><allow own=\"*\"/><allow send_destination=\"*\"/>"
        << "<allow receive_sender=\"*\"/></policy></busconfig>";
    begin_bus();
  }
  ~FakeLogind() {
    sd_bus_close(bus_);
    sd_bus_unref(bus_);
  }
  FakeLogind(const FakeLogind&) = delete;
  FakeLogind& operator=(const FakeLogind&) = delete;

  // As DBUS_SYSTEM_BUS_ADDRESS has it.
  std::string address() const { return std::string("unix:path=") + (folder_ / "socket"); }

  std::vector<std::string> locks;  // each that was ever asked for, its words separated by bars
  bool refuses = false;

  // Answers what has been asked.
  void step() {
    while (sd_bus_process(bus_, nullptr) > 0) {
    }
  }
  // Whoever has the lock has not given it back.
  bool is_delayed() const {
    if (lock_.number() < 0) return false;
    pollfd waits{lock_.number(), 0, 0};
    return poll(&waits, 1, 0) == 0;  // the last one that could write has closed it
  }
  void prepare_for_sleep(bool is_coming) {
    sd_bus_emit_signal(bus_, "/org/freedesktop/login1", "org.freedesktop.login1.Manager", "PrepareForSleep", "b",
                       static_cast<int>(is_coming));
    sd_bus_flush(bus_);
  }
  // False: it takes too long.
  bool comes_to(const std::function<bool()>& as_wanted) {
    return becomes(as_wanted, [this] { step(); });
  }
  void end_bus() { daemon_->end(SIGKILL); }
  void begin_bus() {
    std::filesystem::remove(folder_ / "socket");
    daemon_ = std::make_unique<BackgroundProgram>(
        std::vector<std::string>{"dbus-daemon", "--nofork", "--nopidfile", "--config-file=" + (folder_ / "bus.conf")},
        std::vector<std::string>{});
    if (!becomes([this] { return open(); })) throw std::runtime_error("the bus cannot be used");
  }

 private:
  bool open() {
    static const sd_bus_vtable methods[] = {
        SD_BUS_VTABLE_START(0), SD_BUS_METHOD("Inhibit", "ssss", "h", on_inhibit, SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_VTABLE_END};
    sd_bus_unref(bus_);
    return sd_bus_new(&bus_) >= 0 && sd_bus_set_address(bus_, address().c_str()) >= 0 &&
           sd_bus_set_bus_client(bus_, 1) >= 0 && sd_bus_start(bus_) >= 0 &&
           sd_bus_add_object_vtable(bus_, nullptr, "/org/freedesktop/login1", "org.freedesktop.login1.Manager", methods,
                                    this) >= 0 &&
           sd_bus_request_name(bus_, "org.freedesktop.login1", 0) >= 0;
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

  TemporaryFolder folder_;
  std::unique_ptr<BackgroundProgram> daemon_;
  sd_bus* bus_ = nullptr;
  Descriptor lock_;  // where the end of the newest one shows
};

}  // namespace ghostforce
