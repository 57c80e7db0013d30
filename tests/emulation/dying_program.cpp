// Takes the Falcon and dies of SIGABRT, in whose handler it sends a last frame.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "device/falcon_usb/ftdi_link.h"

namespace {

ghostforce::FtdiLink* the_link = nullptr;

extern "C" void send_last_frame(int /*signal*/) {
  static constexpr char frame[] = "<AAAAAAAAAAAAAA>";
  std::uint8_t bytes[sizeof frame - 1];
  for (std::size_t i = 0; i < sizeof bytes; ++i) bytes[i] = static_cast<std::uint8_t>(frame[i]);
  the_link->send_at_once(bytes);
}

}  // namespace

int main() {
  static ghostforce::FtdiLink link;
  the_link = &link;
  const ghostforce::LinkFault fault = link.open();
  if (fault != ghostforce::LinkFault::none) {
    std::fprintf(stderr, "cannot open: %d\n", static_cast<int>(fault));
    return 1;
  }
  std::signal(SIGABRT, send_last_frame);
  std::abort();
}
