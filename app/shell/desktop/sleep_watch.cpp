#include "app/shell/desktop/sleep_watch.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/eventfd.h>

#include "app/shell/desktop/bus.h"
#include "device/input/thread_signals.h"

namespace ghostforce {
namespace {

constexpr const char* service = "org.freedesktop.login1";
constexpr const char* object = "/org/freedesktop/login1";
constexpr const char* interface = "org.freedesktop.login1.Manager";

// The connection to logind. Nothing here waits.
class Logind {
 public:
  Logind(const BusLibrary& library, std::atomic<bool>& is_coming)
      : library_(library), connection_(library, library.open_system), is_coming_(is_coming) {
    if (connection_.bus() == nullptr) return;
    library_.match_signal_async(connection_.bus(), nullptr, service, object, interface, "PrepareForSleep",
                                on_prepare_for_sleep, nullptr, this);
  }
  Logind(const Logind&) = delete;
  Logind& operator=(const Logind&) = delete;

  // Takes the lock or gives it back. A refusal stands until the computer has slept. False: there is no connection.
  bool delay_sleep(bool is_wanted) noexcept {
    if (!is_wanted) lock_.reset();
    // logind gives no lock while the computer is on its way.
    if (!is_wanted || lock_.number() >= 0 || is_asked_for_ || is_coming_) return true;
    is_asked_for_ =
        library_.call_method_async(connection_.bus(), nullptr, service, object, interface, "Inhibit", on_lock, this,
                                   "ssss", "sleep", "ghostforce", "Turning the motors off", "delay") >= 0;
    return is_asked_for_;
  }

  BusConnection& connection() noexcept { return connection_; }

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

  const BusLibrary& library_;
  BusConnection connection_;
  std::atomic<bool>& is_coming_;
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
  const BusLibrary library;
  if (!library.is_complete) return;
  while (!is_ending_) {
    {
      Logind logind(library, is_coming_);
      while (!is_ending_ && logind.connection().process() && logind.delay_sleep(is_wanted_)) {
        logind.connection().wait(news_.number());
      }
    }
    is_coming_ = false;
    if (!is_ending_) wait_for_bus(news_.number());
  }
}

}  // namespace ghostforce
