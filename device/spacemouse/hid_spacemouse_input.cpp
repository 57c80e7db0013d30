#include "device/spacemouse/hid_spacemouse_input.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

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

struct CloseDevice {
  void operator()(hid_device* device) const noexcept { hid_close(device); }
};
using Device = std::unique_ptr<hid_device, CloseDevice>;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();  // what cannot be read is empty
  return text.str();
}

// What stands after NAME= in the kernel's description of a device; empty if it is not there, or the device no longer is.
std::string value_of(const std::string& uevent, const std::string& name) {
  std::istringstream lines(uevent);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name + '=')) return line.substr(name.size() + 1);
  }
  return {};
}

// The vendor's number in HID_ID=bus:vendor:product, hexadecimal; 0 if there is none.
std::uint16_t vendor_in(const std::string& id) {
  unsigned bus = 0;
  unsigned vendor = 0;
  return std::sscanf(id.c_str(), "%x:%x:", &bus, &vendor) == 2 ? static_cast<std::uint16_t>(vendor) : std::uint16_t{0};
}

// As people know it: the kernel puts the maker before it.
std::array<char, 64> shown_name(std::string_view name) noexcept {
  constexpr std::string_view maker = "3Dconnexion ";
  if (name.starts_with(maker)) name.remove_prefix(maker.size());
  std::array<char, 64> shown{};
  for (std::size_t i = 0; i < name.size() && i + 1 < shown.size(); ++i) {
    const auto letter = static_cast<unsigned char>(name[i]);
    shown[i] = letter >= 0x20 && letter < 0x7F ? name[i] : '?';  // printable ASCII
  }
  return shown;
}

// The kernel's list of HID devices, in the order of their names. hidapi's own (0.13) ends the program where a device is
// unplugged while it looks.
std::vector<std::filesystem::path> listed_devices() {
  std::vector<std::filesystem::path> entries;
  std::error_code error;  // a kernel without such devices has no list
  for (std::filesystem::directory_iterator entry("/sys/class/hidraw", error), end; !error && entry != end;
       entry.increment(error)) {
    entries.push_back(entry->path());
  }
  std::ranges::sort(entries);
  return entries;
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
  for (const std::filesystem::path& entry : listed_devices()) {
    const std::string uevent = text_of(entry / "device/uevent");
    const std::string descriptor = text_of(entry / "device/report_descriptor");
    if (!is_spacemouse(vendor_in(value_of(uevent, "HID_ID")), descriptor)) continue;
    const std::filesystem::path file = "/dev" / entry.filename();
    reading.name = shown_name(value_of(uevent, "HID_NAME"));
    Device device(hid_open_path(file.c_str()));
    reading.trouble = device ? Trouble::none : why_not(file.c_str());
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
