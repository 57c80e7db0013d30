#include "app/files/haply_calibration_file.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/calibration_folder.h"
#include "app/files/toml_document.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr std::string_view folder_of_boards = "haply";
constexpr std::string_view name_for_any_board = "any";

constexpr std::array<std::string_view, 2> arm_tables{"arm1", "arm2"};
// As hAPI numbers them.
constexpr std::array<std::string_view, 2> direction_words{"clockwise", "counter-clockwise"};

// Divided, so that it is the very number that the same length has in a program.
auto length_into(double& length, const NumberLimits& limits) {
  return [&length, limits](const TomlValue& value) {
    if (const auto mm = value.number(limits)) length = *mm / mm_per_m;
  };
}

auto direction_into(std::uint8_t& direction) {
  return [&direction](const TomlValue& value) {
    if (const auto word = value.word(direction_words)) direction = static_cast<std::uint8_t>(*word);
  };
}

// `is_known` becomes false where it is wrong.
auto port_into(std::uint8_t& port, bool& is_known) {
  return [&port, &is_known](const TomlValue& value) {
    const auto number = value.number({.least = 1.0, .greatest = 2.0, .whole = true});
    if (number) port = static_cast<std::uint8_t>(*number);
    is_known = is_known && number;
  };
}

// Told where a person has written one of them.
void refuse_equal_ports(TomlReader& reader, std::string_view key, std::string_view what, std::uint8_t port) {
  const auto second = reader.find(arm_tables[1], key);
  const auto at = second ? second : reader.find(arm_tables[0], key);
  at->refuse(fmt::format("the {}s of both arms are at port {}", what, port),
             fmt::format("give each arm's {} a port of its own", what));
}

// Into the list.
ReadCalibration boards_into(std::vector<HaplyCalibration>& calibrations) {
  return [&calibrations](std::string_view text, std::string_view shown_path) {
    calibrations.push_back(read_haply_calibration(text, shown_path));
    return calibrations.back().serial;
  };
}

std::string arm_text(const HaplyArm& arm, std::string_view table) {
  return fmt::format(
      "\n[{}]\nmotor_port = {}\nmotor_direction = {}\nencoder_port = {}\nencoder_direction = {}\noffset_deg = {:.12g}\n"
      "counts_per_turn = {:.12g}\nmotor_reversed = {}\ntorque_scale = {:.12g}\n",
      table, arm.motor_port, toml_string(direction_words.at(arm.motor_direction)), arm.encoder_port,
      toml_string(direction_words.at(arm.encoder_direction)), arm.offset_deg, arm.counts_per_turn,
      arm.is_motor_reversed, arm.torque_scale);
}

}  // namespace

HaplyCalibration read_haply_calibration(std::string_view text, std::string_view shown_path) {
  HaplyCalibration calibration = usual_haply_variant().calibration;
  bool is_variant_known = false;
  bool are_motor_ports_known = true;
  bool are_encoder_ports_known = true;
  const std::string variants = fmt::format("give one of {}", listed(names_of(haply_variant_catalog())));
  // The variant first: what comes after it changes what it brings.
  std::vector<TomlKey> keys{
      {"", "format", nullptr},
      {"", "variant",
       catalog_entry(haply_variant_catalog(),
                     [&](const HaplyVariant& variant) {
                       calibration = variant.calibration;
                       is_variant_known = true;
                     }),
       variants},
      {"", "serial", serial_into(calibration.serial)},
      {"geometry", "driven_mm", length_into(calibration.geometry.driven_length, {10.0, 500.0, "mm"})},
      {"geometry", "distal_mm", length_into(calibration.geometry.distal_length, {10.0, 500.0, "mm"})},
      {"geometry", "base_mm", length_into(calibration.geometry.base, {0.0, 500.0, "mm"})},
      {"plane", "center_mm",
       [&](const TomlValue& value) {
         const auto mm = value.numbers<2>({-500.0, 500.0, "mm"}, "give two numbers, as in [0, 90]");
         if (mm) calibration.center = {(*mm)[0] / mm_per_m, (*mm)[1] / mm_per_m};
       }},
      {"plane", "scale", number_into(calibration.scale, {0.1, 20.0})},
  };
  for (std::size_t i = 0; i < arm_tables.size(); ++i) {
    HaplyArm& arm = calibration.arms[i];
    const std::string_view table = arm_tables[i];
    keys.push_back({table, "motor_port", port_into(arm.motor_port, are_motor_ports_known)});
    keys.push_back({table, "motor_direction", direction_into(arm.motor_direction)});
    keys.push_back({table, "encoder_port", port_into(arm.encoder_port, are_encoder_ports_known)});
    keys.push_back({table, "encoder_direction", direction_into(arm.encoder_direction)});
    keys.push_back({table, "offset_deg", number_into(arm.offset_deg, {-360.0, 360.0, "degrees"})});
    keys.push_back({table, "counts_per_turn", number_into(arm.counts_per_turn, {100.0, 200000.0, "counts"})});
    keys.push_back({table, "motor_reversed", yes_or_no_into(arm.is_motor_reversed)});
    keys.push_back({table, "torque_scale", number_into(arm.torque_scale, {0.1, 10.0})});
  }
  TomlReader reader(shown_path);
  if (!reader.parse(text) || !reader.has_known_format()) reader.finish();
  reader.read(keys);
  const auto& [first, second] = calibration.arms;
  if (is_variant_known && are_motor_ports_known && first.motor_port == second.motor_port) {
    refuse_equal_ports(reader, "motor_port", "motor", first.motor_port);
  }
  if (is_variant_known && are_encoder_ports_known && first.encoder_port == second.encoder_port) {
    refuse_equal_ports(reader, "encoder_port", "encoder", first.encoder_port);
  }
  reader.finish();
  return calibration;
}

std::string haply_calibration_text(const HaplyCalibration& calibration) {
  if (find_haply_variant(calibration.variant) == nullptr) {
    throw Failure(ExitCode::bug, "a calibration has a variant that no file can name");
  }
  const std::string_view serial = calibration.serial.text();
  const PantographGeometry& geometry = calibration.geometry;
  const Vector<2> center_mm = calibration.center * mm_per_m;
  return fmt::format(
      "# Written by ghostforce.\nformat = 1\nvariant = {}\n{}\n[geometry]\ndriven_mm = {:.12g}\ndistal_mm = {:.12g}\n"
      "base_mm = {:.12g}\n{}{}\n[plane]\ncenter_mm = [{:.12g}, {:.12g}]\nscale = {:.12g}\n",
      toml_string(calibration.variant), serial.empty() ? "" : fmt::format("serial = {}\n", toml_string(serial)),
      geometry.driven_length * mm_per_m, geometry.distal_length * mm_per_m, geometry.base * mm_per_m,
      arm_text(calibration.arms[0], arm_tables[0]), arm_text(calibration.arms[1], arm_tables[1]), center_mm.x,
      center_mm.y, calibration.scale);
}

std::vector<HaplyCalibration> load_haply_calibrations() {
  std::vector<HaplyCalibration> calibrations;
  read_calibrations(folder_of_boards, boards_into(calibrations));
  return calibrations;
}

std::filesystem::path save_haply_calibration(const HaplyCalibration& calibration) {
  const std::string_view serial = calibration.serial.text();
  if (!serial.empty()) expect_serial(serial);
  std::vector<HaplyCalibration> kept;
  return save_calibration(folder_of_boards, calibration.serial, serial.empty() ? name_for_any_board : serial,
                          haply_calibration_text(calibration), boards_into(kept));
}

}  // namespace ghostforce
