// A host at the simulated bench, for tests: it moves the clock, sends packets and listens.
#pragma once

#include <algorithm>

#include "device/virtual_haply/haply_bench.h"
#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce {

struct BenchHost {
  using Bytes = hapi_bytes::Bytes;

  explicit BenchHost(const HaplyBench::Options& options = {}) : kind(options.board.kind), bench(options, now_ns) {
    bench.obey_injected_fault();
  }

  void inject(const InjectedHaplyFault& wrong) {
    bench.inject(wrong);
    bench.obey_injected_fault();
  }
  void inject(std::string_view name) { inject(hapi_bytes::haply_fault(name)); }

  Bytes hear(std::int64_t ns) {
    now_ns += ns;
    bench.live_until(now_ns);
    Bytes heard;
    std::array<std::uint8_t, HaplyBench::most_bytes> packet{};
    for (std::size_t size = 0; (size = bench.take(packet, now_ns)) > 0;) {
      heard.insert(heard.end(), packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return heard;
  }
  Bytes ask(const Bytes& packet, std::int64_t ns = 2 * hapi_bytes::ms) {
    bench.receive(packet, now_ns);
    return hear(ns);
  }
  Bytes exchange(double arm_1 = 0.0, double arm_2 = 0.0) {
    return ask(hapi_bytes::exchange_of_arms(bench.variant(), arm_1, arm_2));
  }

  // As a person and a program do, who know what counts the device has.
  void set_up() {
    bench.hold_zero_pose(true);
    hear(2'000 * hapi_bytes::ms);
    ask(hapi_bytes::set_up_of(bench.variant(), kind == HaplyBoard::Kind::m0 ? 2.0 : 1.0));
    bench.hold_zero_pose(false);
    hear(2'000 * hapi_bytes::ms);
  }

  double angle(const Bytes& reply, std::size_t arm) const { return hapi_bytes::angle_in(reply, bench.variant(), arm); }
  // In degrees, as they are.
  double true_angle(std::size_t arm) const {
    return degrees_per_radian * bench.arms().angles()[static_cast<glm::length_t>(arm)];
  }

  HaplyBoard::Kind kind;
  std::int64_t now_ns = 1'000'000'000;
  HaplyBench bench;
};

}  // namespace ghostforce
