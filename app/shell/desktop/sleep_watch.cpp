#include "app/shell/desktop/sleep_watch.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <systemd/sd-bus.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

#include "device/input/monotonic_clock.h"
#include "device/input/thread_signals.h"

namespace ghostforce {
namespace {

constexpr const char* service = "org.freedesktop.login1";
constexpr const char* object = "/org/freedesktop/login1";
constexpr const char* interface = "org.freedesktop.login1.Manager";

// A bus that is not there, or has ended, may come later.
constexpr int connect_again_ms = 10'000;

// A system without logind may lack its library too, so it is opened while the program runs.
class Library {
 private:
  struct Symbol {
    void* address;
    template <typename Function>
    operator Function*() const noexcept {  // NOLINT: of whichever type it is declared with
      return reinterpret_cast<Function*>(address);
    }
  };
  Symbol find(const char* name) noexcept {
    const Symbol symbol{handle_ != nullptr ? dlsym(handle_, name) : nullptr};
    is_complete = is_complete && symbol.address != nullptr;
    return symbol;
  }

  void* handle_ = dlopen("libsystemd.so.0", RTLD_NOW | RTLD_LOCAL);  // stays: it has state of its own

 public:
  bool is_complete = true;
  decltype(&sd_bus_open_system) open_system = find("sd_bus_open_system");
  decltype(&sd_bus_close) close = find("sd_bus_close");
  decltype(&sd_bus_unref) unref = find("sd_bus_unref");
  decltype(&sd_bus_process) process = find("sd_bus_process");
  decltype(&sd_bus_get_fd) get_fd = find("sd_bus_get_fd");
  decltype(&sd_bus_get_events) get_events = find("sd_bus_get_events");
  decltype(&sd_bus_get_timeout) get_timeout = find("sd_bus_get_timeout");
  decltype(&sd_bus_match_signal_async) match_signal_async = find("sd_bus_match_signal_async");
  decltype(&sd_bus_call_method_async) call_method_async = find("sd_bus_call_method_async");
  decltype(&sd_bus_message_is_method_error) message_is_method_error = find("sd_bus_message_is_method_error");
  decltype(&sd_bus_message_read) message_read = find("sd_bus_message_read");
};

// As poll() wants it, of a time of CLOCK_MONOTONIC [µs]; the greatest stands for never.
int milliseconds_until(std::uint64_t time_us) noexcept {
  if (time_us == UINT64_MAX) return -1;
  const auto now_us = static_cast<std::uint64_t>(monotonic_ns() / 1000);
  if (time_us <= now_us) return 0;
  return static_cast<int>(std::min<std::uint64_t>((time_us - now_us) / 1000U + 1U, 60'000U));
}

// Until there is news of the one or the other.
void wait_for_news(int news, const pollfd& bus, int longest_ms) noexcept {
  std::array<pollfd, 2> waits{{bus, {news, POLLIN, 0}}};
  poll(waits.data(), waits.size(), longest_ms);
  eventfd_t ignored = 0;
  if (waits[1].revents != 0) eventfd_read(news, &ignored);
}

// The connection to logind. Nothing here waits.
class Logind {
 public:
  Logind(const Library& library, std::atomic<bool>& is_coming) : library_(library), is_coming_(is_coming) {
    if (library_.open_system(&bus_) < 0) return;
    library_.match_signal_async(bus_, nullptr, service, object, interface, "PrepareForSleep", on_prepare_for_sleep,
                                nullptr, this);
  }
  ~Logind() {
    if (bus_ == nullptr) return;
    library_.close(bus_);
    library_.unref(bus_);
  }
  Logind(const Logind&) = delete;
  Logind& operator=(const Logind&) = delete;

  // Takes the lock or gives it back. A refusal stands until the computer has slept. False: there is no connection.
  bool delay_sleep(bool is_wanted) noexcept {
    if (!is_wanted) lock_.reset();
    // logind gives no lock while the computer is on its way.
    if (!is_wanted || lock_.number() >= 0 || is_asked_for_ || is_coming_) return true;
    is_asked_for_ = library_.call_method_async(bus_, nullptr, service, object, interface, "Inhibit", on_lock, this,
                                               "ssss", "sleep", "ghostforce", "Turning the motors off", "delay") >= 0;
    return is_asked_for_;
  }

  // Takes what has come in and sends what is to go out. False: there is no connection, or no longer.
  bool process() noexcept {
    int result = 1;
    while (result > 0) result = bus_ != nullptr ? library_.process(bus_, nullptr) : -ENOTCONN;
    return result == 0;
  }

  pollfd poll_descriptor() const noexcept {
    return {library_.get_fd(bus_), static_cast<short>(library_.get_events(bus_)), 0};
  }
  int milliseconds_to_wait() const noexcept {
    std::uint64_t until_us = UINT64_MAX;
    library_.get_timeout(bus_, &until_us);
    return milliseconds_until(until_us);
  }

 private:
  static int on_prepare_for_sleep(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Logind& logind = *static_cast<Logind*>(self);
    int is_coming = 0;
    if (logind.library_.message_read(message, "b", &is_coming) < 0) return 0;
    logind.is_coming_ = is_coming != 0;
    if (is_coming == 0) logind.is_asked_for_ = false;
    return 0;
  }

  // The lock is a descriptor, and given back by closing it.
  static int on_lock(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Logind& logind = *static_cast<Logind*>(self);
    if (logind.library_.message_is_method_error(message, nullptr) > 0) return 0;
    int lock = -1;  // the message's
    if (logind.library_.message_read(message, "h", &lock) >= 0) logind.lock_.reset(fcntl(lock, F_DUPFD_CLOEXEC, 3));
    logind.is_asked_for_ = false;
    return 0;
  }

  const Library& library_;
  std::atomic<bool>& is_coming_;
  sd_bus* bus_ = nullptr;
  bool is_asked_for_ = false;  // the lock, and not given yet; or it was refused
  Descriptor lock_;
};

}  // namespace

SleepWatch::SleepWatch() : news_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), thread_([this] { watch(); }) {}

SleepWatch::~SleepWatch() {
  is_ending_ = true;
  eventfd_write(news_.number(), 1);
  thread_.join();
}

void SleepWatch::delay(bool is_wanted) noexcept {
  if (is_wanted_.exchange(is_wanted) != is_wanted) eventfd_write(news_.number(), 1);
}

void SleepWatch::watch() noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "sleep-watch");
  const Library library;
  if (!library.is_complete) return;
  while (!is_ending_) {
    {
      Logind logind(library, is_coming_);
      while (!is_ending_ && logind.process() && logind.delay_sleep(is_wanted_)) {
        wait_for_news(news_.number(), logind.poll_descriptor(), logind.milliseconds_to_wait());
      }
    }
    is_coming_ = false;
    if (!is_ending_) wait_for_news(news_.number(), {-1, 0, 0}, connect_again_ms);
  }
}

}  // namespace ghostforce
