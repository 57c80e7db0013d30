// MotorFinding: what a device's check of its motors has found out: whether each of them moves its own arm or leg, and the
// right way. A plain value that crosses threads; nothing here allocates or throws; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace ghostforce {

enum class MotorVerdict : std::uint8_t {
  none,       // not known yet
  right,      // every motor moves its own encoder, and the right way
  wrong_way,  // one moves it the other way
  crossed,    // they move each other's
  silent,     // one moves nothing
  undecided,  // nothing can be told for a long time
};

struct MotorFinding {
  MotorVerdict verdict = MotorVerdict::none;
  std::size_t motor = 0;  // of wrong_way and silent: which one, from 0

  friend bool operator==(const MotorFinding&, const MotorFinding&) = default;
};
static_assert(std::is_trivially_copyable_v<MotorFinding>);

// Motors must not push.
constexpr bool has_failed(MotorVerdict verdict) noexcept {
  return verdict != MotorVerdict::none && verdict != MotorVerdict::right;
}

// What is wrong, as a sentence; "{}" stands for the motor's number, from 1. Empty where nothing is.
std::string_view sentence_of(MotorVerdict verdict) noexcept;

}  // namespace ghostforce
