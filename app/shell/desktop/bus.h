// A connection to a D-Bus by libsystemd, for a thread of its own that waits for it and for news from other threads. A
// system may lack the library, so it is opened while the program runs; without it there is no connection.
#pragma once

#include <systemd/sd-bus.h>

namespace ghostforce {

// What the program calls of it.
struct BusLibrary {
 private:
  struct Symbol;
  Symbol find(const char* name) noexcept;

  void* handle_;  // stays: it has state of its own

 public:
  BusLibrary() noexcept;

  bool is_complete = true;
  decltype(&sd_bus_open_system) open_system;
  decltype(&sd_bus_open_user) open_user;
  decltype(&sd_bus_close) close;
  decltype(&sd_bus_unref) unref;
  decltype(&sd_bus_process) process;
  decltype(&sd_bus_get_fd) get_fd;
  decltype(&sd_bus_get_events) get_events;
  decltype(&sd_bus_get_timeout) get_timeout;
  decltype(&sd_bus_get_unique_name) get_unique_name;
  decltype(&sd_bus_match_signal_async) match_signal_async;
  decltype(&sd_bus_call_async) call_async;
  decltype(&sd_bus_call_method_async) call_method_async;
  decltype(&sd_bus_message_new_method_call) message_new_method_call;
  decltype(&sd_bus_message_unref) message_unref;
  decltype(&sd_bus_message_append) message_append;
  decltype(&sd_bus_message_append_array) message_append_array;
  decltype(&sd_bus_message_open_container) message_open_container;
  decltype(&sd_bus_message_close_container) message_close_container;
  decltype(&sd_bus_message_is_method_error) message_is_method_error;
  decltype(&sd_bus_message_get_path) message_get_path;
  decltype(&sd_bus_message_read) message_read;
  decltype(&sd_bus_message_enter_container) message_enter_container;
  decltype(&sd_bus_message_exit_container) message_exit_container;
  decltype(&sd_bus_message_skip) message_skip;
};

// Nothing here but wait() waits.
class BusConnection {
 public:
  // `open`: the library's, of the system's bus or the person's.
  BusConnection(const BusLibrary& library, decltype(&sd_bus_open_user) open) noexcept;
  ~BusConnection();
  BusConnection(const BusConnection&) = delete;
  BusConnection& operator=(const BusConnection&) = delete;

  // Null: there is none.
  sd_bus* bus() const noexcept { return bus_; }
  // Takes what has come in and sends what is to go out. False: there is no connection, or no longer.
  bool process() noexcept;
  // Until process() has something to do, or there is something to read at `news`, an eventfd, which is read then.
  void wait(int news) const noexcept;

 private:
  const BusLibrary& library_;
  sd_bus* bus_ = nullptr;
};

// Until there is something to read at `news`, or it is time to look for a bus again that was not there or has ended.
void wait_for_bus(int news) noexcept;

}  // namespace ghostforce
