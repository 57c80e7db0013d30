#include "device/haply_serial/port_search.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

constexpr std::array boards{
    KnownBoard{0x2341, 0x804D, m0_board},  // as an Arduino Zero, by its own USB port
    // As an Arduino Due, likewise; the second is of the maker's other name.
    KnownBoard{0x2341, 0x003E, "Due-based board"},
    KnownBoard{0x2A03, 0x003E, "Due-based board"},
};

// An attribute of sysfs is one line.
std::string line_of(const fs::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  return line;
}

std::uint16_t usb_number_of(const fs::path& file) {
  constexpr int hexadecimal = 16;
  return static_cast<std::uint16_t>(std::strtoul(line_of(file).c_str(), nullptr, hexadecimal));
}

// The nearest one at or above a device that is a USB device: between it and the port there is an interface, and with some
// drivers more. Empty: none, as for the ports that a machine has built in.
fs::path usb_device_above(fs::path device, const fs::path& sysfs) {
  std::error_code error;
  const fs::path top = fs::canonical(sysfs, error);
  for (device = fs::canonical(device, error); !error && device != top && device.has_relative_path();
       device = device.parent_path()) {
    if (fs::exists(device / "idVendor", error)) return device;
  }
  return {};
}

std::string_view board_of(const SerialPortFound& port) {
  const auto found = std::ranges::find_if(
      boards, [&port](const KnownBoard& each) { return each.vendor == port.vendor && each.product == port.product; });
  return found == boards.end() ? std::string_view() : found->title;
}

std::string link_to(const fs::path& node, const fs::path& folder) {
  std::error_code error;
  const fs::path end = fs::canonical(node, error);
  if (error) return {};
  std::error_code no_folder;
  for (const fs::directory_entry& link : fs::directory_iterator(folder, no_folder)) {
    if (fs::canonical(link.path(), error) == end) return link.path().string();
  }
  return {};
}

void look_at_node(SerialPortFound& port) {
  struct stat status {};
  if (stat(port.path.c_str(), &status) != 0) return;
  port.has_node = true;
  port.owner = status.st_uid;
  port.group = status.st_gid;
  port.mode = status.st_mode & 07777U;
  port.may_open = faccessat(AT_FDCWD, port.path.c_str(), R_OK | W_OK, AT_EACCESS) == 0;
}

std::vector<SerialPortFound> ports_of(const SerialPortPlaces& places) {
  std::vector<SerialPortFound> ports;
  std::error_code error;
  for (const fs::directory_entry& terminal : fs::directory_iterator(fs::path(places.sysfs) / "class/tty", error)) {
    const fs::path device = usb_device_above(terminal.path() / "device", places.sysfs);
    if (device.empty()) continue;
    SerialPortFound port;
    port.path = (fs::path(places.nodes) / terminal.path().filename()).string();
    port.by_id = link_to(port.path, fs::path(places.nodes) / "serial/by-id");
    port.vendor = usb_number_of(device / "idVendor");
    port.product = usb_number_of(device / "idProduct");
    port.serial = line_of(device / "serial");
    port.socket = device.filename().string();
    port.product_name = line_of(device / "product");
    port.manufacturer = line_of(device / "manufacturer");
    port.board = board_of(port);
    look_at_node(port);
    ports.push_back(std::move(port));
  }
  // ttyACM2 before ttyACM10.
  std::ranges::sort(ports, {}, [](const SerialPortFound& port) { return std::tuple(port.path.size(), port.path); });
  return ports;
}

}  // namespace

std::string SerialPortFound::identity() const {
  if (!serial.empty()) return serial;
  constexpr std::size_t longest_make = std::string_view("2341:003e").size();
  std::array<char, longest_make + 1> make{};
  std::snprintf(make.data(), make.size(), "%04x:%04x", unsigned{vendor}, unsigned{product});
  return std::string(make.data()) + " in socket " + socket;
}

std::span<const KnownBoard> known_board_catalog() noexcept {
  return boards;
}

std::vector<SerialPortFound> list_serial_ports(const SerialPortPlaces& places) noexcept {
  try {
    return ports_of(places);
  } catch (const std::exception&) {  // out of memory, or a folder that went away
    return {};
  }
}

const SerialPortFound* find_port(std::span<const SerialPortFound> ports, const std::string& node) {
  const auto port = std::ranges::find_if(ports, [&node](const SerialPortFound& each) {
    std::error_code gone;
    return fs::canonical(each.path, gone) == node;
  });
  return port == ports.end() ? nullptr : &*port;
}

}  // namespace ghostforce
