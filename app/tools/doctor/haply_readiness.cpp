#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "app/tools/doctor/readiness.h"
#include "core/safety.h"
#include "device/haply/haply_calibration.h"
#include "device/haply/haply_report.h"

namespace ghostforce {
namespace {

// In the order of ReadinessStep.
constexpr std::array haply_steps{
    ReadinessEntry{ReadinessStep::seen, ExitCode::device_absent, "seen", "Found", "Not found",
                   "Plug in the board's USB cable. Where there are several boards, name a port with --haply-port; "
                   "'ghostforce doctor haply' lists them.",
                   "The computer sees the port."},
    ReadinessEntry{ReadinessStep::allowed, ExitCode::device_refused, "allowed", "Allowed", "Not allowed",
                   "Run 'ghostforce doctor --install-udev' once, then plug it in again.", "This user may open it."},
    ReadinessEntry{ReadinessStep::free, ExitCode::device_refused, "free", "Free", "Not free",
                   "Close the other program that is using the port.", "No other program is using it."},
    ReadinessEntry{ReadinessStep::firmware, ExitCode::device_failed, "firmware", "hAPI answers", "hAPI does not answer",
                   "The program is asking the board whether it speaks hAPI.", "The board speaks hAPI."},
    ReadinessEntry{ReadinessStep::homed, ExitCode::device_failed, "homed", "Zero pose confirmed",
                   "Zero pose not confirmed", "Hold still there, and press “Zero pose is held”.",
                   "The angles count from the zero pose."},
    ReadinessEntry{ReadinessStep::encoders_move, ExitCode::device_failed, "encoders_move", "Encoders move",
                   "Encoders not moved yet",
                   "Move the handle up and down, left and right. If that changes nothing, check the encoders' plugs.",
                   "Both arms have moved."},
    ReadinessEntry{ReadinessStep::fast_enough, ExitCode::answer_is_no, "fast_enough", "Fast enough", "Not fast enough",
                   "Use a USB port on the computer itself, without a hub, and close programs that keep it busy.", ""},
    ReadinessEntry{ReadinessStep::outside_wall, ExitCode::done, "outside_wall", "Outside the wall", "In the wall",
                   "Move the handle out of the wall.", "Nothing pushes on the handle yet."},
    ReadinessEntry{ReadinessStep::armed, ExitCode::done, "armed", "Armed", "Not armed",
                   "Hold the handle loosely, keep the power supply's plug in reach, and press the button “Arm the "
                   "motors”.",
                   ""},
};

struct HaplyFaultWords {
  HaplyFault id;
  ReadinessStep step;         // at which it keeps the device
  std::string_view sentence;  // what is wrong
  std::string_view remedy;
};
// In the order of HaplyFault.
constexpr std::array haply_faults{
    HaplyFaultWords{HaplyFault::none, ReadinessStep::seen, "", ""},
    HaplyFaultWords{HaplyFault::not_allowed, ReadinessStep::allowed, "This user may not open the serial port.",
                    "Run 'ghostforce doctor --install-udev' once, then plug the board in again."},
    HaplyFaultWords{HaplyFault::busy, ReadinessStep::free, "Another program is using the serial port.",
                    "Close that program. ModemManager lets go of it after half a minute."},
    HaplyFaultWords{HaplyFault::unsupported, ReadinessStep::seen, "What is named as the port is no serial port.",
                    "Name the board's port with --haply-port, as /dev/ttyACM0."},
    HaplyFaultWords{HaplyFault::unplugged, ReadinessStep::seen, "The board was unplugged.",
                    "Plug it in again: the program keeps looking for it. The motors stay off until you arm them."},
    HaplyFaultWords{HaplyFault::broken, ReadinessStep::firmware, "The port does not take what is sent.",
                    "Use another cable or another USB port, one on the computer itself."},
    HaplyFaultWords{HaplyFault::no_board, ReadinessStep::firmware, "What is at this port does not speak hAPI.",
                    "Check that this is the Haply's port, and that its board has a hAPI firmware (docs/haply.md)."},
    HaplyFaultWords{HaplyFault::no_replies, ReadinessStep::firmware, "The board has stopped answering.",
                    "Unplug its power supply first, then its USB cable, and plug both in again."},
    HaplyFaultWords{HaplyFault::restarted, ReadinessStep::homed, "The board has forgotten how it was set up.",
                    "Check its power supply and cable. Then hold its zero pose again, and confirm it."},
    HaplyFaultWords{HaplyFault::lost_count, ReadinessStep::homed, "An encoder has lost its count.",
                    "Check the encoders' plugs and the power supply. Then hold the zero pose again, and confirm it."},
    HaplyFaultWords{HaplyFault::kinematics, ReadinessStep::homed,
                    "The encoders report angles that the arms cannot have.",
                    "Hold the zero pose again, and confirm it. If that does not help, check the variant "
                    "(--haply-variant) and the calibration file."},
    HaplyFaultWords{HaplyFault::overruled, ReadinessStep::free,
                    "The program did not run for 20 ms, so its guard turned the motors off.",
                    "Close other busy programs. The program opens the port again by itself."},
    HaplyFaultWords{HaplyFault::unguarded, ReadinessStep::free, "The guard of the motors has ended.",
                    "The program opens the port again by itself, with a new guard."},
    HaplyFaultWords{HaplyFault::stop_owed, ReadinessStep::firmware,
                    "Another board, which may still push, is plugged in again.",
                    "Wait: the program stops its motors first, and then goes on with the board that you chose."},
};
static_assert(haply_faults.size() == static_cast<std::size_t>(HaplyFault::stop_owed) + 1);

const HaplyFaultWords& readiness_fault(HaplyFault fault) noexcept {
  return haply_faults[static_cast<std::size_t>(fault)];
}

ReadinessStep way_of(const HaplyReport& report) noexcept {
  switch (report.state) {
    case HaplyState::absent:
      return ReadinessStep::seen;
    case HaplyState::fault:
      return readiness_fault(report.fault).step;
    case HaplyState::opening:
      return ReadinessStep::firmware;
    case HaplyState::zero_pose:
      return ReadinessStep::homed;
    case HaplyState::idle:
    case HaplyState::active:
      return ReadinessStep::encoders_move;
  }
  return ReadinessStep::seen;
}

// Why the zero pose has to be held, and what it is.
std::string zero_pose_words(const HaplyReport& report) {
  const HaplyVariant* const variant = find_haply_variant(report.variant);
  const std::string_view pose = variant != nullptr ? variant->zero_pose : usual_haply_variant().zero_pose;
  const std::string_view title = variant != nullptr ? variant->title : usual_haply_variant().title;
  std::string before;
  if (report.fault == HaplyFault::restarted || report.fault == HaplyFault::lost_count)
    before = fmt::format("{} ", readiness_fault(report.fault).sentence);
  if (report.zero_pose == ZeroPose::moving) before += "The arms were moving. ";
  if (report.zero_pose == ZeroPose::refused)
    before += "The board reports other angles than it was given: check the encoders' plugs. ";
  return fmt::format("{}The board cannot know where its arms are. {} ({})", before, pose, title);
}

std::string moved_words(const HaplyReport& report) {
  if (!report.has_moved[0] && !report.has_moved[1]) return "No arm has moved yet.";
  return fmt::format("Arm {} has not moved yet.", report.has_moved[0] ? 2 : 1);
}

// What the check of the motors has found, and what to do about it.
std::string finding_words_of(const MotorFinding& finding, std::string_view variant) {
  const std::size_t number = finding.motor + 1;
  const std::string found = fmt::format(fmt::runtime(sentence_of(finding.verdict)), number);
  switch (finding.verdict) {
    case MotorVerdict::none:
    case MotorVerdict::right:
      return {};
    case MotorVerdict::wrong_way:
      return fmt::format(
          "{} Close this program, run 'ghostforce doctor haply --haply-variant {} --flip-motor {}', which writes the "
          "other sign into the board's calibration file, and start this program again.",
          found, variant, number);
    case MotorVerdict::crossed:
      return fmt::format(
          "{} Close this program and run 'ghostforce doctor haply --measure', which finds out which motor is whose.",
          found);
    case MotorVerdict::silent:
      return fmt::format(
          "{} Check the power supply, this motor's plug and the plug of its arm's encoder, and hold the handle "
          "loosely.",
          found);
    case MotorVerdict::undecided:
      return fmt::format(
          "{} Hold the handle loosely and still in the middle of its workspace, then arm the motors again. If that "
          "does not help, run 'ghostforce doctor haply --measure'.",
          found);
  }
  return {};
}

}  // namespace

std::string_view sentence_of(HaplyFault fault) noexcept {
  return readiness_fault(fault).sentence;
}

std::string_view remedy_of(HaplyFault fault) noexcept {
  return readiness_fault(fault).remedy;
}

std::vector<ReadinessStepState> readiness_of(const HaplyReport& report, const MotorReport* motors) {
  const bool answers = report.state == HaplyState::zero_pose || report.is_readable();
  DeviceSteps device{
      .catalog = haply_steps,
      .way = way_of(report),
      .is_readable = report.is_readable(),
      .encoders_move = report.is_readable() && report.encoders_move(),
      .is_guarded = report.is_guarded,
      .is_fast_and_even = answers && report.is_fast_enough() && report.worst_exchange_s < Safety::longest_exchange_s,
      .may_still_push = report.may_still_push,
      .exchange_hz = report.exchange_hz,
      .exchange_s = report.exchange_s,
      .worst_exchange_s = report.worst_exchange_s,
      .still_pushing =
          "The motors may still push: pull the plug of the power supply now, then the USB cable. The "
          "program stops them as soon as the board answers again.",
      .homed_words = zero_pose_words(report),
      .moved_words = moved_words(report)};
  if (!report.serial.text().empty()) device.seen_words = fmt::format("It is {}.", report.serial.text());
  if (motors != nullptr) device.finding_words = finding_words_of(motors->finding, report.variant);
  if (report.state == HaplyState::fault && report.fault != HaplyFault::none) {
    device.fault_sentence = readiness_fault(report.fault).sentence;
    device.fault_remedy = readiness_fault(report.fault).remedy;
  }
  return readiness_of(device, motors);
}

}  // namespace ghostforce
