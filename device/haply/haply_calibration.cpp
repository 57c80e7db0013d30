#include "device/haply/haply_calibration.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr std::uint8_t clockwise = 0;
constexpr std::uint8_t counter_clockwise = 1;

constexpr HaplyCalibration variant(std::string_view name, const PantographGeometry& geometry,
                                   const std::array<HaplyArm, 2>& arms, const Vector<2>& center) noexcept {
  return {.serial = {}, .variant = name, .geometry = geometry, .arms = arms, .center = center};
}

// From public host programs and cross-checked with the zero poses that these kinematics give (docs/haply.md).
constexpr std::array variants{
    HaplyVariant{"2017", "2DIY kit of 2017, Haplet", "Lay both arms flat on the base, pointing away from each other.",
                 variant("2017", {.driven_length = 0.050, .distal_length = 0.070, .base = 0.020},
                         {HaplyArm{.motor_port = 1,
                                   .motor_direction = clockwise,
                                   .encoder_port = 1,
                                   .encoder_direction = clockwise,
                                   .offset_deg = 180.0,
                                   .counts_per_turn = 13824.0},
                          HaplyArm{.motor_port = 2,
                                   .motor_direction = clockwise,
                                   .encoder_port = 2,
                                   .encoder_direction = clockwise,
                                   .offset_deg = 0.0,
                                   .counts_per_turn = 13824.0}},
                         {0.010, 0.070})},
    HaplyVariant{"v2", "2DIY V2, metal plate", "Fold both arms back as far as they go.",
                 variant("v2", {.driven_length = 0.070, .distal_length = 0.090, .base = 0.0},
                         {HaplyArm{.motor_port = 2,
                                   .motor_direction = counter_clockwise,
                                   .encoder_port = 2,
                                   .encoder_direction = counter_clockwise,
                                   .offset_deg = 241.0,
                                   .counts_per_turn = 10752.0},
                          HaplyArm{.motor_port = 1,
                                   .motor_direction = clockwise,
                                   .encoder_port = 1,
                                   .encoder_direction = clockwise,
                                   .offset_deg = -61.0,
                                   .counts_per_turn = 10752.0}},
                         {0.0, 0.090})},
    HaplyVariant{"v3", "2DIY V3, plastic", "Stretch both arms forwards until they stop.",
                 variant("v3", {.driven_length = 0.070, .distal_length = 0.090, .base = 0.038},
                         {HaplyArm{.motor_port = 2,
                                   .motor_direction = counter_clockwise,
                                   .encoder_port = 2,
                                   .encoder_direction = counter_clockwise,
                                   .offset_deg = 97.23,
                                   .counts_per_turn = 5299.7},
                          HaplyArm{.motor_port = 1,
                                   .motor_direction = counter_clockwise,
                                   .encoder_port = 1,
                                   .encoder_direction = counter_clockwise,
                                   .offset_deg = 82.77,
                                   .counts_per_turn = 5219.3}},
                         {0.019, 0.090})},
    HaplyVariant{"v3.1", "2DIY V3.1, plastic", "Fold both arms back as far as they go.",
                 variant("v3.1", {.driven_length = 0.070, .distal_length = 0.090, .base = 0.038},
                         {HaplyArm{.motor_port = 2,
                                   .motor_direction = counter_clockwise,
                                   .encoder_port = 2,
                                   .encoder_direction = counter_clockwise,
                                   .offset_deg = 168.0,
                                   .counts_per_turn = 4880.0},
                          HaplyArm{.motor_port = 1,
                                   .motor_direction = counter_clockwise,
                                   .encoder_port = 1,
                                   .encoder_direction = counter_clockwise,
                                   .offset_deg = 12.0,
                                   .counts_per_turn = 4880.0}},
                         {0.019, 0.090})},
};

}  // namespace

hapi::SetUp set_up_of(const HaplyCalibration& calibration) noexcept {
  hapi::SetUp set_up;
  for (const HaplyArm& arm : calibration.arms) {
    const std::size_t motor = arm.motor_port - 1U;
    const std::size_t encoder = arm.encoder_port - 1U;
    set_up.motor_directions[motor] = arm.motor_direction;
    set_up.encoder_directions[encoder] = arm.encoder_direction;
    set_up.offsets_deg[encoder] = static_cast<float>(arm.offset_deg);
    set_up.counts_per_turn[encoder] = static_cast<float>(arm.counts_per_turn);
  }
  return set_up;
}

std::array<double, 2> zero_pose_of(const HaplyCalibration& calibration) noexcept {
  return {calibration.arms[0].offset_deg * radians_per_degree, calibration.arms[1].offset_deg * radians_per_degree};
}

std::span<const HaplyVariant> haply_variant_catalog() noexcept {
  return variants;
}

const HaplyVariant& usual_haply_variant() noexcept {
  return variants.back();
}

const HaplyVariant* find_haply_variant(std::string_view name) noexcept {
  const auto found = std::ranges::find(variants, name, &HaplyVariant::name);
  return found == variants.end() ? nullptr : &*found;
}

HaplyCalibration calibration_of(const DeviceSerial& serial, std::span<const HaplyCalibration> calibrations,
                                const HaplyCalibration& usual) noexcept {
  if (serial == DeviceSerial()) return usual;
  const auto known = std::ranges::find(calibrations, serial, &HaplyCalibration::serial);
  return known == calibrations.end() ? usual : *known;
}

}  // namespace ghostforce
