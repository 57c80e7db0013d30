#include "core/loop_energy.h"

#include <algorithm>
#include <cmath>

#include "core/energy.h"

namespace ghostforce {
namespace {

// Of a turn: after so much of it the device has forgotten how it came to the circle.
constexpr double settling_share = 0.25;

}  // namespace

double predicted_energy(const Strategy& entry, const Settings& settings, double area) noexcept {
  if (entry.has_every_motor) return 0.0;
  const Stiffnesses& k = settings.stiffnesses;
  return energy_per_loop(k.k_r, k.k_t, k.k_c, entry.tracking_ratio(k),
                         settings.actuated_angle - settings.wall_normal_angle, area);
}

void CircleEnergyMeter::start(const Settings& settings, const Circle& circle) noexcept {
  *this = {};
  settings_ = settings;
  reading_.circle = circle;
}

void CircleEnergyMeter::add(const Snapshot& snapshot) noexcept {
  const double period_s = period_of(reading_.circle);
  if (begins_s_ < 0.0 || snapshot.tick != last_tick_ + 1) {
    // The first one, or some are missing: what has been measured of this turn is worth nothing.
    begins_s_ = std::max(snapshot.time_s, circle_begins_s) + settling_share * period_s;
    meters_ = {};
    reading_.share = 0.0;
  }
  last_tick_ = snapshot.tick;
  if (!meters_.front()) {
    // Half a tick early rather than a whole one late.
    if (snapshot.time_s >= begins_s_ - 0.5 / settings_.rate) begin_turn(snapshot);
    return;
  }
  for (std::size_t i = 0; i < strategy_count; ++i) {
    meters_[i]->add(snapshot.strategies[i].device, snapshot.strategies[i].energy);
    in_contact_[i] = in_contact_[i] && snapshot.strategies[i].in_contact;
  }
  reading_.share = (snapshot.time_s - began_s_) / period_s;
  if (snapshot.time_s < began_s_ + period_s - 0.5 / settings_.rate) return;
  end_turn();
  begin_turn(snapshot);
}

void CircleEnergyMeter::begin_turn(const Snapshot& snapshot) noexcept {
  began_s_ = snapshot.time_s;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    meters_[i].emplace(snapshot.strategies[i].device, snapshot.strategies[i].energy);
    in_contact_[i] = snapshot.strategies[i].in_contact;
  }
}

void CircleEnergyMeter::end_turn() noexcept {
  ++reading_.turns;
  for (const Strategy& entry : strategy_catalog()) {
    const std::size_t i = index_of(entry.id);
    CircleEnergy& energy = reading_.strategies[i];
    energy.last = meters_[i]->loop();
    energy.mean.area += (energy.last.area - energy.mean.area) / reading_.turns;
    energy.mean.energy += (energy.last.energy - energy.mean.energy) / reading_.turns;
    energy.predicted = predicted_energy(entry, settings_, energy.mean.area);
    energy.stays_inside = energy.stays_inside && in_contact_[i];
  }
}

}  // namespace ghostforce
