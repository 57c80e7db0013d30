// The search for ports, in folders that look as a system's do.
#include "device/haply_serial/port_search.h"

#include <sys/stat.h>
#include <unistd.h>

#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/device/haply_serial/mock_system.h"
#include "tests/support/places.h"

namespace ghostforce::port_search_test {
namespace {

TEST(PortSearch, TellsWhatStandsBehindAPort) {
  const MockSystem system;
  const TemporaryFolder files;
  write_whole(files / "node", "");
  ASSERT_EQ(chmod((files / "node").c_str(), 0640), 0);
  system.add("ttyACM0", {"2341", "804d", "6E1F0C", "Arduino Zero", "Arduino LLC"}, files / "node");
  const std::string link = system.add_by_id("usb-Arduino_LLC_Arduino_Zero_6E1F0C-if00", "ttyACM0");
  const auto ports = list_serial_ports(system.places());
  ASSERT_EQ(ports.size(), 1U);
  const SerialPortFound& port = ports[0];
  EXPECT_EQ(port.path, system.node("ttyACM0"));
  EXPECT_EQ(port.by_id, link);
  EXPECT_EQ(port.vendor, 0x2341);
  EXPECT_EQ(port.product, 0x804D);
  EXPECT_EQ(port.serial, "6E1F0C");
  EXPECT_EQ(port.product_name, "Arduino Zero");
  EXPECT_EQ(port.manufacturer, "Arduino LLC");
  EXPECT_EQ(port.board, "M0 board");
  EXPECT_TRUE(port.has_node);
  EXPECT_TRUE(port.may_open);
  EXPECT_EQ(port.owner, geteuid());
  EXPECT_EQ(port.mode, mode_t{0640});
}

TEST(PortSearch, KnowsBoardsByTheirIdentity) {
  const MockSystem system;
  const TemporaryFolder files;
  write_whole(files / "node", "");
  system.add("ttyACM10", {"2a03", "003e"}, files / "node");
  system.add("ttyACM2", {"2341", "003e"}, files / "node");
  system.add("ttyACM3", {"2341", "003d"}, files / "node");  // the Due's other port, of another chip
  system.add("ttyUSB0", {"0403", "6001"}, files / "node");
  const auto ports = list_serial_ports(system.places());
  ASSERT_EQ(ports.size(), 4U);
  EXPECT_EQ(ports[0].path, system.node("ttyACM2"));
  EXPECT_EQ(ports[0].board, "Due-based board");
  EXPECT_EQ(ports[1].path, system.node("ttyACM3"));
  EXPECT_EQ(ports[1].board, "");
  EXPECT_EQ(ports[2].path, system.node("ttyUSB0"));
  EXPECT_EQ(ports[2].board, "");
  EXPECT_EQ(ports[3].path, system.node("ttyACM10"));
  EXPECT_EQ(ports[3].board, "Due-based board");
  EXPECT_EQ(ports[3].serial, "");
}

TEST(PortSearch, LeavesOutWhatNoBoardIsAt) {
  const MockSystem system;
  system.add_built_in("ttyS0");
  system.add_console("tty0");
  EXPECT_TRUE(list_serial_ports(system.places()).empty());
}

// A container shows a device and gives no node, or none at all of both.
TEST(PortSearch, NeedsNothingOfASystem) {
  const MockSystem system;
  system.add("ttyACM0", {"2341", "804d"}, "/nonexistent");
  const auto ports = list_serial_ports(system.places());
  ASSERT_EQ(ports.size(), 1U);
  EXPECT_FALSE(ports[0].has_node);
  EXPECT_FALSE(ports[0].may_open);
  EXPECT_EQ(ports[0].board, "M0 board");
  EXPECT_TRUE(list_serial_ports({.sysfs = "/nonexistent", .nodes = "/nonexistent"}).empty());
}

TEST(PortSearch, TellsWhatThisUserMayNotOpen) {
  const MockSystem system;
  const TemporaryFolder files;
  write_whole(files / "node", "");
  ASSERT_EQ(chmod((files / "node").c_str(), 0), 0);
  ASSERT_EQ(chmod(files.path().c_str(), 0755), 0);
  system.add("ttyACM0", {"2341", "804d"}, files / "node");
  ASSERT_EQ(chmod(std::filesystem::path(system.places().nodes).parent_path().c_str(), 0755), 0);
  const auto look = [&system] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) _exit(2);
    const auto ports = list_serial_ports(system.places());
    _exit(ports.size() == 1 && ports[0].has_node && !ports[0].may_open ? 0 : 1);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

// As a serial port and as a USB device: for the person at the machine, and not for ModemManager.
TEST(PortSearch, TheUdevRuleNamesEachBoard) {
  const std::string rule = read_whole(source_path("/assets/udev/70-ghostforce.rules"));
  ASSERT_FALSE(rule.empty());
  for (const KnownBoard& board : known_board_catalog()) {
    for (const std::string_view subsystem : {"tty", "usb"}) {
      int lines = 0;
      std::istringstream all(rule);
      for (std::string line; std::getline(all, line);) {
        const auto has = [&line](const std::string& words) { return line.find(words) != std::string::npos; };
        const bool is_about_it = has(fmt::format("SUBSYSTEM==\"{}\"", subsystem)) &&
                                 has(fmt::format("{{idVendor}}==\"{:04x}\"", board.vendor)) &&
                                 has(fmt::format("{:04x}", board.product));
        if (is_about_it && has("TAG+=\"uaccess\"") && has("ENV{ID_MM_DEVICE_IGNORE}=\"1\"")) ++lines;
      }
      EXPECT_EQ(lines, 1) << board.title << ' ' << subsystem;
    }
  }
}

// Whatever there is, it ends and opens nothing.
TEST(PortSearch, LooksAtThisMachine) {
  for (const SerialPortFound& port : list_serial_ports()) EXPECT_TRUE(port.path.starts_with("/dev/")) << port.path;
}

}  // namespace
}  // namespace ghostforce::port_search_test
