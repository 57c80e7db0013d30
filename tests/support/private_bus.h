// PrivateBus: a D-Bus of its own for a test, with one service on it that the test plays. It is stepped by hand.
#pragma once

#include <systemd/sd-bus.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/becomes.h"
#include "tests/support/display.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

class PrivateBus {
 public:
  // `offer` puts the service on a connection that has just been made; false: it cannot.
  explicit PrivateBus(std::function<bool(sd_bus*)> offer) : offer_(std::move(offer)) {
    std::ofstream(folder_ / "bus.conf")
        << "<busconfig><type>session</type><listen>" << address() << "</listen><auth>EXTERNAL</auth>"
        << "<policy context=\"default\"><allow user=\"*\"/><allow own=\"*\"/><allow send_destination=\"*\"/>"
        << "<allow receive_sender=\"*\"/></policy></busconfig>";
    begin_bus();
  }
  ~PrivateBus() {
    sd_bus_close(bus_);
    sd_bus_unref(bus_);
  }
  PrivateBus(const PrivateBus&) = delete;
  PrivateBus& operator=(const PrivateBus&) = delete;

  // As DBUS_SYSTEM_BUS_ADDRESS and DBUS_SESSION_BUS_ADDRESS have it.
  std::string address() const { return std::string("unix:path=") + (folder_ / "socket"); }

  // Answers what has been asked.
  void step() {
    while (sd_bus_process(bus_, nullptr) > 0) {
    }
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

 protected:
  sd_bus* bus() const noexcept { return bus_; }

 private:
  bool open() {
    sd_bus_unref(bus_);
    return sd_bus_new(&bus_) >= 0 && sd_bus_set_address(bus_, address().c_str()) >= 0 &&
           sd_bus_set_bus_client(bus_, 1) >= 0 && sd_bus_start(bus_) >= 0 && offer_(bus_);
  }

  std::function<bool(sd_bus*)> offer_;
  TemporaryFolder folder_;
  std::unique_ptr<BackgroundProgram> daemon_;
  sd_bus* bus_ = nullptr;
};

}  // namespace ghostforce
