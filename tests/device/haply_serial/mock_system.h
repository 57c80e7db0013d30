// The folders by which a system shows its serial ports, made up in a temporary folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "device/haply_serial/port_search.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

struct MockUsbDevice {
  std::string_view vendor;
  std::string_view product;
  std::string_view serial{};
  std::string_view product_name{};
  std::string_view manufacturer{};
};

class MockSystem {
 public:
  MockSystem() {
    std::filesystem::create_directories(folder_ / "sys/class/tty");
    std::filesystem::create_directories(folder_ / "dev/serial/by-id");
  }

  SerialPortPlaces places() const { return {.sysfs = folder_ / "sys", .nodes = folder_ / "dev"}; }
  std::string node(std::string_view name) const { return folder_ / ("dev/" + std::string(name)); }

  // A port that is an interface of a USB device, as with cdc_acm. Its node is a link to this file.
  void add(const std::string& name, const MockUsbDevice& device, const std::string& file) const {
    const std::string bus = "sys/devices/pci0/usb1/1-" + name;
    add_terminal(name, bus + "/1-" + name + ":1.0");
    write_line(bus + "/idVendor", device.vendor);
    write_line(bus + "/idProduct", device.product);
    write_line(bus + "/serial", device.serial);
    write_line(bus + "/product", device.product_name);
    write_line(bus + "/manufacturer", device.manufacturer);
    std::filesystem::create_symlink(file, node(name));
  }

  // One that is no part of a USB device.
  void add_built_in(const std::string& name) const {
    add_terminal(name, "sys/devices/platform/serial8250");
    write_whole(node(name), "");
  }

  // One without a device, as consoles are.
  void add_console(const std::string& name) const {
    std::filesystem::create_directories(folder_ / ("sys/class/tty/" + name));
    write_whole(node(name), "");
  }

  std::string add_by_id(const std::string& link, const std::string& name) const {
    const std::string path = folder_ / ("dev/serial/by-id/" + link);
    std::filesystem::create_symlink("../../" + name, path);
    return path;
  }

 private:
  void add_terminal(const std::string& name, const std::string& device) const {
    std::filesystem::create_directories(folder_ / device);
    std::filesystem::create_directories(folder_ / ("sys/class/tty/" + name));
    std::filesystem::create_symlink(folder_ / device, folder_ / ("sys/class/tty/" + name + "/device"));
  }

  // An attribute that a device lacks has no file.
  void write_line(const std::string& file, std::string_view text) const {
    if (!text.empty()) write_whole(folder_ / file, std::string(text) + "\n");
  }

  TemporaryFolder folder_;
};

}  // namespace ghostforce
