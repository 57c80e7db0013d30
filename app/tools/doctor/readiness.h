// How ready a device with motors is (device/report/motor_report.h), with what is happening in each step now and what to
// do. The window and `doctor` show the same. What is a device's own, its catalog of steps and faults with their words, is
// in a file for each (falcon_readiness.cpp, haply_readiness.cpp), which hands it on as DeviceSteps. Pure, allocates; not
// for the servo thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/failure.h"
#include "device/report/motor_report.h"

namespace ghostforce {

// Of the device, of which what draws the steps knows nothing else.
enum class FalconFault : std::uint8_t;
class DeviceSerial;
enum class HaplyFault : std::uint8_t;
struct FalconReport;
struct HaplyReport;
struct MotorReport;

struct ReadinessEntry {
  ReadinessStep id;
  ExitCode exit_code;           // of a program that could not reach it; done: that is no failure
  std::string_view name;        // in JSON
  std::string_view title;       // on screen
  std::string_view open_title;  // on screen while it is the next one to reach
  std::string_view remedy;      // what to do to reach it, where no fault says it better
  std::string_view reached;     // what is so then; empty where a report says more
};

// In the order of ReadinessStep, of a Falcon. Exit codes and names are the same for all devices.
std::span<const ReadinessEntry> readiness_catalog() noexcept;
const ReadinessEntry& entry_of(ReadinessStep step) noexcept;

// What the steps of one device are made of.
struct DeviceSteps {
  std::span<const ReadinessEntry> catalog;  // in the order of ReadinessStep, with this device's words
  ReadinessStep way;                        // the first that it has not reached, up to encoders_move
  bool is_readable = false;
  bool encoders_move = false;
  bool is_guarded = true;
  bool is_fast_and_even = false;
  bool may_still_push = false;
  double exchange_hz = 0.0;  // that it makes or could make; 0: not measured yet
  double exchange_s = 0.0;
  double worst_exchange_s = 0.0;
  std::string_view fault_sentence{};  // what is wrong now; empty: nothing
  std::string_view fault_remedy{};
  std::string still_pushing{};   // what to do about motors that may
  std::string seen_words{};      // what is known of it; empty: the catalog says it
  std::string firmware_words{};  // while that is not reached; empty: the catalog says it
  std::string homed_words{};     // likewise, before the catalog's remedy
  std::string moved_words{};
  std::string finding_words{};  // what the check of the motors has found, and what to do; empty: the reason says it
};

std::vector<ReadinessStepState> readiness_of(const DeviceSteps& device, const MotorReport* motors);

// What is wrong, and what to do about it, as sentences; empty for none.
std::string_view sentence_of(FalconFault fault) noexcept;
std::string_view remedy_of(FalconFault fault) noexcept;

// That this Falcon was told to stop and has not answered, and what to do now.
std::string left_pushing_words(const DeviceSerial& serial);

// Why a device that is well may not push: nobody guards its motors, and what to do about it.
std::string_view no_guard() noexcept;

// Whether the device can exchange often enough, and answers none too late. Until it is homed the driver asks less often
// than it could; then the time of one answer tells.
bool is_fast_and_even(const FalconReport& report) noexcept;

// Exchanges that it makes, or could make while it is being homed [1/s]; 0: not measured yet.
double attainable_exchange_hz(const FalconReport& report) noexcept;

// `motors` null: nobody means to arm, and the steps end at fast_enough.
std::vector<ReadinessStepState> readiness_of(const FalconReport& report, const MotorReport* motors);
std::vector<ReadinessStepState> readiness_of(const HaplyReport& report, const MotorReport* motors);

std::string_view sentence_of(HaplyFault fault) noexcept;
std::string_view remedy_of(HaplyFault fault) noexcept;

// How a program ends that was to use the device of this readiness. `needs_homing`: somebody was there to do it.
ExitCode exit_code_of(std::span<const ReadinessStepState> readiness, bool needs_homing);
ExitCode exit_code_of(const FalconReport& report, bool needs_homing);

}  // namespace ghostforce
