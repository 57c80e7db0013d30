// A measurement of a simulated Haply 2DIY with a simulated person, stepped by hand, and what must be true of its motors all
// the time.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/tools/doctor/haply_measurement.h"
#include "device/virtual_haply/measured_haply_person.h"
#include "device/virtual_haply/virtual_port.h"

namespace ghostforce {

// Everything goes to a virtual port. Whenever time has passed, the motors' force is looked at as the arms really feel it.
class WatchedHaplyPort final : public SerialPort {
 public:
  explicit WatchedHaplyPort(const VirtualPort::Options& options) : port(options) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return port.open(); }
  void close() noexcept override { port.close(); }
  LinkFault fault() const noexcept override { return port.fault(); }
  std::string_view serial() const noexcept override { return path.empty() ? port.serial() : path; }
  void set_may_push(bool may_push) noexcept override { port.set_may_push(may_push); }
  bool write(std::span<const std::uint8_t> packet) noexcept override { return port.write(packet); }
  std::size_t read(std::span<std::uint8_t> into) noexcept override { return port.read(into); }
  void discard_input() noexcept override { port.discard_input(); }
  std::int64_t now_ns() const noexcept override { return port.now_ns(); }
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override { port.write_at_once(packet); }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    port.wait_until(deadline_ns);
    const HaplyTruth truth = port.truth();
    const bool is_on = truth.duties != std::array<double, 2>{};
    if (is_on && !was_on_) {
      ++drives;
      if (on_drive) on_drive();
    }
    was_on_ = is_on;
    if (!is_on) return;
    greatest_force = std::max(greatest_force, glm::length(truth.force));
    fastest_with_motors = std::max(fastest_with_motors, glm::length(truth.velocity));
  }

  VirtualPort port;
  std::string path;                  // of a board without a serial number, which is known by it
  double greatest_force = 0.0;       // [N]
  double fastest_with_motors = 0.0;  // [m/s]
  int drives = 0;                    // times the motors went on
  std::function<void()> on_drive;    // when they do

 private:
  bool was_on_ = false;
};

class RehearsedHaplyOperator final : public HaplyOperator {
 public:
  RehearsedHaplyOperator(VirtualPort& port, const MeasuredHaplyPerson::Habits& habits)
      : person_(port, habits), port_(port) {}

  void tell(std::string_view words) override {
    heard.emplace_back(words);
    const std::size_t step = words.find("Step ");
    if (step == std::string_view::npos) return;
    const std::size_t title_at = words.find(": ") + 2;
    title = words.substr(title_at, words.find(". ") - title_at);
  }
  std::optional<std::string> ask(const HaplyAction& action, std::string_view words) override {
    heard.emplace_back(words);
    EXPECT_EQ(port_.duties(), (std::array<double, 2>{})) << "at a prompt: " << words;
    if (!only.empty() && !only.contains(title) && action.kind != HaplyAction::Kind::say_yes_or_no) return "s";
    const std::string answer = person_.act(action);
    if (hook) hook(action);
    auto& mine = answers[action.kind];
    if (mine.empty()) return answer;
    std::optional<std::string> first = mine.front();
    mine.pop_front();
    return first;
  }
  void cue(const HaplyAction& action) override {
    person_.act(action);
    if (on_cue) on_cue(action);
  }

  bool has_heard(std::string_view words) const {
    return std::ranges::any_of(heard, [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }

  std::set<std::string> only;  // titles of steps; the others are skipped. Empty: all
  std::map<HaplyAction::Kind, std::deque<std::optional<std::string>>> answers;  // before the simulated person's own
  std::function<void(const HaplyAction&)> hook;                                 // after an action was begun
  std::function<void(const HaplyAction&)> on_cue;
  std::vector<std::string> heard;
  std::string title;  // of the step

 private:
  MeasuredHaplyPerson person_;
  VirtualPort& port_;
};

struct HaplyRehearsal {
  explicit HaplyRehearsal(const HaplyBench::Options& device = {}, const MeasuredHaplyPerson::Habits& habits = {}) {
    auto made = std::make_unique<WatchedHaplyPort>(
        VirtualPort::Options{.clock = VirtualPort::Clock::stepped, .device = device});
    port = made.get();
    person = std::make_unique<RehearsedHaplyOperator>(port->port, habits);
    HaplyOptions options;
    options.is_virtual = true;
    options.debts = debts;
    if (const HaplyVariant* const variant = find_haply_variant(device.variant)) options.usual = variant->calibration;
    before = options.usual;
    haply = std::make_unique<Haply>(std::move(made), options);
  }

  HaplyMeasurement measure(std::set<std::string> only = {}) {
    person->only = std::move(only);
    await_haply(*haply);
    HaplyMeasurement measurement = measure_haply(*haply, *person, before, debts.get());
    EXPECT_EQ(port->port.duties(), (std::array<double, 2>{}));
    expect_safe();
    return measurement;
  }

  void expect_safe() const {
    EXPECT_LT(port->greatest_force, 1.5);
    EXPECT_LT(port->fastest_with_motors, 0.6);
  }

  std::shared_ptr<StopDebts> debts = std::make_shared<StopDebts>();
  WatchedHaplyPort* port = nullptr;
  std::unique_ptr<RehearsedHaplyOperator> person;
  HaplyCalibration before;
  std::unique_ptr<Haply> haply;
};

}  // namespace ghostforce
