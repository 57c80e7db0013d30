#include "app/shell/desktop/portal_file_chooser.h"

#include <pthread.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/files/file_uri.h"
#include "app/shell/desktop/bus.h"
#include "device/input/thread_signals.h"

namespace ghostforce {
namespace {

// As the portal's documentation has them.
constexpr const char* portal_service = "org.freedesktop.portal.Desktop";
constexpr const char* portal_object = "/org/freedesktop/portal/desktop";
constexpr const char* chooser_interface = "org.freedesktop.portal.FileChooser";
constexpr const char* request_interface = "org.freedesktop.portal.Request";

enum class Response : std::uint32_t { success = 0, cancelled = 1 };  // others: it was ended in some other way

constexpr std::string_view failed_words = "The desktop's dialog for files has failed. Type the path instead.";

// The portal, and at most one dialog of it. Nothing here waits.
class Portal {
 public:
  Portal(const BusLibrary& library, std::atomic<bool>& is_there, std::function<void(FileAnswer)> answer)
      : library_(library), connection_(library, library.open_user), is_there_(is_there), answer_(std::move(answer)) {
    if (connection_.bus() == nullptr) return;
    // Of every request, before the first is made: one may be answered before its call is.
    library_.match_signal_async(connection_.bus(), nullptr, portal_service, nullptr, request_interface, "Response",
                                on_response, nullptr, this);
    library_.match_signal_async(connection_.bus(), nullptr, "org.freedesktop.DBus", "/org/freedesktop/DBus",
                                "org.freedesktop.DBus", "NameOwnerChanged", on_owner_changed, nullptr, this);
    look_for_it();
  }
  ~Portal() {
    is_there_ = false;
    fail();
  }
  Portal(const Portal&) = delete;
  Portal& operator=(const Portal&) = delete;

  BusConnection& connection() noexcept { return connection_; }

  // The dialog before, which nobody has answered, is closed.
  void ask(const std::string& parent, const FileQuestion& question) {
    close();
    question_ = question;
    is_asking_ = true;
    const std::string token = fmt::format("ghostforce{}", ++requests_);
    request_ = request_path(token);
    handle_.clear();
    sd_bus_message* message = nullptr;
    const bool is_new = question.new_file.has_value();
    bool is_well = library_.message_new_method_call(connection_.bus(), &message, portal_service, portal_object,
                                                    chooser_interface, is_new ? "SaveFile" : "OpenFile") >= 0;
    is_well = is_well && library_.message_append(message, "ss", parent.c_str(), is_new ? "Save" : "Open a file") >= 0;
    is_well = is_well && library_.message_open_container(message, SD_BUS_TYPE_ARRAY, "{sv}") >= 0;
    is_well = is_well && library_.message_append(message, "{sv}", "handle_token", "s", token.c_str()) >= 0;
    if (is_new) {
      const std::filesystem::path proposed(*question.new_file);
      is_well =
          is_well && library_.message_append(message, "{sv}", "current_name", "s", proposed.filename().c_str()) >= 0;
      if (proposed.has_parent_path()) is_well = is_well && append_folder(*message, proposed.parent_path().string());
    }
    is_well = is_well && library_.message_close_container(message) >= 0;
    // Portals answer the call itself at once, however long the person takes.
    is_well = is_well && library_.call_async(connection_.bus(), nullptr, message, on_reply, this, 0) >= 0;
    library_.message_unref(message);
    if (!is_well) fail();
  }

 private:
  // Where the portal will say what has been chosen: it is made of the name that the bus has given to this connection.
  std::string request_path(const std::string& token) const {
    const char* name = nullptr;
    if (library_.get_unique_name(connection_.bus(), &name) < 0) return {};
    std::string sender = name + 1;  // without its colon
    std::ranges::replace(sender, '.', '_');
    return fmt::format("{}/request/{}/{}", portal_object, sender, token);
  }

  // As bytes that end in zero.
  bool append_folder(sd_bus_message& message, const std::string& folder) const {
    return library_.message_open_container(&message, SD_BUS_TYPE_DICT_ENTRY, "sv") >= 0 &&
           library_.message_append(&message, "s", "current_folder") >= 0 &&
           library_.message_open_container(&message, SD_BUS_TYPE_VARIANT, "ay") >= 0 &&
           library_.message_append_array(&message, 'y', folder.c_str(), folder.size() + 1) >= 0 &&
           library_.message_close_container(&message) >= 0 && library_.message_close_container(&message) >= 0;
  }

  // Also begins it, where it only begins when somebody asks.
  void look_for_it() noexcept {
    library_.call_method_async(connection_.bus(), nullptr, portal_service, portal_object,
                               "org.freedesktop.DBus.Properties", "Get", on_version, this, "ss", chooser_interface,
                               "version");
  }

  void close() {
    if (!std::exchange(is_asking_, false)) return;
    const std::string& path = handle_.empty() ? request_ : handle_;
    library_.call_method_async(connection_.bus(), nullptr, portal_service, path.c_str(), request_interface, "Close",
                               nullptr, nullptr, "");
  }

  void finish(std::vector<std::string> paths, std::string problem) {
    if (!std::exchange(is_asking_, false)) return;
    answer_({.question = question_, .paths = std::move(paths), .problem = std::move(problem)});
  }
  void fail() { finish({}, std::string(failed_words)); }

  static int on_version(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Portal& portal = *static_cast<Portal*>(self);
    portal.is_there_ = portal.library_.message_is_method_error(message, nullptr) <= 0;
    return 0;
  }

  static int on_owner_changed(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Portal& portal = *static_cast<Portal*>(self);
    const char* name = nullptr;
    const char* before = nullptr;
    const char* after = nullptr;
    if (portal.library_.message_read(message, "sss", &name, &before, &after) < 0) return 0;
    if (std::string_view(name) != portal_service) return 0;
    // Its dialogs have gone with it.
    if (*before != '\0') portal.fail();
    portal.is_there_ = false;
    if (*after != '\0') portal.look_for_it();
    return 0;
  }

  static int on_reply(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Portal& portal = *static_cast<Portal*>(self);
    const char* handle = nullptr;
    if (portal.library_.message_is_method_error(message, nullptr) > 0) {
      portal.fail();
    } else if (portal.library_.message_read(message, "o", &handle) >= 0) {
      portal.handle_ = handle;  // of portals that do not know the token, another path
    }
    return 0;
  }

  static int on_response(sd_bus_message* message, void* self, sd_bus_error* /*error*/) noexcept {
    Portal& portal = *static_cast<Portal*>(self);
    const char* const path = portal.library_.message_get_path(message);
    if (!portal.is_asking_ || path == nullptr || (path != portal.request_ && path != portal.handle_)) return 0;
    portal.take_response(*message);
    return 0;
  }

  void take_response(sd_bus_message& message) {
    std::uint32_t response = 0;
    if (library_.message_read(&message, "u", &response) < 0) return fail();
    if (response == static_cast<std::uint32_t>(Response::cancelled)) return finish({}, {});
    if (response != static_cast<std::uint32_t>(Response::success)) return fail();
    std::vector<std::string> paths;
    std::string problem;
    for (const std::string& uri : read_uris(message)) {
      if (std::optional<std::string> path = path_of_file_uri(uri)) {
        paths.push_back(std::move(*path));
      } else {
        problem = fmt::format("{} is not a file of this computer. Copy it to a folder first.",
                              quoted_text(uri, longest_path));
      }
    }
    if (paths.empty() && problem.empty()) return fail();
    finish(std::move(paths), std::move(problem));
  }

  // Empty where there are none, or they cannot be read.
  std::vector<std::string> read_uris(sd_bus_message& message) const {
    std::vector<std::string> uris;
    if (library_.message_enter_container(&message, SD_BUS_TYPE_ARRAY, "{sv}") < 0) return uris;
    while (library_.message_enter_container(&message, SD_BUS_TYPE_DICT_ENTRY, "sv") > 0) {
      const char* key = nullptr;
      if (library_.message_read(&message, "s", &key) < 0) return uris;
      if (std::string_view(key) == "uris") {
        if (library_.message_enter_container(&message, SD_BUS_TYPE_VARIANT, "as") < 0 ||
            library_.message_enter_container(&message, SD_BUS_TYPE_ARRAY, "s") < 0) {
          return uris;
        }
        const char* uri = nullptr;
        while (library_.message_read(&message, "s", &uri) > 0) uris.emplace_back(uri);
        return uris;
      }
      if (library_.message_skip(&message, "v") < 0 || library_.message_exit_container(&message) < 0) return uris;
    }
    return uris;
  }

  const BusLibrary& library_;
  BusConnection connection_;
  std::atomic<bool>& is_there_;
  std::function<void(FileAnswer)> answer_;
  bool is_asking_ = false;
  FileQuestion question_;  // that is being asked
  std::string request_;    // its path, as it must be,
  std::string handle_;     // and as the portal says
  int requests_ = 0;       // so far
};

}  // namespace

PortalFileChooser::PortalFileChooser(std::string parent)
    : parent_(std::move(parent)), news_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), thread_([this] { watch(); }) {
  use_file_chooser(this);
}

PortalFileChooser::~PortalFileChooser() {
  use_file_chooser(nullptr);
  is_ending_ = true;
  eventfd_write(news_.number(), 1);
  thread_.join();
}

void PortalFileChooser::ask(const FileQuestion& question) {
  {
    const std::lock_guard lock(mutex_);
    question_ = question;
  }
  eventfd_write(news_.number(), 1);
}

std::optional<FileQuestion> PortalFileChooser::take_question() {
  const std::lock_guard lock(mutex_);
  return std::exchange(question_, {});
}

void PortalFileChooser::answer(FileAnswer answer) {
  const std::lock_guard lock(mutex_);
  answer_ = std::move(answer);
  has_answer_ = true;
}

FileAnswer PortalFileChooser::take_answer() {
  const std::lock_guard lock(mutex_);
  has_answer_ = false;
  return std::exchange(answer_, {});
}

void PortalFileChooser::watch() noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "file-chooser");
  const BusLibrary library;
  if (!library.is_complete) return;
  while (!is_ending_) {
    {
      Portal portal(library, is_there_, [this](FileAnswer given) { answer(std::move(given)); });
      while (!is_ending_ && portal.connection().process()) {
        if (const std::optional<FileQuestion> question = take_question()) {
          portal.ask(parent_, *question);
        } else {
          portal.connection().wait(news_.number());
        }
      }
    }
    if (std::optional<FileQuestion> question = take_question()) {
      answer({.question = std::move(*question), .problem = std::string(failed_words)});
    }
    if (!is_ending_) wait_for_bus(news_.number());
  }
}

}  // namespace ghostforce
