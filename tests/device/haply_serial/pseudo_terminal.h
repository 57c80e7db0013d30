// A pseudo terminal whose far end is the test's: what a board would receive and answer.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ghostforce {

using Bytes = std::vector<std::uint8_t>;

class PseudoTerminal {
 public:
  PseudoTerminal() : far_end_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    std::array<char, 64> path{};
    if (far_end_ < 0 || grantpt(far_end_) != 0 || unlockpt(far_end_) != 0 ||
        ptsname_r(far_end_, path.data(), path.size()) != 0) {
      throw std::runtime_error("no pseudo terminal");
    }
    path_ = path.data();
  }
  ~PseudoTerminal() { hang_up(); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& path() const { return path_; }
  int far_end() const { return far_end_; }

  void hang_up() {
    if (far_end_ >= 0) close(std::exchange(far_end_, -1));
  }

  void send(std::span<const std::uint8_t> bytes) const {
    if (write(far_end_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
      throw std::runtime_error("not sent");
    }
  }

  // What one call of read() gives, once there is something; empty: the near end was closed, or nothing comes.
  Bytes receive() const {
    constexpr int patience_ms = 60'000;  // of a run that goes wrong
    pollfd end{far_end_, POLLIN, 0};
    Bytes bytes(1 << 16);
    const bool is_there = poll(&end, 1, patience_ms) == 1;
    const ssize_t count = is_there ? read(far_end_, bytes.data(), bytes.size()) : -1;
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  // So many of them.
  Bytes receive(std::size_t count) const {
    Bytes all;
    while (all.size() < count) {
      const Bytes more = receive();
      if (more.empty()) break;
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }

  // All until nobody has the near end open.
  Bytes receive_all() const { return receive(~std::size_t{0}); }

 private:
  int far_end_;
  std::string path_;
};

inline Bytes bytes_of(std::span<const std::uint8_t> packet) {
  return {packet.begin(), packet.end()};
}

}  // namespace ghostforce
