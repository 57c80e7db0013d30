#include "device/virtual_haply/virtual_haply_variant.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr ArmsGeometry arms_of_2017{.driven = 0.05, .distal = 0.07, .apart = 0.02};
constexpr ArmsGeometry arms_of_v2{.driven = 0.07, .distal = 0.09, .apart = 0.0};
constexpr ArmsGeometry arms_of_v3{.driven = 0.07, .distal = 0.09, .apart = 0.038};

constexpr std::array variants_known{
    VirtualHaplyVariant{.name = "2017",
                        .geometry = arms_of_2017,
                        .motors = {{{0, 0}, {0, 1}}},
                        .encoders = {{{0, 180.0, 13824.0, 0}, {0, 0.0, 13824.0, 1}}}},
    VirtualHaplyVariant{.name = "v2",
                        .geometry = arms_of_v2,
                        .motors = {{{1, 1}, {0, 0}}},
                        .encoders = {{{1, 241.0, 10752.0, 1}, {0, -61.0, 10752.0, 0}}}},
    VirtualHaplyVariant{.name = "v3",
                        .geometry = arms_of_v3,
                        .motors = {{{1, 1}, {1, 0}}},
                        .encoders = {{{1, 97.23, 5299.7, 1}, {1, 82.77, 5219.3, 0}}}},
    VirtualHaplyVariant{.name = "v3.1",
                        .geometry = arms_of_v3,
                        .motors = {{{1, 1}, {1, 0}}},
                        .encoders = {{{1, 168.0, 4880.0, 1}, {1, 12.0, 4880.0, 0}}}},
};

}  // namespace

std::span<const VirtualHaplyVariant> virtual_haply_variants() noexcept {
  return variants_known;
}

const VirtualHaplyVariant* find_virtual_haply_variant(std::string_view name) noexcept {
  const auto found = std::ranges::find(variants_known, name, &VirtualHaplyVariant::name);
  return found == variants_known.end() ? nullptr : &*found;
}

}  // namespace ghostforce
