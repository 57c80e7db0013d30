// A whole measurement of a virtual Falcon in virtual time: a simulated person does what is asked, a test changes the
// answers and what the device is like, and the motors are looked at all the time.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/tools/doctor/measurement.h"
#include "device/virtual_falcon/measured_person.h"

namespace ghostforce {

// Everything goes to a virtual link. Whenever time has passed: with the strongest motors that were published the force
// at the handle would be below 2 N, and none is on for longer than a reply takes after the button was let go of.
class WatchedLink final : public FalconLink {
 public:
  explicit WatchedLink(const VirtualLink::Options& options) : link(options), arm_(options.arm) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return link.open(); }
  void close() noexcept override { link.close(); }
  LinkFault fault() const noexcept override { return link.fault(); }
  std::string_view serial() const noexcept override { return link.serial(); }
  bool request(const VendorRequest& request) noexcept override { return link.request(request); }
  RequestOutcome request_outcome() const noexcept override { return link.request_outcome(); }
  bool write(std::span<const std::uint8_t> bytes) noexcept override { return link.write(bytes); }
  bool is_sending() const noexcept override { return link.is_sending(); }
  void stop(std::span<const std::uint8_t> bytes) noexcept override { link.stop(bytes); }
  bool owes_stop() const noexcept override { return link.owes_stop(); }
  std::size_t read(std::span<std::uint8_t> into) noexcept override { return link.read(into); }
  std::uint8_t modem_status() const noexcept override { return link.modem_status(); }
  LinkCounters counters() const noexcept override { return link.counters(); }
  std::int64_t now_ns() const noexcept override { return link.now_ns(); }
  void send_at_once(std::span<const std::uint8_t> bytes) noexcept override { link.send_at_once(bytes); }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    link.wait_until(deadline_ns);
    poll();
  }

  VirtualLink link;
  double greatest_force = 0.0;           // [N]
  double longest_on_without_button = 0;  // [s]
  double fastest_with_motors = 0.0;      // [m/s]
  double longest_on = 0.0;               // [s]
  double greatest_step = 0.0;            // by which the force grew from one look to the next [N]
  std::function<void()> on_drive;        // when motors go on
  int drives = 0;                        // times the motors went on

 private:
  void poll() {
    const MotorNumbers numbers = link.motors();
    const bool is_on = numbers != MotorNumbers{};
    if (is_on && !was_on_) {
      ++drives;
      if (on_drive) on_drive();
    }
    was_on_ = is_on;
    if (!is_on) off_ns_ = link.now_ns();
    longest_on = std::max(longest_on, static_cast<double>(link.now_ns() - off_ns_) * 1e-9);
    Vector<3> of_legs;
    for (std::size_t leg = 0; leg < 3; ++leg) {
      of_legs[static_cast<glm::length_t>(leg)] =
          sign_of(arm_.motor_of_leg[leg]) * numbers[place_in_frame(arm_.motor_of_leg[leg])];
    }
    const auto jacobian = FalconKinematics(arm_.geometry).jacobian(link.arm().position());
    if (jacobian) {
      const Vector<3> strongest(smallest_published_motor_constant);
      const double force = glm::length(force_of_motor_counts(of_legs, *jacobian, strongest));
      greatest_force = std::max(greatest_force, force);
      greatest_step = std::max(greatest_step, force - force_before_);
      force_before_ = force;
    }
    if (is_on) fastest_with_motors = std::max(fastest_with_motors, glm::length(link.arm().velocity()));
    if (link.hand().buttons() != 0) let_go_ns_ = link.now_ns();
    if (is_on) {
      longest_on_without_button =
          std::max(longest_on_without_button, static_cast<double>(link.now_ns() - let_go_ns_) * 1e-9);
    }
  }

  SimulatedArm::Options arm_;
  std::int64_t let_go_ns_ = 0;
  bool was_on_ = false;
  std::int64_t off_ns_ = 0;
  double force_before_ = 0.0;
};

class RehearsedOperator final : public Operator {
 public:
  explicit RehearsedOperator(VirtualLink& link) : person_(link, {}), link_(link) {}

  void tell(std::string_view words) override {
    heard.emplace_back(words);
    const std::size_t step = words.find("Step ");
    if (step == std::string_view::npos) return;
    const std::size_t title = words.find(": ") + 2;
    title_ = words.substr(title, words.find(". ") - title);
  }
  std::optional<std::string> ask(const OperatorAction& action, std::string_view words) override {
    heard.emplace_back(words);
    if (!only.empty() && !only.contains(title_) && action.kind != OperatorAction::Kind::say_yes_or_no) return "s";
    ++asked[action.kind];
    const std::string answer = person_.act(action);
    if (hook) hook(action, link_);
    auto& mine = answers[action.kind];
    if (mine.empty()) return answer;
    std::optional<std::string> first = mine.front();
    mine.pop_front();
    return first;
  }
  void cue(const OperatorAction& action) override { person_.act(action); }

  bool has_heard(std::string_view words) const {
    for (const std::string& line : heard) {
      if (line.find(words) != std::string::npos) return true;
    }
    return false;
  }

  std::set<std::string> only;  // titles of steps; the others are skipped. Empty: all
  std::map<OperatorAction::Kind, std::deque<std::optional<std::string>>> answers;  // before the simulated person's own
  std::function<void(const OperatorAction&, VirtualLink&)> hook;                   // after an action was begun
  std::map<OperatorAction::Kind, int> asked;
  std::vector<std::string> heard;

 private:
  MeasuredPerson person_;
  VirtualLink& link_;
  std::string title_;
};

struct MeasuredRehearsal {
  explicit MeasuredRehearsal(const SimulatedArm::Options& arm = {}, int watchdog_ms = 0, bool is_homed = true) {
    VirtualLink::Options options{.clock = VirtualLink::Clock::stepped};
    options.arm = arm;
    if (arm.weight == 0.0) options.arm.weight = 0.3;
    options.arm.friction = 0.04;
    options.device.starts_with_firmware = true;
    options.device.starts_homed = is_homed;
    options.device.watchdog_ms = watchdog_ms;
    options.hand.homes_when_asked = true;
    auto made = std::make_unique<WatchedLink>(options);
    link = made.get();
    falcon = std::make_unique<Falcon>(std::move(made), FalconOptions{});
    person = std::make_unique<RehearsedOperator>(link->link);
  }

  FalconMeasurement measure(std::set<std::string> only = {}) {
    person->only = std::move(only);
    await_homed(*falcon, *person);
    FalconMeasurement measurement = measure_falcon(*falcon, *person, FalconCalibration{});
    EXPECT_EQ(link->link.motors(), MotorNumbers{});
    expect_safe();
    return measurement;
  }

  void expect_safe() const {
    EXPECT_LT(link->greatest_force, 2.0);
    EXPECT_LT(link->greatest_step, 0.025);
    EXPECT_LT(link->longest_on, 12.0);
    EXPECT_LT(link->longest_on_without_button, 0.005);
    EXPECT_LT(link->fastest_with_motors, 0.35);
  }

  WatchedLink* link;
  std::unique_ptr<Falcon> falcon;
  std::unique_ptr<RehearsedOperator> person;
};

inline const Finding& finding_of(const FalconMeasurement& measurement, std::string_view title) {
  static const Finding none{};
  for (const FalconMeasurement::Step& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      if (finding.title == title) return finding;
    }
  }
  ADD_FAILURE() << "no finding is called " << title;
  return none;
}

}  // namespace ghostforce
