#include "device/virtual_haply/haply_board.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace ghostforce {
namespace {

constexpr std::uint8_t not_come = 255;  // what a read without waiting makes of nothing
constexpr int first_analogue_pin = 54;
constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();

template <typename Places>
std::size_t count_of(const Places& places, std::size_t size, std::uint8_t address) noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i) count += places[i].address == address ? 1U : 0U;
  return count;
}

void write_number(HaplyBoard::Reply& reply, float number) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (unsigned shift = 0; shift < 32; shift += 8) reply.bytes[reply.size++] = static_cast<std::uint8_t>(bits >> shift);
}

}  // namespace

void HaplyBoard::receive(std::span<const std::uint8_t> bytes, std::int64_t at_ns) noexcept {
  if (!received_.empty()) at_ns = std::max(at_ns, received_.back().at_ns);
  for (const std::uint8_t byte : bytes) received_.push({at_ns, byte});
}

void HaplyBoard::run_until(std::int64_t now_ns) noexcept {
  for (;;) {
    const std::int64_t next_ns = next_event_ns();
    if (options_.watchdog_ns > 0 && std::min(next_ns, now_ns) - exchanged_ns_ >= options_.watchdog_ns) {
      for (Motor& motor : motors_) motor.duty = 0.0;
    }
    if (next_ns > now_ns) return;
    if (reading_ == Reading::nothing) {
      run_pass(next_ns);
    } else {
      end_reading(next_ns);
    }
  }
}

// Passes keep to a grid, as the loop runs all the time.
std::int64_t HaplyBoard::next_event_ns() const noexcept {
  if (reading_ != Reading::nothing) {
    const auto ends_ns = reading_ends_ns();
    return ends_ns ? *ends_ns : reading_since_ns_ + patience_ns;
  }
  if (received_.empty()) return never_ns;
  const std::int64_t earliest_ns = std::max(received_.front().at_ns, last_pass_ns_ + 1);
  return (earliest_ns + pass_ns - 1) / pass_ns * pass_ns;
}

std::optional<HaplyBoard::Reply> HaplyBoard::take_reply() noexcept {
  if (replies_.empty()) return std::nullopt;
  return replies_.pop();
}

void HaplyBoard::count(std::size_t port, std::int64_t edges) noexcept {
  encoders_[port].edges += edges;
}

void HaplyBoard::restart() noexcept {
  received_.clear();
  replies_.clear();
  reading_ = Reading::nothing;
  memory_ = {};
  motors_ = {};
  encoders_ = {};
  analogue_addresses_ = {};
  pwm_addresses_ = {};
}

void HaplyBoard::lose_cable() noexcept {
  received_.clear();
  replies_.clear();
}

void HaplyBoard::take_over(std::uint8_t address, double duty) noexcept {
  for (std::size_t port = 0; port < 2; ++port) {
    motors_[port] = {.address = address, .direction = motors_[port].direction, .has_pins = true, .duty = duty};
    encoders_[port].address = address;
    if (encoders_[port].counts_per_turn == 0.0) encoders_[port].counts_per_turn = 1.0;
  }
}

void HaplyBoard::refuse_set_ups(bool refuses) noexcept {
  refuses_set_ups_ = refuses;
  if (refuses) reset();
}

// --- The loop --------------------------------------------------------------------------------------------------------

void HaplyBoard::run_pass(std::int64_t at_ns) noexcept {
  last_pass_ns_ = at_ns;
  const std::uint8_t command = next_byte(at_ns);
  if (command > 2) {
    ++dropped_bytes_;
    return;
  }
  address_ = next_byte(at_ns);
  if (command == 0) {
    ++resets_;
    reset();
  } else if (command == 1) {
    new_set_up_ = {};
    await(Reading::motor_mask, 1, at_ns);
  } else {
    const auto outputs = static_cast<std::size_t>(std::ranges::count(pwm_addresses_, address_));
    await(Reading::torques, outputs + 4 * count_of(motors_, ports(), address_), at_ns);
  }
}

std::uint8_t HaplyBoard::next_byte(std::int64_t at_ns) noexcept {
  if (received_.empty() || received_.front().at_ns > at_ns) return not_come;
  return received_.pop().byte;
}

void HaplyBoard::await(Reading what, std::size_t size, std::int64_t at_ns) noexcept {
  reading_ = what;
  wanted_ = std::min(size, memory_.size());
  reading_since_ns_ = at_ns;
}

// Empty: not as long as no more comes.
std::optional<std::int64_t> HaplyBoard::reading_ends_ns() const noexcept {
  if (wanted_ == 0) return reading_since_ns_;
  if (received_.size() < wanted_) return std::nullopt;
  return std::clamp(received_[wanted_ - 1].at_ns, reading_since_ns_, reading_since_ns_ + patience_ns);
}

void HaplyBoard::end_reading(std::int64_t at_ns) noexcept {
  for (std::size_t i = 0; i < wanted_; ++i) {
    if (received_.empty() || received_.front().at_ns > at_ns) break;
    memory_[i] = received_.pop().byte;
  }
  last_pass_ns_ = std::max(last_pass_ns_, at_ns - 1);  // a pass that has waited is followed by one at once
  go_on(at_ns);
}

void HaplyBoard::go_on(std::int64_t at_ns) noexcept {
  switch (reading_) {
    case Reading::motor_mask:
      new_set_up_.motors = memory_[0] & port_mask();
      await(Reading::motor_directions, static_cast<std::size_t>(std::popcount(new_set_up_.motors)), at_ns);
      break;
    case Reading::motor_directions:
      for (std::size_t i = 0; i < wanted_; ++i) new_set_up_.motor_directions[i] = memory_[i] != 0;
      await(Reading::encoder_mask, 1, at_ns);
      break;
    case Reading::encoder_mask:
      new_set_up_.encoders = memory_[0] & port_mask();
      await(Reading::encoder_directions, static_cast<std::size_t>(std::popcount(new_set_up_.encoders)), at_ns);
      break;
    case Reading::encoder_directions:
      for (std::size_t i = 0; i < wanted_; ++i) new_set_up_.encoder_directions[i] = memory_[i] != 0;
      await(Reading::analogue_count, 1, at_ns);
      break;
    case Reading::analogue_count:
      await(Reading::analogue_pins, memory_[0], at_ns);
      break;
    case Reading::analogue_pins:
      take_pins(std::span{analogue_addresses_}.first(analogue_inputs()), first_analogue_pin);
      await(Reading::pwm_count, 1, at_ns);
      break;
    case Reading::pwm_count:
      await(Reading::pwm_numbers, memory_[0], at_ns);
      break;
    case Reading::pwm_numbers:
      take_pins(pwm_addresses_, 0);
      await(Reading::encoder_numbers, 8 * static_cast<std::size_t>(std::popcount(new_set_up_.encoders)), at_ns);
      break;
    case Reading::encoder_numbers:
      reading_ = Reading::nothing;
      set_up();
      break;
    case Reading::torques:
      reading_ = Reading::nothing;
      exchange(at_ns);
      break;
    case Reading::nothing:
      break;
  }
}

void HaplyBoard::take_pins(std::span<std::uint8_t> addresses, int first_pin) noexcept {
  if (refuses_set_ups_) return;
  for (std::size_t i = 0; i < wanted_; ++i) {
    const int place = memory_[i] - first_pin;
    if (place >= 0 && place < static_cast<int>(addresses.size())) addresses[static_cast<std::size_t>(place)] = address_;
  }
}

// --- What the commands do --------------------------------------------------------------------------------------------

// Every pin stays as it is.
void HaplyBoard::reset() noexcept {
  for (Motor& motor : motors_) motor.address = 0;
  for (Encoder& encoder : encoders_) encoder.address = 0;
  analogue_addresses_ = {};
  pwm_addresses_ = {};
}

void HaplyBoard::set_up() noexcept {
  ++set_ups_;
  if (refuses_set_ups_) return;
  // The first direction goes to the first place, whichever port is the first that was named.
  for (int i = 0; i < std::popcount(new_set_up_.motors); ++i) {
    const auto place = static_cast<std::size_t>(i);
    motors_[place].direction = new_set_up_.motor_directions[place];
  }
  for (int i = 0; i < std::popcount(new_set_up_.encoders); ++i) {
    const auto place = static_cast<std::size_t>(i);
    encoders_[place].direction = new_set_up_.encoder_directions[place];
  }
  for (std::size_t port = 0; port < ports(); ++port) {
    if ((new_set_up_.motors >> port & 1U) == 0) continue;
    Motor& motor = motors_[port];
    motor.address = address_;
    motor.has_pins = true;
    motor.duty = 0.0;  // its timer is started anew
    if (options_.kind == Kind::dev_kit && port % 2 == 1) motor.direction = !motor.direction;
  }
  std::size_t place = 0;
  for (std::size_t port = 0; port < ports(); ++port) {
    if ((new_set_up_.encoders >> port & 1U) == 0) continue;
    Encoder& encoder = encoders_[port];
    encoder.address = address_;
    encoder.runs_backwards = encoder.direction;
    encoder.edges = 0;
    const double sent = static_cast<double>(number_at(place + 4));
    encoder.counts_per_turn = options_.kind == Kind::m0 ? 0.5 * sent : sent;
    encoder.start = static_cast<double>(number_at(place)) * encoder.counts_per_turn / 360.0;
    if (options_.cuts_offsets) encoder.start = std::trunc(encoder.start);
    place += 8;
  }
}

void HaplyBoard::exchange(std::int64_t at_ns) noexcept {
  ++exchanges_;
  exchanged_ns_ = at_ns;
  std::size_t place = static_cast<std::size_t>(std::ranges::count(pwm_addresses_, address_));
  for (std::size_t port = 0; port < ports(); ++port) {
    if (motors_[port].address != address_) continue;
    drive(motors_[port], torque_at(place));
    place += 4;
  }
  Reply reply;
  reply.left_ns = at_ns;
  reply.bytes[reply.size++] = address_;
  for (std::size_t i = 0; i < analogue_inputs(); ++i) {
    if (analogue_addresses_[i] == address_) write_number(reply, 0.0F);  // nothing is connected
  }
  reply.encoders_from = reply.size;
  for (std::size_t port = 0; port < ports(); ++port) {
    if (encoders_[port].address != address_) continue;
    reply.encoders |= static_cast<std::uint8_t>(1U << port);
    write_number(reply, degrees_of(encoders_[port]));
  }
  replies_.push(reply);
}

void HaplyBoard::drive(Motor& motor, float torque) noexcept {
  if (!motor.has_pins) return;
  const double steps = options_.kind == Kind::m0 ? 1023.0 : 4095.0;
  const double share =
      std::isnan(torque) ? 1.0 : static_cast<double>(std::min(std::abs(torque), full_torque) / full_torque);
  const bool is_positive = torque > 0.0F;
  const bool is_high = (is_positive == motor.direction) != (options_.kind == Kind::dev_kit);
  motor.duty = std::trunc(share * steps) / steps * (is_high ? -1.0 : 1.0);
}

float HaplyBoard::torque_at(std::size_t place) noexcept {
  const float torque = number_at(place);
  if (!spoils_torque_ || !(torque > 0.0F)) return torque;
  spoils_torque_ = false;
  return -torque;
}

// The lowest byte comes first.
float HaplyBoard::number_at(std::size_t place) const noexcept {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= std::uint32_t{memory_[place + i]} << (8 * i);
  return std::bit_cast<float>(bits);
}

float HaplyBoard::degrees_of(const Encoder& encoder) const noexcept {
  if (encoder.counts_per_turn == 0.0) return std::numeric_limits<float>::quiet_NaN();
  const std::int64_t edges = encoder.runs_backwards ? -encoder.edges : encoder.edges;
  const std::int64_t counts = options_.kind == Kind::m0 ? edges >> 1U : edges;
  return static_cast<float>((encoder.start + static_cast<double>(counts)) * 360.0 / encoder.counts_per_turn);
}

}  // namespace ghostforce
