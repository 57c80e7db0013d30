// Which serial ports over USB this system has, and behind which of them a board for a Haply 2DIY may be: for the port that
// opens one, and for the diagnosis that tells a person why it could not. A board cannot be known for certain: it shows the
// identity of every other one of its make. So nothing here opens a port, and what is opened is a person's choice.
//
// May take some ms, allocates; any thread. Never throws: what cannot be found out is left empty.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

// The USB identity of boards that the published firmwares run on.
struct KnownBoard {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string_view title;  // for people
};
std::span<const KnownBoard> known_board_catalog() noexcept;
// Its encoders may count half of what the variant says.
inline constexpr std::string_view m0_board = "M0 board";

// Where the system shows its devices.
struct SerialPortPlaces {
  std::string sysfs = "/sys";
  std::string nodes = "/dev";
};

// A port, and the USB device that it belongs to.
struct SerialPortFound {
  std::string path;   // /dev/ttyACM0
  std::string by_id;  // the link to it that is the same wherever it is plugged in; empty: none
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string serial;  // empty: the device has none
  std::string socket;  // where the device is plugged in, as the system numbers its USB sockets: 1-2.3
  std::string product_name;
  std::string manufacturer;
  std::string_view board;  // the title of a known one; empty: something else

  bool has_node = false;  // what follows is known
  bool may_open = false;  // by this user, for reading and writing, as the node's permissions have it
  uid_t owner = 0;
  gid_t group = 0;
  mode_t mode = 0;  // permission bits

  // What tells the device from others: its serial number; where it has none, its make and its socket. Two of one make
  // that change places are then taken for each other, and one that comes back in another socket for another one.
  std::string identity() const;
};

// By their paths.
std::vector<SerialPortFound> list_serial_ports(const SerialPortPlaces& places = {}) noexcept;

// The one of them whose node this is, a path with all links followed. Null: it is not among them. May throw
// std::bad_alloc.
const SerialPortFound* find_port(std::span<const SerialPortFound> ports, const std::string& node);

}  // namespace ghostforce
