// The receipt of a session, beside its recording: with which program, device, calibration and settings it was made, how
// stiff the hand was, what went wrong and when, how evenly the loop ticked, and how warm the motors may have become. One
// value. receipt_writing.h writes it as JSON for programs and as a page for people (docs/recording.md). UI thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/hand_estimator.h"
#include "core/motor_heat.h"
#include "core/safety.h"
#include "device/report/loop_periods.h"
#include "device/servo/servo.h"

namespace ghostforce {

// What only the front of the program knows.
struct ReceiptOrigin {
  std::string version{};
  std::string commit{};  // empty: unknown
  std::string build{};   // by which compiler, for which system
  std::string libraries{};
  std::string firmware{};  // of the file for a device, in words; empty: there is none
};

// What an input's link knows of its device.
struct DeviceFacts {
  std::string name{};
  std::string serial{};
  bool is_simulated = false;
  bool has_own_calibration = false;  // one is kept for this very device
  std::string calibration{};         // in use, as a calibration's file
  std::uint64_t exchanges = 0;       // see FalconReport
  std::uint64_t lost_exchanges = 0;
  std::uint64_t discarded_bytes = 0;
  std::uint64_t line_errors = 0;
};

// What happened since an input was chosen, as it is seen once a frame.
class SessionLog {
 public:
  struct Event {
    double time_s = 0.0;  // model time, as in the recording
    std::string_view name;
  };
  struct Hand {
    HandEstimate estimate;
    double time_s = 0.0;
  };

  // `device_fault`: its name in files; empty: none.
  void note(const ServoReport& report, std::string_view device_fault);

  const std::vector<Event>& motors_off() const noexcept { return motors_off_; }        // why, as OffReasonEntry::name
  const std::vector<Event>& device_faults() const noexcept { return device_faults_; }  // when each began
  const std::optional<Hand>& hand() const noexcept { return hand_; }                   // the last that was known
  const MotorHeats& greatest_heat() const noexcept { return greatest_heat_; }

 private:
  std::vector<Event> motors_off_;
  std::vector<Event> device_faults_;
  std::optional<Hand> hand_;
  MotorHeats greatest_heat_{};
  OffReason reason_ = OffReason::none;
  std::string_view fault_;
};

struct Receipt {
  static constexpr int format = 1;

  ReceiptOrigin origin{};
  std::string recording{};  // its file's name, without the folder
  double seconds = 0.0;     // of it, model time
  std::uint64_t dropped = 0;
  std::string input{};
  std::optional<DeviceFacts> device{};  // empty: the input has none
  std::string set_up{};                 // as Ctrl+C copies it
  std::string scene{};                  // as a scene's file, with the settings at the end
  SafetyOptions safety{};
  double rate_hz = 0.0;  // that was asked for
  double believed_k_u = 0.0;
  LoopPeriods periods{};
  std::string real_time{};  // what the operating system has granted
  SessionLog log{};
};

}  // namespace ghostforce
