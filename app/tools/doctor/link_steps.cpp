// What the firmware does when it hears nothing, how fast it answers, its homing bit, its lights and the grip's buttons.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/tools/doctor/motors.h"
#include "app/tools/doctor/steps.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

constexpr double ms = 1e-3;

// --- Silence ---

constexpr std::array silences_s{0.02, 0.05, 0.1, 0.2, 0.5, 1.0};
constexpr std::size_t rounds = 2;
constexpr double push_force = 0.9;  // towards the person, of the strongest published motors [N]

SilenceReading take_silence(MeasuringRig& rig, double silence_s) {
  const auto outwards = [](const RigSample& sample) {
    return MeasuringRig::counts_for({0.0, 0.0, push_force}, sample.jacobian);
  };
  Mean without;
  rig.drive(0.3, MeasuringRig::no_counts, [&](const RigSample& sample) { without.add(sample.position); });
  const double rest = without.value().z;
  Mean held;
  double least = 1.0;
  double greatest = 0.0;
  rig.drive(0.7, outwards, [&](const RigSample& sample) {
    if (sample.time_s < 0.5) return;
    held.add(sample.position);
    least = std::min(least, sample.position.z);
    greatest = std::max(greatest, sample.position.z);
  });
  SilenceReading reading{.silence_s = silence_s, .held = held.value().z - rest, .tremor = greatest - least};
  rig.be_silent(silence_s, [&](const RigSample& sample) { reading.after = sample.position.z - rest; });
  return reading;
}

}  // namespace

std::vector<Finding> measure_silence(MeasuringRig& rig) {
  Finding finding{.title = "Does the firmware drop a force by itself", .settles = "the firmware's watchdog"};
  std::vector<SilenceReading> readings;
  // What has been read stays where the button is let go of in between.
  const auto take_all = [&] {
    while (readings.size() < rounds * silences_s.size()) {
      const bool ends_round = readings.size() % rounds == 0;
      if (ends_round && judge_silences(readings).outcome == SilenceOutcome::drops) break;
      readings.push_back(take_silence(rig, silences_s[readings.size() / rounds]));
    }
  };
  const bool is_done = rig.with_button(
      {.kind = OperatorAction::Kind::hold_button},
      "Hold the handle loosely in the middle of its workspace and hold down a button of the grip. After Enter you will "
      "feel up to twelve pushes towards you, each below 1 N, for half a minute in all. During each push the program "
      "sends nothing to the device for 20 ms to one second, and cannot see your button until that is over. Let the "
      "device push you, and do not change your grip.",
      take_all);
  for (const SilenceReading& reading : readings) {
    finding.readings.push_back(
        fmt::format("silent for {:.0f} ms: pushed {:.2f} mm before, {:.2f} mm after; the hand drifted by {:.2f} mm",
                    reading.silence_s / ms, reading.held / ms, reading.after / ms, reading.tremor / ms));
  }
  if (!is_done) {
    finding.sentence = "The step was interrupted each time.";
    return {finding};
  }
  const SilenceVerdict verdict = judge_silences(readings);
  switch (verdict.outcome) {
    case SilenceOutcome::undecidable:
      finding.sentence =
          "The hand moved too much on top of the push, or the readings disagree, so nothing can be concluded.";
      break;
    case SilenceOutcome::stays:
      finding.state = Finding::State::measured;
      finding.sentence =
          fmt::format("No: the force was still there after {:.0f} ms without a command.", verdict.still_there_s / ms);
      break;
    case SilenceOutcome::drops:
      finding.state = Finding::State::measured;
      finding.sentence = verdict.still_there_s > 0.0
                             ? fmt::format(
                                   "Yes: it was still there after {:.0f} ms without a command, and gone after "
                                   "{:.0f} ms.",
                                   verdict.still_there_s / ms, verdict.gone_s / ms)
                             : fmt::format("Yes: it was gone after {:.0f} ms without a command.", verdict.gone_s / ms);
      break;
  }
  return {finding};
}

// --- Exchanges ---

std::vector<Finding> measure_exchanges(MeasuringRig& rig) {
  constexpr int count = 2000;
  rig.ask({.kind = OperatorAction::Kind::take_again},
          "Hold the handle still for three seconds. Enter: the exchanges are counted. The motors stay off.");
  rig.rest(0.5);
  std::vector<double> times;
  const double began_s = rig.bench().now_s();
  for (int i = 0; i < count; ++i) {
    rig.poll();
    times.push_back(rig.bench().last_exchange_s());
  }
  const double rate = count / (rig.bench().now_s() - began_s);
  std::ranges::sort(times);
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / count;
  Finding exchanges{.state = Finding::as_assumed_if(rate >= FalconReport::fast_enough_hz),
                    .title = "Exchanges a second",
                    .settles = {}};
  exchanges.sentence = fmt::format(
      "{:.0f} a second; an answer takes {:.2f} ms on average, up to {:.2f} ms in 99 of 100 cases, and {:.2f} ms at "
      "most.",
      rate, mean / ms, times[count * 99 / 100] / ms, times.back() / ms);
  exchanges.readings.push_back(fmt::format("{} exchanges", count));

  // The bit that asks for homing, on a device that is homed: its numbers must not leap.
  Finding homing{.title = "The homing bit after homing", .settles = "whether the homing bit must stay set"};
  double leap = 0.0;
  for (const std::uint8_t info :
       {CommandFrame::green, static_cast<std::uint8_t>(CommandFrame::green | CommandFrame::homing),
        CommandFrame::green}) {
    for (int i = 0; i < 300; ++i) {
      const ReplyFrame before = rig.poll(i == 0 ? CommandFrame::green : info);
      const ReplyFrame after = rig.poll(info);
      for (std::size_t k = 0; k < 3; ++k) leap = std::max(leap, std::abs(1.0 * after.encoders[k] - before.encoders[k]));
    }
  }
  constexpr double most_leap = 20.0;  // from one exchange to the next, of a handle that is held [counts]
  homing.readings.push_back(
      fmt::format("600 exchanges without the bit, 300 with it: from one to the next, the encoders changed by at most "
                  "{:.0f} counts, and the device stayed homed",
                  leap));
  homing.state = Finding::as_assumed_if(leap <= most_leap);
  homing.sentence = leap <= most_leap ? "It may be set or not: the device stays homed and its numbers continue."
                                      : "The encoders' numbers jump when it changes.";
  return {exchanges, homing};
}

// --- Lights and buttons ---

namespace {

// Of a frame.
struct Bit {
  std::uint8_t bit;
  std::string_view name;
};
constexpr std::array lights{Bit{CommandFrame::red, "red"}, Bit{CommandFrame::green, "green"},
                            Bit{CommandFrame::blue, "blue"}};
constexpr std::array buttons{
    Bit{ReplyFrame::button_centre, "in the centre"}, Bit{ReplyFrame::button_right, "on the right"},
    Bit{ReplyFrame::button_forward, "at the front"}, Bit{ReplyFrame::button_left, "on the left"}};

}  // namespace

std::vector<Finding> check_lights(MeasuringRig& rig) {
  Finding finding{.title = "Lights", .settles = "which bit is which light"};
  finding.state = Finding::State::as_assumed;
  for (const Bit& light : lights) {
    for (int i = 0; i < 50; ++i) rig.poll(light.bit);
    const std::string answer =
        rig.ask({.kind = OperatorAction::Kind::say_light},
                "Look at the ring of light on the device. What colour is it? Type red, green, blue or other.");
    finding.readings.push_back(fmt::format("bit {:#04x}, assumed to be {}: seen as {}", light.bit, light.name,
                                           answer.empty() ? "nothing" : quoted_text(answer)));
    if (answer != light.name) finding.state = Finding::State::differs;
  }
  finding.sentence = finding.state == Finding::State::as_assumed
                         ? "Red, green and blue are where they were assumed to be."
                         : "At least one light is not the one that was assumed.";
  return {finding};
}

std::vector<Finding> check_buttons(MeasuringRig& rig) {
  constexpr double patience_s = 10.0;
  Finding finding{.title = "Buttons", .settles = "which bit is which button"};
  finding.state = Finding::State::as_assumed;
  for (const Bit& button : buttons) {
    rig.ask(
        {.kind = OperatorAction::Kind::press, .buttons = button.bit},
        fmt::format("Within ten seconds after Enter, press the button {} of the grip and release it.", button.name));
    unsigned seen = 0;
    for (const double end_s = rig.bench().now_s() + patience_s; rig.bench().now_s() < end_s;) {
      const unsigned now = rig.poll().status & 0x0FU;
      if (seen != 0 && now == 0) break;
      seen |= now;
    }
    finding.readings.push_back(
        fmt::format("the button {}, assumed to be bit {:#04x}: seen as {:#04x}", button.name, button.bit, seen));
    if (seen == 0) finding.state = Finding::State::not_measured;
    if (seen != button.bit && finding.state == Finding::State::as_assumed) finding.state = Finding::State::differs;
  }
  finding.sentence = finding.state == Finding::State::as_assumed ? "All four are where they were assumed to be."
                     : finding.state == Finding::State::not_measured
                         ? "At least one button was never seen."
                         : "At least one button is not the one that was assumed.";
  return {finding};
}

}  // namespace ghostforce
