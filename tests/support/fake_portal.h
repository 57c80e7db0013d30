// FakePortal: a person's bus of its own with a service on it that answers as a desktop's portal does when it is asked for
// files. The test is the person at its dialogs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/private_bus.h"

namespace ghostforce {

class FakePortal : public PrivateBus {
 public:
  struct Call {
    std::string method{};
    std::string parent{};
    std::string token{};
    std::string name{};    // proposed, of a new file
    std::string folder{};  // its folder
    std::string request{};
  };

  explicit FakePortal(bool is_there = true)
      : PrivateBus([this, is_there](sd_bus* bus) { return offer(bus) && (!is_there || appear(bus)); }) {}

  std::vector<Call> calls;
  int closed = 0;  // dialogs, by the program
  bool refuses = false;
  std::vector<std::string> answer_at_once;  // before the call itself is answered; empty: it waits for respond()
  std::string other_handle;                 // than the one that follows from the token, as of old portals; empty: none

  void appear() { appear(bus()); }
  void die() {
    sd_bus_release_name(bus(), service);
    sd_bus_flush(bus());
  }
  // To the newest call, or at another path.
  void respond(std::uint32_t response, const std::vector<std::string>& uris = {}, const std::string& path = {}) {
    sd_bus_message* signal = nullptr;
    const std::string own = other_handle.empty() ? calls.back().request : other_handle;
    sd_bus_message_new_signal(bus(), &signal, path.empty() ? own.c_str() : path.c_str(),
                              "org.freedesktop.portal.Request", "Response");
    sd_bus_message_append(signal, "u", response);
    sd_bus_message_open_container(signal, 'a', "{sv}");
    sd_bus_message_append(signal, "{sv}", "choices", "a(ss)", 0);  // to be passed over
    sd_bus_message_open_container(signal, 'e', "sv");
    sd_bus_message_append(signal, "s", "uris");
    sd_bus_message_open_container(signal, 'v', "as");
    sd_bus_message_open_container(signal, 'a', "s");
    for (const std::string& uri : uris) sd_bus_message_append(signal, "s", uri.c_str());
    for (int container = 0; container < 4; ++container) sd_bus_message_close_container(signal);
    sd_bus_send(bus(), signal, nullptr);
    sd_bus_message_unref(signal);
    sd_bus_flush(bus());
  }

 private:
  static constexpr const char* service = "org.freedesktop.portal.Desktop";
  static constexpr const char* object = "/org/freedesktop/portal/desktop";

  static bool appear(sd_bus* bus) { return sd_bus_request_name(bus, service, 0) >= 0; }

  bool offer(sd_bus* bus) {
    static const sd_bus_vtable chooser[] = {
        SD_BUS_VTABLE_START(0), SD_BUS_METHOD("OpenFile", "ssa{sv}", "o", on_call, SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_METHOD("SaveFile", "ssa{sv}", "o", on_call, SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_PROPERTY("version", "u", on_version, 0, SD_BUS_VTABLE_PROPERTY_CONST), SD_BUS_VTABLE_END};
    static const sd_bus_vtable request[] = {SD_BUS_VTABLE_START(0),
                                            SD_BUS_METHOD("Close", "", "", on_close, SD_BUS_VTABLE_UNPRIVILEGED),
                                            SD_BUS_VTABLE_END};
    return sd_bus_add_object_vtable(bus, nullptr, object, "org.freedesktop.portal.FileChooser", chooser, this) >= 0 &&
           sd_bus_add_fallback_vtable(bus, nullptr, "/org/freedesktop/portal/desktop/request",
                                      "org.freedesktop.portal.Request", request, on_find, this) >= 0;
  }

  static int on_find(sd_bus*, const char*, const char*, void* self, void** found, sd_bus_error*) {
    *found = self;
    return 1;
  }
  static int on_version(sd_bus*, const char*, const char*, const char*, sd_bus_message* reply, void*, sd_bus_error*) {
    return sd_bus_message_append(reply, "u", std::uint32_t{3});
  }
  static int on_close(sd_bus_message* message, void* self, sd_bus_error*) {
    ++static_cast<FakePortal*>(self)->closed;
    return sd_bus_reply_method_return(message, "");
  }

  static int on_call(sd_bus_message* message, void* self, sd_bus_error* error) {
    FakePortal& portal = *static_cast<FakePortal*>(self);
    const char* parent = nullptr;
    const char* title = nullptr;
    sd_bus_message_read(message, "ss", &parent, &title);
    Call call{.method = sd_bus_message_get_member(message), .parent = parent};
    sd_bus_message_enter_container(message, 'a', "{sv}");
    while (sd_bus_message_enter_container(message, 'e', "sv") > 0) {
      const char* key = nullptr;
      sd_bus_message_read(message, "s", &key);
      const std::string_view option = key;
      if (option == "current_folder") {
        const void* bytes = nullptr;
        std::size_t size = 0;
        sd_bus_message_enter_container(message, 'v', "ay");
        sd_bus_message_read_array(message, 'y', &bytes, &size);
        sd_bus_message_exit_container(message);
        call.folder.assign(static_cast<const char*>(bytes), size);  // with its zero at the end
      } else {
        const char* value = nullptr;
        sd_bus_message_read(message, "v", "s", &value);
        if (option == "handle_token") call.token = value;
        if (option == "current_name") call.name = value;
      }
      sd_bus_message_exit_container(message);
    }
    std::string sender = sd_bus_message_get_sender(message) + 1;
    std::ranges::replace(sender, '.', '_');
    call.request = std::string(object) + "/request/" + sender + '/' + call.token;
    portal.calls.push_back(call);
    if (portal.refuses) return sd_bus_error_set(error, SD_BUS_ERROR_ACCESS_DENIED, "no");
    if (!portal.answer_at_once.empty()) portal.respond(0, portal.answer_at_once);
    return sd_bus_reply_method_return(message, "o",
                                      (portal.other_handle.empty() ? call.request : portal.other_handle).c_str());
  }
};

}  // namespace ghostforce
