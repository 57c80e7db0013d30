#include "device/spacemouse_hid/hid_spacemouse_input.h"

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>

#include <fcntl.h>
#include <hidapi.h>
#include <pthread.h>
#include <unistd.h>

#include "device/input/thread_signals.h"
#include "device/spacemouse/spacemouse_products.h"
#include "device/spacemouse/spacemouse_report.h"

namespace ghostforce {
namespace {

using Trouble = SpaceMouseReading::Trouble;

constexpr std::chrono::milliseconds search_interval{500};
constexpr int read_timeout_ms = 20;  // and so long may the destructor wait

bool is_spacemouse_entry(const hid_device_info& info) noexcept {
  return is_spacemouse({info.vendor_id, info.product_id, info.usage_page, info.usage});
}

struct CloseDevice {
  void operator()(hid_device* device) const noexcept { hid_close(device); }
};
using Device = std::unique_ptr<hid_device, CloseDevice>;

struct FreeList {
  void operator()(hid_device_info* list) const noexcept { hid_free_enumeration(list); }
};

std::array<char, 64> narrow(const wchar_t* text) noexcept {
  std::array<char, 64> name{};
  for (std::size_t i = 0; text != nullptr && text[i] != L'\0' && i + 1 < name.size(); ++i) {
    name[i] = text[i] > 0 && text[i] < 128 ? static_cast<char>(text[i]) : '?';
  }
  return name;
}

// hidapi does not tell why it could not open one.
Trouble why_not(const char* path) noexcept {
  const int descriptor = open(path, O_RDWR | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return errno == EACCES || errno == EPERM ? Trouble::not_allowed : Trouble::not_opened;
  close(descriptor);
  return Trouble::not_opened;
}

// The first that can be opened; the reading tells which one it is, or what is in the way.
Device search(SpaceMouseReading& reading) {
  reading.trouble = Trouble::absent;
  const std::unique_ptr<hid_device_info, FreeList> list(hid_enumerate(0, 0));
  for (const hid_device_info* info = list.get(); info != nullptr; info = info->next) {
    if (!is_spacemouse_entry(*info)) continue;
    reading.name = narrow(info->product_string);
    Device device(hid_open_path(info->path));
    reading.trouble = device ? Trouble::none : why_not(info->path);
    if (device) return device;
  }
  return {};
}

}  // namespace

HidSpaceMouseInput::HidSpaceMouseInput(const SpaceMouseSettings& settings)
    : SpaceMouseInput(settings), reader_([this](const std::stop_token& stop) { read(stop); }) {}

void HidSpaceMouseInput::read(const std::stop_token& stop) {
  const AlternateStack alternate_stack;
  pthread_setname_np(pthread_self(), "spacemouse");
  std::mutex mutex;
  std::condition_variable_any stopped;
  SpaceMouseReading reading;
  std::uint32_t connections = 0;
  SpaceMouseState state;
  Device device;
  while (!stop.stop_requested()) {
    if (!device) {
      device = search(reading);
      reading.connection = device ? ++connections : 0;
      publish(reading);
      if (!device) {
        std::unique_lock lock(mutex);
        stopped.wait_for(lock, stop, search_interval, [] { return false; });
      }
      continue;
    }
    std::array<std::uint8_t, 64> report;
    const int size = hid_read_timeout(device.get(), report.data(), report.size(), read_timeout_ms);
    if (size < 0) {  // unplugged
      device.reset();
      state = {};
      show(state, reading);
      reading.connection = 0;
      reading.trouble = Trouble::absent;
      publish(reading);  // at once: looking for it takes its time
    } else if (size > 0 && take_report(std::span(report).first(static_cast<std::size_t>(size)), state)) {
      ++reading.reports;
      show(state, reading);
      publish(reading);
    }
  }
}

}  // namespace ghostforce
