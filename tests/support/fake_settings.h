// FakeSettings: a person's bus of its own with a service on it that answers as a desktop's portal does when it is asked
// whether there are to be animations.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/support/private_bus.h"

namespace ghostforce {

class FakeSettings : public PrivateBus {
 public:
  // Empty: the desktop has no such setting.
  explicit FakeSettings(std::optional<bool> is_animated)
      : PrivateBus([this](sd_bus* bus) { return offer(bus); }), is_animated_(is_animated) {}

  int asked = 0;

  void change(bool is_animated) {
    is_animated_ = is_animated;
    tell("org.gnome.desktop.interface", "enable-animations", is_animated);
  }
  void tell(const char* group, const char* key, bool value) {
    sd_bus_emit_signal(bus(), object, interface, "SettingChanged", "ssv", group, key, "b", static_cast<int>(value));
    sd_bus_flush(bus());
  }

 private:
  static constexpr const char* object = "/org/freedesktop/portal/desktop";
  static constexpr const char* interface = "org.freedesktop.portal.Settings";

  bool offer(sd_bus* bus) {
    static const sd_bus_vtable methods[] = {SD_BUS_VTABLE_START(0),
                                            SD_BUS_METHOD("Read", "ss", "v", on_read, SD_BUS_VTABLE_UNPRIVILEGED),
                                            SD_BUS_VTABLE_END};
    return sd_bus_add_object_vtable(bus, nullptr, object, interface, methods, this) >= 0 &&
           sd_bus_request_name(bus, "org.freedesktop.portal.Desktop", 0) >= 0;
  }

  static int on_read(sd_bus_message* message, void* self, sd_bus_error* error) {
    FakeSettings& settings = *static_cast<FakeSettings*>(self);
    ++settings.asked;
    const char* group = nullptr;
    const char* key = nullptr;
    sd_bus_message_read(message, "ss", &group, &key);
    const bool is_known =
        std::string_view(group) == "org.gnome.desktop.interface" && std::string_view(key) == "enable-animations";
    if (!is_known || !settings.is_animated_) {
      return sd_bus_error_set(error, "org.freedesktop.portal.Error.NotFound", "Requested setting not found");
    }
    return sd_bus_reply_method_return(message, "v", "v", "b", static_cast<int>(*settings.is_animated_));
  }

  std::optional<bool> is_animated_;
};

}  // namespace ghostforce
