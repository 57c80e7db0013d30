#include "app/shell/desktop/motion_watch.h"

#include <pthread.h>
#include <sys/eventfd.h>

#include <string_view>

#include "app/shell/desktop/bus.h"
#include "device/input/thread_signals.h"

namespace ghostforce {
namespace {

constexpr const char* settings_service = "org.freedesktop.portal.Desktop";
constexpr const char* settings_object = "/org/freedesktop/portal/desktop";
constexpr const char* settings_interface = "org.freedesktop.portal.Settings";
constexpr const char* animations_group = "org.gnome.desktop.interface";
constexpr const char* animations_key = "enable-animations";

// The portal's settings. Nothing here waits.
class DesktopSettings {
 public:
  DesktopSettings(const BusLibrary& library, std::atomic<bool>& is_reduced)
      : library_(library), connection_(library, library.open_user), is_reduced_(is_reduced) {
    if (connection_.bus() == nullptr) return;
    library_.match_signal_async(connection_.bus(), nullptr, settings_service, settings_object, settings_interface,
                                "SettingChanged", on_change, nullptr, this);
    library_.call_method_async(connection_.bus(), nullptr, settings_service, settings_object, settings_interface,
                               "Read", on_answer, this, "ss", animations_group, animations_key);
  }
  DesktopSettings(const DesktopSettings&) = delete;
  DesktopSettings& operator=(const DesktopSettings&) = delete;

  BusConnection& connection() noexcept { return connection_; }

 private:
  // Desktops that have no such setting answer with an error.
  static int on_answer(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    DesktopSettings& settings = *static_cast<DesktopSettings*>(self);
    if (settings.library_.message_is_method_error(message, nullptr) > 0) return 0;
    int is_animated = 1;
    // Read() puts the setting's variant into another one.
    if (settings.library_.message_read(message, "v", "v", "b", &is_animated) >= 0) {
      settings.is_reduced_ = is_animated == 0;
    }
    return 0;
  }

  static int on_change(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    DesktopSettings& settings = *static_cast<DesktopSettings*>(self);
    const char* changed_group = nullptr;
    const char* changed_key = nullptr;
    if (settings.library_.message_read(message, "ss", &changed_group, &changed_key) < 0) return 0;
    if (std::string_view(changed_group) != animations_group || std::string_view(changed_key) != animations_key)
      return 0;
    int is_animated = 1;
    if (settings.library_.message_read(message, "v", "b", &is_animated) >= 0) settings.is_reduced_ = is_animated == 0;
    return 0;
  }

  const BusLibrary& library_;
  BusConnection connection_;
  std::atomic<bool>& is_reduced_;
};

}  // namespace

MotionWatch::MotionWatch() : news_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), thread_([this] { watch(); }) {}

MotionWatch::~MotionWatch() {
  is_ending_ = true;
  eventfd_write(news_.number(), 1);
  thread_.join();
}

void MotionWatch::watch() noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "motion-watch");
  const BusLibrary library;
  if (!library.is_complete) return;
  while (!is_ending_) {
    {
      DesktopSettings settings(library, is_reduced_);
      while (!is_ending_ && settings.connection().process()) settings.connection().wait(news_.number());
    }
    if (!is_ending_) wait_for_bus(news_.number());
  }
}

}  // namespace ghostforce
