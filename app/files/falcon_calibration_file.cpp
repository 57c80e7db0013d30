#include "app/files/falcon_calibration_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/files/calibration_folder.h"
#include "app/files/toml_document.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

// In the order of FalconAxis.
constexpr std::array<std::string_view, 6> axis_words{"x", "-x", "y", "-y", "z", "-z"};

// Into three numbers from `into` on. False: they are wrong, which has been told then.
template <typename Number>
bool read_three(const TomlValue& value, const NumberLimits& limits, Number* into, double per_si = 1.0) {
  const auto numbers = value.numbers<3>(limits, "give three numbers, as in [0, 0, 0]");
  if (!numbers) return false;
  std::transform(numbers->begin(), numbers->end(), into,
                 [per_si](double number) { return static_cast<Number>(number / per_si); });
  return true;
}

auto legs_into(LegNumbers& legs) {
  return [&legs](const TomlValue& value) {
    const NumberLimits limits{.least = -3.0, .greatest = 3.0, .whole = true};
    if (!read_three(value, limits, legs.data()) || are_leg_numbers(legs)) return;
    value.refuse("does not contain 1, 2 and 3 once each",
                 "give them in any order, with a minus where one counts the other way, as in [1, -3, 2]");
  };
}

// The catalog's, whatever the angle at count zero and the gear. Null: none of them.
const GeometryPreset* preset_of(FalconGeometry geometry) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    geometry.angle_at_zero_count = preset.geometry.angle_at_zero_count;
    geometry.gear_ratio = preset.geometry.gear_ratio;
    if (geometry == preset.geometry) return &preset;
  }
  return nullptr;
}

constexpr std::string_view folder_of_falcons = "falcon";

// Into the list.
ReadCalibration falcons_into(std::vector<FalconCalibration>& calibrations) {
  return [&calibrations](std::string_view text, std::string_view shown_path) {
    calibrations.push_back(read_falcon_calibration(text, shown_path));
    return calibrations.back().serial;
  };
}

}  // namespace

FalconCalibration read_falcon_calibration(std::string_view text, std::string_view shown_path) {
  FalconCalibration calibration;
  bool are_axes_known = true;
  const auto axis_into = [&](FalconAxis& axis) {
    return [&](const TomlValue& value) {
      const auto word = value.word(axis_words);
      are_axes_known = are_axes_known && word;
      axis = static_cast<FalconAxis>(word.value_or(0));
    };
  };
  const std::vector<TomlKey> keys{
      {"", "format", nullptr},
      {"", "serial", serial_into(calibration.serial),
       "give the device's serial number, which `ghostforce doctor` shows"},
      {"", "geometry",
       catalog_entry(geometry_catalog(),
                     [&](const GeometryPreset& preset) { calibration.geometry = preset.geometry; })},
      {"", "motor_constant_counts_per_N_m",
       number_into(calibration.counts_per_newton_metre, {1000.0, 100000.0, "counts per N·m"})},
      {"", "motor_strengths",
       [&](const TomlValue& value) {
         read_three(value, {0.2, 2.0}, &calibration.motor_strengths.x);
       }},
      {"", "motor_of_leg", legs_into(calibration.motor_of_leg)},
      {"", "encoder_of_leg", legs_into(calibration.encoder_of_leg)},
      {"", "angle_at_zero_count_deg",
       number_into(calibration.geometry.angle_at_zero_count, {-90.0, 90.0, "degrees"}, radians_per_degree)},
      {"", "gear_ratio", number_into(calibration.geometry.gear_ratio, {6.0, 10.0})},
      {"", "encoder_offset_counts",
       [&](const TomlValue& value) {
         const NumberLimits limits{.least = -4096.0, .greatest = 4096.0, .unit = "counts", .whole = true};
         read_three(value, limits, calibration.encoder_offset.data());
       }},
      {"", "center_mm",
       [&](const TomlValue& value) {
         read_three(value, {-200.0, 200.0, "mm"}, &calibration.center.x, mm_per_m);
       }},
      {"", "right_axis", axis_into(calibration.right_axis)},
      {"", "up_axis", axis_into(calibration.up_axis)},
      {"", "scale", number_into(calibration.scale, {0.1, 10.0})},
  };
  TomlReader reader(shown_path);
  if (!reader.parse(text) || !reader.has_known_format()) reader.finish();
  reader.read(keys);
  if (are_axes_known && are_parallel(calibration.right_axis, calibration.up_axis)) {
    const auto up = reader.find("", "up_axis");
    (up ? up : reader.find("", "right_axis"))
        ->refuse(fmt::format("right_axis is '{}' and up_axis is '{}', but a plane needs two different axes",
                             axis_words[static_cast<std::size_t>(calibration.right_axis)],
                             axis_words[static_cast<std::size_t>(calibration.up_axis)]),
                 "change one");
  }
  reader.finish();
  return calibration;
}

std::string falcon_calibration_text(const FalconCalibration& calibration) {
  const GeometryPreset* const preset = preset_of(calibration.geometry);
  if (preset == nullptr) throw Failure(ExitCode::bug, "a calibration has a geometry that no file can name");
  const Vector<3> center_mm = calibration.center * mm_per_m;
  const Vector<3>& strengths = calibration.motor_strengths;
  return fmt::format(
      "# Written by ghostforce.\nformat = 1\nserial = {}\ngeometry = {}\nmotor_constant_counts_per_N_m = {}\n"
      "motor_strengths = [{}, {}, {}]\nmotor_of_leg = [{}]\nencoder_of_leg = [{}]\nangle_at_zero_count_deg = {}\n"
      "gear_ratio = {}\nencoder_offset_counts = [{}]\ncenter_mm = [{}, {}, {}]\nright_axis = {}\nup_axis = {}\n"
      "scale = {}\n",
      toml_string(calibration.serial.text()), toml_string(preset->name), calibration.counts_per_newton_metre,
      strengths.x, strengths.y, strengths.z, fmt::join(calibration.motor_of_leg, ", "),
      fmt::join(calibration.encoder_of_leg, ", "), calibration.geometry.angle_at_zero_count / radians_per_degree,
      calibration.geometry.gear_ratio, fmt::join(calibration.encoder_offset, ", "), center_mm.x, center_mm.y,
      center_mm.z, toml_string(axis_words[static_cast<std::size_t>(calibration.right_axis)]),
      toml_string(axis_words[static_cast<std::size_t>(calibration.up_axis)]), calibration.scale);
}

std::vector<FalconCalibration> load_falcon_calibrations() {
  std::vector<FalconCalibration> calibrations;
  read_calibrations(folder_of_falcons, falcons_into(calibrations));
  return calibrations;
}

std::filesystem::path save_falcon_calibration(const FalconCalibration& calibration) {
  const std::string_view serial = calibration.serial.text();
  expect_serial(serial);
  std::vector<FalconCalibration> kept;
  return save_calibration(folder_of_falcons, calibration.serial, serial, falcon_calibration_text(calibration),
                          falcons_into(kept));
}

}  // namespace ghostforce
