#include "app/shell/desktop/bus.h"

#include <dlfcn.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

#include "device/input/monotonic_clock.h"

namespace ghostforce {

struct BusLibrary::Symbol {
  void* address;
  template <typename Function>
  operator Function*() const noexcept {  // NOLINT: of whichever type it is declared with
    return reinterpret_cast<Function*>(address);
  }
};

BusLibrary::Symbol BusLibrary::find(const char* name) noexcept {
  const Symbol symbol{handle_ != nullptr ? dlsym(handle_, name) : nullptr};
  is_complete = is_complete && symbol.address != nullptr;
  return symbol;
}

BusLibrary::BusLibrary() noexcept
    : handle_(dlopen("libsystemd.so.0", RTLD_NOW | RTLD_LOCAL)),
      open_system(find("sd_bus_open_system")),
      open_user(find("sd_bus_open_user")),
      close(find("sd_bus_close")),
      unref(find("sd_bus_unref")),
      process(find("sd_bus_process")),
      get_fd(find("sd_bus_get_fd")),
      get_events(find("sd_bus_get_events")),
      get_timeout(find("sd_bus_get_timeout")),
      get_unique_name(find("sd_bus_get_unique_name")),
      match_signal_async(find("sd_bus_match_signal_async")),
      call_async(find("sd_bus_call_async")),
      call_method_async(find("sd_bus_call_method_async")),
      message_new_method_call(find("sd_bus_message_new_method_call")),
      message_unref(find("sd_bus_message_unref")),
      message_append(find("sd_bus_message_append")),
      message_append_array(find("sd_bus_message_append_array")),
      message_open_container(find("sd_bus_message_open_container")),
      message_close_container(find("sd_bus_message_close_container")),
      message_is_method_error(find("sd_bus_message_is_method_error")),
      message_get_path(find("sd_bus_message_get_path")),
      message_read(find("sd_bus_message_read")),
      message_enter_container(find("sd_bus_message_enter_container")),
      message_exit_container(find("sd_bus_message_exit_container")),
      message_skip(find("sd_bus_message_skip")) {}

BusConnection::BusConnection(const BusLibrary& library, decltype(&sd_bus_open_user) open) noexcept : library_(library) {
  if (open(&bus_) < 0) bus_ = nullptr;
}

BusConnection::~BusConnection() {
  if (bus_ == nullptr) return;
  library_.close(bus_);
  library_.unref(bus_);
}

bool BusConnection::process() noexcept {
  int result = 1;
  while (result > 0) result = bus_ != nullptr ? library_.process(bus_, nullptr) : -ENOTCONN;
  return result == 0;
}

namespace {

// As poll() wants it, of a time of CLOCK_MONOTONIC [µs]; the greatest stands for never.
int milliseconds_until(std::uint64_t time_us) noexcept {
  if (time_us == UINT64_MAX) return -1;
  const auto now_us = static_cast<std::uint64_t>(monotonic_ns() / 1000);
  if (time_us <= now_us) return 0;
  return static_cast<int>(std::min<std::uint64_t>((time_us - now_us) / 1000U + 1U, 60'000U));
}

void wait_for(int news, const pollfd& bus, int longest_ms) noexcept {
  std::array<pollfd, 2> waits{{bus, {news, POLLIN, 0}}};
  poll(waits.data(), waits.size(), longest_ms);
  eventfd_t ignored = 0;
  if (waits[1].revents != 0) eventfd_read(news, &ignored);
}

}  // namespace

void BusConnection::wait(int news) const noexcept {
  std::uint64_t until_us = UINT64_MAX;
  library_.get_timeout(bus_, &until_us);
  wait_for(news, {library_.get_fd(bus_), static_cast<short>(library_.get_events(bus_)), 0},
           milliseconds_until(until_us));
}

void wait_for_bus(int news) noexcept {
  constexpr int look_again_ms = 10'000;
  wait_for(news, {-1, 0, 0}, look_again_ms);
}

}  // namespace ghostforce
