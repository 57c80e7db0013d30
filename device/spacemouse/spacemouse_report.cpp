#include "device/spacemouse/spacemouse_report.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr std::uint8_t translation_report = 1;  // or all axes
constexpr std::uint8_t rotation_report = 2;
constexpr std::uint8_t button_report = 3;
constexpr std::size_t axis_size = 2;
constexpr double full_scale = 350.0;

void take_axes(std::span<const std::uint8_t> bytes, std::span<int> axes) noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const unsigned low = bytes[axis_size * i];
    const unsigned high = bytes[axis_size * i + 1];
    axes[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(low | high << 8U));
  }
}

}  // namespace

bool take_report(std::span<const std::uint8_t> report, SpaceMouseState& state) noexcept {
  return !report.empty() && take_report(report[0], report.subspan(1), state);
}

bool take_report(std::uint8_t number, std::span<const std::uint8_t> bytes, SpaceMouseState& state) noexcept {
  const std::span<int> axes = state.axes;
  switch (number) {
    case translation_report:
      if (bytes.size() < 3 * axis_size) return false;
      take_axes(bytes, bytes.size() < 6 * axis_size ? axes.first(3) : axes);
      return true;
    case rotation_report:
      if (bytes.size() < 3 * axis_size) return false;
      take_axes(bytes, axes.last(3));
      return true;
    case button_report:
      if (bytes.empty()) return false;
      state.buttons = 0;
      for (std::size_t i = 0; i < std::min(bytes.size(), sizeof state.buttons); ++i) {
        state.buttons |= std::uint32_t{bytes[i]} << 8U * i;
      }
      return true;
    default:
      return false;
  }
}

void show(const SpaceMouseState& state, SpaceMouseReading& reading) noexcept {
  for (std::size_t i = 0; i < reading.axes.size(); ++i) {
    reading.axes[i] = std::clamp(state.axes[i] / full_scale, -1.0, 1.0);
  }
  reading.buttons = state.buttons;
}

}  // namespace ghostforce
