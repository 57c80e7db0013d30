#include "app/tools/doctor/rig.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/tools/doctor/readiness.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

// The encoders of a handle that somebody holds still stay within this [counts], for so long, the last part of which is
// what is read; and so long it is waited for [s].
constexpr double still_counts = 12.0;
constexpr double still_s = 0.7;
constexpr double reading_s = 0.3;
constexpr double still_patience_s = 15.0;

constexpr double button_patience_s = 20.0;
// What "there" and "still" mean before motors go on. Nobody sees where the middle is [m], [m/s], [s].
constexpr double near = 0.025;
constexpr double slow = 0.03;
constexpr double ready_s = 0.3;

constexpr double widest = 0.055;    // from the axis [m]
constexpr double nearest = 0.075;   // z [m]
constexpr double farthest = 0.172;  // z [m]
constexpr int unhomed_to_believe = 3;

constexpr std::string_view may_still_push_words =
    "Its motors may still push, and the program cannot stop them: unplug its power supply now. ";

// In the order of MotorStop.
constexpr std::array<std::string_view, 4> stop_words{
    "The button was released, so the motors are off. This step starts again.",
    "The handle moved faster than 0.3 m/s, so the motors are off. Hold it more firmly. This step starts again.",
    "The handle left the middle of its workspace, so the motors are off. This step starts again.",
    "The device did not answer a command for 20 ms, so the motors are off. Close what keeps this machine busy. This "
    "step starts again.",
};

}  // namespace

std::string counts_words(const Vector<3>& counts) {
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", counts.x, counts.y, counts.z);
}

std::string published_within(std::string_view what, std::span<const double> published, std::string_view unit,
                             double found, double uncertainty) {
  std::vector<std::string> all;
  std::vector<std::string> within;
  for (const double value : published) {
    all.push_back(fmt::format("{:.0f}{}", value, unit));
    if (std::abs(found - value) <= uncertainty) within.push_back(all.back());
  }
  return within.empty() ? fmt::format("none of the published {} ({}) is within that range", what, fmt::join(all, ", "))
                        : fmt::format("of the published {}, {} is within that range", what, fmt::join(within, " and "));
}

MeasuringRig::MeasuringRig(Operator& person, FalconLink& link, const FalconCalibration& calibration)
    : person_(person), bench_(link), calibration_(calibration), kinematics_(calibration.geometry) {}

void MeasuringRig::use(const FalconCalibration& calibration) {
  calibration_ = calibration;
  kinematics_ = FalconKinematics(calibration.geometry);
  last_ = {};
  place_count_ = 0;
}

// --- The person ---

std::string MeasuringRig::ask(const OperatorAction& action, const std::string& words) {
  return ask_person(person_, action, words);
}

double MeasuringRig::ask_number(const OperatorAction& action, const std::string& words, double least, double greatest,
                                std::string_view unit) {
  return ask_person_number(person_, action, words, least, greatest, unit);
}

Vector<3> MeasuringRig::read_still_at(const OperatorAction& action, const std::string& words) {
  for (;;) {
    ask(action, words);
    Vector<3> least(0.0);
    Vector<3> greatest(0.0);
    Mean mean;
    double since_s = -1.0;
    const double deadline_s = bench_.now_s() + still_patience_s;
    while (bench_.now_s() < deadline_s) {
      const Vector<3> now = vector_of(poll().encoders);
      least = glm::min(least, now);
      greatest = glm::max(greatest, now);
      const Vector<3> spread = greatest - least;
      if (since_s < 0.0 || std::max({spread.x, spread.y, spread.z}) > still_counts) {
        least = greatest = now;
        mean = {};
        since_s = bench_.now_s();
      }
      const double held_s = bench_.now_s() - since_s;
      if (held_s < still_s - reading_s) continue;
      mean.add(now);
      if (held_s >= still_s) return mean.value();
    }
    person_.tell("The handle did not stay still. Rest your arm on the table and hold the handle there.");
  }
}

// --- The device ---

ReplyFrame MeasuringRig::exchange(const CommandFrame& command) {
  const double began_s = bench_.now_s();
  for (CommandFrame next = command;; next.motors = {}) {
    stop_if_interrupted();
    const auto reply = bench_.exchange(next);
    if (!reply) {
      sent_ = Vector<3>(0.0);
      was_lost_ = true;
      const LinkFault fault = bench_.fault();
      const std::string_view danger = bench_.may_still_push() ? may_still_push_words : "";
      if (fault == LinkFault::unplugged || fault == LinkFault::absent) {
        throw Failure(
            ExitCode::device_absent,
            fmt::format("The Falcon is gone: its USB cable was unplugged. {}Plug it in and start again.", danger));
      }
      if (fault == LinkFault::overruled || fault == LinkFault::unguarded) {
        const FalconFault why = fault == LinkFault::overruled ? FalconFault::overruled : FalconFault::unguarded;
        throw Failure(ExitCode::device_failed, fmt::format("{} Start again.", sentence_of(why)));
      }
      if (fault != LinkFault::none || bench_.now_s() - began_s > 1.0) {
        throw Failure(ExitCode::device_failed,
                      fmt::format("The Falcon stopped answering. {}Check that its power supply is plugged in. If it "
                                  "is, unplug both cables, wait 5 s, plug in power first, and start again.",
                                  danger));
      }
      continue;
    }
    unhomed_ = (reply->status & ReplyFrame::homed) == ReplyFrame::homed ? 0 : unhomed_ + 1;
    if (unhomed_ >= unhomed_to_believe) {
      throw Failure(
          ExitCode::device_failed,
          "The Falcon has forgotten its home position, for example after a power loss. Home it and start again.");
    }
    return *reply;
  }
}

ReplyFrame MeasuringRig::poll(std::uint8_t info) {
  sent_ = Vector<3>(0.0);
  return exchange({.motors = {}, .info = info});
}

void MeasuringRig::rest(double seconds) {
  for (const double end_s = bench_.now_s() + seconds; bench_.now_s() < end_s;) poll();
}

std::optional<MotorStop> MeasuringRig::see(const ReplyFrame& reply, RigSample& sample) {
  if ((reply.status & 0x0F) == 0) return MotorStop::released;
  const Vector<3> start = place_count_ > 0 ? last_.position : cold_start;
  sample.legs = leg_counts(vector_of(reply.encoders), calibration_);
  const ForwardKinematics found = kinematics_.position(angles_of_counts(sample.legs, calibration_.geometry), start);
  const auto jacobian = kinematics_.jacobian(found.position);
  if (!found.has_converged || !jacobian || std::hypot(found.position.x, found.position.y) > widest ||
      found.position.z < nearest || found.position.z > farthest) {
    return MotorStop::left_workspace;
  }
  sample.position = found.position;
  sample.jacobian = *jacobian;
  sample.counts = sent_;
  const std::size_t at = place_count_ % places_.size();
  if (place_count_ >= places_.size()) {
    sample.velocity = (found.position - places_[at]) / (FalconBench::period_s * static_cast<double>(places_.size()));
  }
  places_[at] = found.position;
  ++place_count_;
  last_ = sample;
  return glm::length(sample.velocity) > fastest ? std::optional(MotorStop::too_fast) : std::nullopt;
}

void MeasuringRig::drive(double seconds, const Law& law, const Watch& watch) {
  const double began_s = bench_.now_s();
  const Vector<3> strongest(smallest_published_motor_constant);
  for (;;) {
    MotorNumbers numbers{};
    for (glm::length_t leg = 0; leg < 3; ++leg) {
      numbers[static_cast<std::size_t>(leg)] = static_cast<std::int16_t>(std::lround(sent_[leg]));
    }
    was_lost_ = false;
    const ReplyFrame reply =
        exchange({.motors = in_frame_order(numbers, calibration_.motor_of_leg), .info = CommandFrame::blue});
    RigSample sample;
    if (const auto stop = was_lost_ ? MotorStop::no_reply : see(reply, sample)) {
      turn_off();
      throw *stop;
    }
    sample.time_s = bench_.now_s() - began_s;
    if (watch) watch(sample);
    if (sample.time_s >= seconds) return;
    Vector<3> wanted = law(sample);
    const double force = glm::length(force_of_motor_counts(wanted, sample.jacobian, strongest));
    if (!(force <= greatest_force)) wanted = force > 0.0 ? wanted * (greatest_force / force) : Vector<3>(0.0);
    const Vector<3> change = wanted - sent_;
    const double step = glm::length(force_of_motor_counts(change, sample.jacobian, strongest));
    const double most = steepest * FalconBench::period_s;
    sent_ += step > most ? change * (most / step) : change;
  }
}

void MeasuringRig::let_go(double seconds) {
  const Vector<3> from = sent_;
  drive(seconds, [&](const RigSample& sample) { return from * std::max(0.0, 1.0 - sample.time_s / seconds); });
}

void MeasuringRig::be_silent(double seconds, const Watch& after) {
  // In small pieces, so that an interruption is heard.
  constexpr double piece_s = 0.005;
  for (double left_s = seconds; left_s > 0.0; left_s -= piece_s) {
    const bool is_as_asked = bench_.be_silent(std::min(piece_s, left_s));
    stop_if_interrupted();
    if (!is_as_asked) {
      turn_off();
      throw MotorStop::no_reply;
    }
  }
  sent_ = Vector<3>(0.0);
  place_count_ = 0;  // a speed across the silence would be none
  drive(0.0, no_counts, after);
}

void MeasuringRig::turn_off() {
  sent_ = Vector<3>(0.0);
  place_count_ = 0;
  // A single reply may be one that came twice.
  if (!bench_.stop()) poll();
}

// The button is held, and the handle has been near the place, and slow, for a moment.
bool MeasuringRig::await_ready(const Vector<3>& place) {
  double since_s = bench_.now_s();
  place_count_ = 0;
  for (const double end_s = since_s + button_patience_s; bench_.now_s() < end_s;) {
    RigSample sample;
    const bool is_ready =
        !see(poll(), sample) && glm::distance(sample.position, place) <= near && glm::length(sample.velocity) <= slow;
    if (!is_ready) since_s = bench_.now_s();
    if (bench_.now_s() - since_s >= ready_s) return true;
  }
  return false;
}

bool MeasuringRig::with_button(const OperatorAction& action, const std::string& words,
                               const std::function<void()>& what) {
  MotorStop stop = MotorStop::released;
  for (int i = 0; i < tries; ++i) {
    ask(action, words);
    stop = MotorStop::released;
    if (!await_ready(action.place)) {
      person_.tell(
          "For 20 s, no button of the grip was held down while the handle was still and near its place. Go there "
          "first, then press any button and hold it down.");
      continue;
    }
    bool is_done = true;
    try {
      what();
    } catch (const MotorStop& why) {
      is_done = false;
      stop = why;
    }
    turn_off();
    if (is_done) return true;
    person_.tell(stop_words[static_cast<std::size_t>(stop)]);
  }
  if (stop == MotorStop::too_fast || stop == MotorStop::left_workspace) {
    throw Failure(ExitCode::safety_stop,
                  fmt::format("The handle {} {} times, and the motors were turned off. Nothing was written. Hold the "
                              "handle more firmly, in the middle of its workspace, and start again.",
                              stop == MotorStop::too_fast ? "moved faster than 0.3 m/s" : "left its workspace", tries));
  }
  return false;
}

Vector<3> MeasuringRig::counts_for(const Vector<3>& force, const Matrix<3>& jacobian) noexcept {
  return -smallest_published_motor_constant * joint_torques(force, jacobian).value_or(Vector<3>(0.0));
}

}  // namespace ghostforce
