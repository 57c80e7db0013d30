// The inputs of the page: those of every system, and a SpaceMouse where the browser has one to give. A Falcon is not
// among them. Main thread; making an input allocates and may throw.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "app/shell/input_link.h"
#include "device/spacemouse/spacemouse_input.h"
#include "device/spacemouse/spacemouse_report.h"

namespace ghostforce {

// In the order in which people see them.
std::vector<InputEntry> page_inputs();

inline constexpr std::string_view why_no_falcon_in_page =
    "A Falcon needs the desktop program: a browser may put a tab to sleep, and its motors with it. The Virtual Falcon "
    "rehearses it.";

// The hand on a SpaceMouse that the browser (WebHID) lets the page read. One that the person has permitted to the page
// is opened by itself, also when it is plugged in later; else the browser asks the person, once the input is chosen, or
// whenever ask() is called.
class BrowserSpaceMouseInput final : public SpaceMouseInput {
 public:
  // Whether this browser has WebHID: Chrome and Edge have it.
  static bool is_offered();

  BrowserSpaceMouseInput();
  ~BrowserSpaceMouseInput() override;

  // Browsers only ask just after the person has pressed something.
  void ask();

  // What the browser calls.
  struct Events;

 private:
  std::string_view buffer_text() const noexcept;
  void open_with_name(std::string_view name) noexcept;
  void be_without(SpaceMouseReading::Trouble trouble) noexcept;
  void take(std::uint8_t number, std::size_t size) noexcept;

  std::array<std::uint8_t, 64> buffer_{};  // what the browser tells: the bytes of a report, or a name that ends in 0
  SpaceMouseReading reading_;
  SpaceMouseState state_;
  std::uint32_t connections_ = 0;
};

}  // namespace ghostforce
