#include "device/spacemouse_hid/hid_spacemouse_input.h"

#include <algorithm>
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
#include "device/spacemouse/spacemouse_report.h"

namespace ghostforce {
namespace {

using Trouble = SpaceMouseReading::Trouble;

constexpr std::chrono::milliseconds search_interval{500};
constexpr int read_timeout_ms = 20;  // and so long may the destructor wait

constexpr unsigned short logitech = 0x046D;  // made them until 2013, and makes other mice
constexpr unsigned short connexion = 0x256F;
constexpr unsigned short desktop_page = 1;
constexpr unsigned short multi_axis_controller = 8;

// For systems that do not tell what a device is used for.
constexpr unsigned short logitech_products[] = {0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625,
                                                0xC626, 0xC627, 0xC628, 0xC629, 0xC62B};
constexpr unsigned short connexion_products[] = {0xC62E, 0xC62F, 0xC631, 0xC632, 0xC633, 0xC635, 0xC636, 0xC652};

// One device shows several of these entries: a receiver, for instance, is a keyboard too.
bool is_space_mouse(const hid_device_info& info) noexcept {
  if (info.vendor_id != logitech && info.vendor_id != connexion) return false;
  if (info.usage_page != 0) return info.usage_page == desktop_page && info.usage == multi_axis_controller;
  return info.vendor_id == logitech
             ? std::ranges::find(logitech_products, info.product_id) != std::end(logitech_products)
             : std::ranges::find(connexion_products, info.product_id) != std::end(connexion_products);
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
    if (!is_space_mouse(*info)) continue;
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
