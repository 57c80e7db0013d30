#include "device/virtual_haply/haply_bench.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace ghostforce {
namespace {

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t longest_gap_ns = 1'000'000'000;

constexpr std::int64_t tear_ns = 1'000'000;  // a frame of USB
constexpr unsigned garbage_interval = 10;
constexpr std::int64_t line_interval_ns = 10'000'000;
constexpr std::uint8_t address_of_another = 9;
constexpr double duty_of_another = 0.2;

constexpr std::array<std::uint8_t, 8> modem_command{'A', 'T', '+', 'G', 'C', 'A', 'P', '\r'};
constexpr std::array<std::uint8_t, 18> line_of_text{'t', '=', '1', '8', '3', '4', ' ', 'a',  'x',
                                                    '=', '-', '0', '.', '0', '2', '1', '\r', '\n'};

// Of arms that have passed through each other, by arm. The distal links would still meet.
constexpr std::array<float, 2> crossed_degrees{20.0F, 160.0F};

const VirtualHaplyVariant& variant_of(std::string_view name) noexcept {
  const VirtualHaplyVariant* variant = find_virtual_haply_variant(name);
  return variant != nullptr ? *variant : *find_virtual_haply_variant("v3.1");
}

Vector<2> start_of(const VirtualHaplyVariant& variant, bool in_zero_pose) noexcept {
  const auto middle = variant.geometry.angles_at(variant.geometry.middle());
  return in_zero_pose || !middle ? variant.zero_pose() : *middle;
}

// A full-speed port is served once in a frame of 1 ms, a high-speed one in each eighth of that.
constexpr std::int64_t frame_of(HaplyBoard::Kind kind) noexcept {
  return kind == HaplyBoard::Kind::m0 ? 1'000'000 : 125'000;
}

// The sign of what was chosen so that this direction is right.
double sign_of(std::uint8_t direction) noexcept {
  return direction == 0 ? 1.0 : -1.0;
}

void put_number(HaplyBoard::Reply& reply, std::size_t at, float number) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (unsigned i = 0; i < 4; ++i) reply.bytes[at + i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

}  // namespace

Vector<2> HaplyBench::right_counts_per_turn(const VirtualHaplyVariant& variant, HaplyBoard::Kind kind) noexcept {
  const double factor = kind == HaplyBoard::Kind::m0 ? 2.0 : 1.0;
  return factor * Vector<2>{variant.encoders[0].counts_per_turn, variant.encoders[1].counts_per_turn};
}

HaplyBench::HaplyBench(const Options& options, std::int64_t now_ns) noexcept
    : options_(options),
      variant_(variant_of(options.variant)),
      counts_per_turn_(options.counts_per_turn.value_or(right_counts_per_turn(variant_, options.board.kind))),
      lived_ns_(now_ns),
      faults_(options.fault),
      board_(options.board),
      arms_(variant_.geometry, options.arms, start_of(variant_, options.starts_in_zero_pose)),
      hand_(options.hand, variant_.geometry.middle(), now_ns) {
  options_.variant = variant_.name;  // the caller's may not live as long
  faults_.publish(options.fault);
  if (options.starts_in_zero_pose) hand_.hold_zero_pose(true);
}

// In the order in which things happen.
void HaplyBench::live_until(std::int64_t now_ns) noexcept {
  lived_ns_ = std::max(lived_ns_, now_ns - longest_gap_ns);
  while (lived_ns_ + step_ns <= now_ns) {
    run_board(lived_ns_ + step_ns);
    step();
  }
  run_board(now_ns);
}

void HaplyBench::receive(std::span<const std::uint8_t> packet, std::int64_t at_ns) noexcept {
  if (packet.empty()) return;
  live_until(at_ns);
  ++packets_;
  last_packet_ns_ = at_ns;
  if (wrong_.program != BoardProgram::hapi) return;
  if (tears_packet_ && packet.size() > 1) {
    tears_packet_ = false;
    board_.receive(packet.first(1), at_ns);
    board_.receive(packet.subspan(1), at_ns + tear_ns);
  } else {
    board_.receive(packet, at_ns);
  }
  if (wrong_.garbage && packets_ % garbage_interval == 0) board_.receive(modem_command, at_ns);
  run_board(at_ns);
}

std::size_t HaplyBench::take(std::span<std::uint8_t, most_bytes> into, std::int64_t now_ns) noexcept {
  if (next_arrival_ns() > now_ns) return 0;
  const OnItsWay packet = on_their_way_.pop();
  std::ranges::copy(packet.bytes, into.begin());
  return packet.size;
}

std::int64_t HaplyBench::next_arrival_ns() const noexcept {
  return on_their_way_.empty() ? never : on_their_way_.front().arrival_ns;
}

std::int64_t HaplyBench::next_event_ns() const noexcept {
  const std::int64_t line_ns = wrong_.program == BoardProgram::chatty ? next_line_ns_ : never;
  return std::min({next_arrival_ns(), board_.next_event_ns(), line_ns});
}

void HaplyBench::lose_cable() noexcept {
  on_their_way_.clear();
  board_.lose_cable();
}

bool HaplyBench::obey_injected_fault() noexcept {
  if (!faults_.has_news()) return false;
  const InjectedHaplyFault before = wrong_;
  wrong_ = faults_.latest();
  if (wrong_ == before) return true;
  replies_ = 0;
  tears_packet_ = wrong_.tears_packet;
  if (wrong_.refuses_set_ups != before.refuses_set_ups) board_.refuse_set_ups(wrong_.refuses_set_ups);
  if (wrong_.restarts) board_.restart();
  if (wrong_.is_another_programs) board_.take_over(address_of_another, duty_of_another);
  if (wrong_.spoils_torque) board_.spoil_next_torque();
  leap_ = wrong_.encoder_jump_degrees * radians_per_degree;
  if (wrong_.program == BoardProgram::chatty) next_line_ns_ = lived_ns_ + line_interval_ns;
  return true;
}

// --- From the board to the host --------------------------------------------------------------------------------------

void HaplyBench::run_board(std::int64_t now_ns) noexcept {
  board_.run_until(now_ns);
  while (const auto reply = board_.take_reply()) answer(*reply);
  if (wrong_.program != BoardProgram::chatty) return;
  for (; next_line_ns_ <= now_ns; next_line_ns_ += line_interval_ns) send(line_of_text, next_line_ns_);
}

void HaplyBench::answer(HaplyBoard::Reply reply) noexcept {
  ++replies_;
  const HaplyReplyFault fault = fault_of_reply();
  if (fault == HaplyReplyFault::lost) return;
  spoil(reply, fault);
  const std::int64_t left_ns = reply.left_ns + wrong_.reply_delay_ns + wrong_.reply_creep_ns * replies_;
  if (wrong_.garbage && replies_ % garbage_interval == 0) send(modem_command, left_ns);
  const auto bytes = std::span{reply.bytes}.first(reply.size);
  send(bytes, left_ns);
  if (wrong_.duplicated_replies) send(bytes, left_ns);
}

// On the bus one packet does not overtake another. What the host lets lie for very long is lost.
void HaplyBench::send(std::span<const std::uint8_t> bytes, std::int64_t left_ns) noexcept {
  if (wrong_.dtr_is_low) return;
  const std::int64_t frame_ns = frame_of(options_.board.kind);
  OnItsWay packet;
  packet.arrival_ns = (left_ns + frame_ns - 1) / frame_ns * frame_ns;
  if (!on_their_way_.empty()) packet.arrival_ns = std::max(packet.arrival_ns, on_their_way_.back().arrival_ns);
  packet.size = bytes.size();
  std::ranges::copy(bytes, packet.bytes.begin());
  on_their_way_.push(packet);
}

HaplyReplyFault HaplyBench::fault_of_reply() noexcept {
  if (wrong_.reply == HaplyReplyFault::none || replies_ % wrong_.reply_interval != 0) return HaplyReplyFault::none;
  const auto faulty = static_cast<unsigned>(wrong_.faulty_replies);
  return faulty == 0 || replies_ / wrong_.reply_interval <= faulty ? wrong_.reply : HaplyReplyFault::none;
}

void HaplyBench::spoil(HaplyBoard::Reply& reply, HaplyReplyFault fault) const noexcept {
  if (fault == HaplyReplyFault::shortened) reply.size -= std::min<std::size_t>(reply.size, 3);
  if (reply.encoders == 0) return;
  if (fault == HaplyReplyFault::not_a_number) {
    put_number(reply, reply.size - 4, std::numeric_limits<float>::quiet_NaN());
  }
  if (fault != HaplyReplyFault::crossed) return;
  std::size_t at = reply.encoders_from;
  for (std::size_t port = 0; port < HaplyBoard::most_ports; ++port) {
    if ((reply.encoders >> port & 1U) == 0) continue;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      if (variant_.encoders[arm].port == port) put_number(reply, at, crossed_degrees[arm]);
    }
    at += 4;
  }
}

// --- Motors, arms, encoders ------------------------------------------------------------------------------------------

Vector<2> HaplyBench::torques_of(const HaplyBoard& board) const noexcept {
  Vector<2> torques{0.0};
  if (wrong_.power_lost) return torques;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto i = static_cast<glm::length_t>(arm);
    const VirtualHaplyVariant::Motor& motor = variant_.motors[arm];
    const double fault_sign = (wrong_.reversed_motors >> arm & 1U) != 0 ? -1.0 : 1.0;
    torques[i] = board.duty(motor.port) * options_.full_torques[i] * options_.wiring_signs[i] *
                 sign_of(motor.direction) * fault_sign;
  }
  return torques;
}

void HaplyBench::step() noexcept {
  constexpr double duration = static_cast<double>(step_ns) * 1e-9;
  lived_ns_ += step_ns;
  const double error = wrong_.zero_pose_error_degrees * radians_per_degree;
  hand_.advance(lived_ns_, arms_, variant_.zero_pose() + Vector<2>{error, -error});
  const Vector<2> before = arms_.angles();
  const Vector<2> torques = torques_of(board_);
  arms_.step(duration, torques, hand_.pull());
  if (leap_ != 0.0 && torques != Vector<2>(0.0)) turn_encoder(0, std::exchange(leap_, 0.0), 1.0);
  if (wrong_.power_lost) return;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto i = static_cast<glm::length_t>(arm);
    if ((wrong_.frozen_encoders >> arm & 1U) == 0)
      turn_encoder(arm, arms_.angles()[i] - before[i], wrong_.encoder_share);
  }
}

// Through so much [rad]. Whole edges reach the board.
void HaplyBench::turn_encoder(std::size_t arm, double angle, double share) noexcept {
  const VirtualHaplyVariant::Encoder& encoder = variant_.encoders[arm];
  const double turns = angle * degrees_per_radian / 360.0;
  const double before = std::floor(edges_[arm]);
  edges_[arm] += sign_of(encoder.direction) * share * turns * counts_per_turn_[static_cast<glm::length_t>(arm)];
  board_.count(encoder.port, static_cast<std::int64_t>(std::floor(edges_[arm]) - before));
}

HaplyTruth HaplyBench::truth_with(const HaplyBoard& board) const noexcept {
  HaplyTruth truth;
  truth.time_ns = lived_ns_;
  truth.address = board.motor_address(variant_.motors[0].port);
  truth.is_configured = truth.address != 0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::size_t port = variant_.motors[arm].port;
    truth.duties[arm] = wrong_.power_lost ? 0.0 : board.duty(port);
    truth.is_configured &= board.motor_address(port) == truth.address &&
                           board.encoder_address(variant_.encoders[arm].port) == truth.address;
  }
  truth.torques = torques_of(board);
  truth.angles = arms_.angles();
  truth.handle = arms_.handle();
  truth.velocity = arms_.velocity();
  truth.force = arms_.force_of(truth.torques);
  truth.packets = packets_;
  truth.last_packet_ns = last_packet_ns_;
  truth.exchanges = board.exchanges();
  truth.set_ups = board.set_ups();
  truth.resets = board.resets();
  return truth;
}

}  // namespace ghostforce
