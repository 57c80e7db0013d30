#include "app/files/falcon_calibration_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "app/console/did_you_mean.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/config_folder.h"
#include "app/files/first_problems.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/files/toml_text.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t known_format = 1;
constexpr double mm_per_m = 1000.0;

constexpr std::array<std::string_view, 14> known_keys{"format",          "serial",
                                                      "geometry",        "motor_constant_counts_per_N_m",
                                                      "motor_strengths", "motor_of_leg",
                                                      "encoder_of_leg",  "angle_at_zero_count_deg",
                                                      "gear_ratio",      "encoder_offset_counts",
                                                      "center_mm",       "right_axis",
                                                      "up_axis",         "scale"};

// In the order of FalconAxis.
constexpr std::array<std::string_view, 6> axis_words{"x", "-x", "y", "-y", "z", "-z"};

struct Range {
  double least;
  double greatest;
  std::string_view unit;
};

// A serial number is part of a file's name.
bool is_serial(std::string_view text) {
  return !text.empty() && text.size() <= FalconSerial::longest && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
  });
}

class CalibrationReader {
 public:
  explicit CalibrationReader(std::string_view shown_path) : shown_path_(printable(shown_path, longest_path)) {}

  FalconCalibration read(std::string_view text) {
    ParsedToml parsed = parse_toml(text);
    if (parsed.problem) {
      complain(parsed.problem->position, parsed.problem->what);
      tell();
    }
    file_ = std::move(parsed.table);
    read_format();
    find_unknown();
    read_device();
    read_plane();
    if (!problems_.empty()) tell();
    return calibration_;
  }

 private:
  // --- Telling what is wrong ---

  // `what` is a text, or a function that makes it.
  template <typename Words>
  void complain(toml::source_position position, Words what) {
    problems_.add(position, std::move(what));
  }

  void complain(const toml::node& node, std::string_view key, const std::string& what) {
    complain(node.source().begin, fmt::format("the key {}: {}", key, what));
  }

  [[noreturn]] void tell() {
    const auto lines = problems_.lines([this](const toml::source_position& position) {
      return fmt::format("{}:{}:{}", shown_path_, std::max<toml::source_index>(position.line, 1),
                         std::max<toml::source_index>(position.column, 1));
    });
    throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(lines, "\n")));
  }

  // --- What is there ---

  // Another format may have other keys: nothing else is looked at then.
  void read_format() {
    const toml::node* const node = file_.get("format");
    if (node == nullptr) {
      complain({1, 1}, "the key format is missing; begin the file with format = 1");
      return;
    }
    const auto* const number = node->as_integer();
    if (number == nullptr) {
      complain(*node, "format", fmt::format("is {}; write format = 1", type_words(node->type())));
    } else if (number->get() != known_format) {
      complain(*node, "format",
               fmt::format("is {}, and this program knows format 1 only; a newer one may read it", number->get()));
      tell();
    }
  }

  void find_unknown() {
    for (const auto& [key, node] : file_) {
      const std::string_view name = key.str();
      if (std::find(known_keys.begin(), known_keys.end(), name) != known_keys.end()) continue;
      complain(key.source().begin, [name] {
        const std::string near = did_you_mean(name, known_keys);
        return fmt::format("the key {} is unknown{}", printable(name),
                           near.empty() ? fmt::format("; there is {}", listed(known_keys)) : near);
      });
    }
  }

  // --- Values; empty where there is none or where it is wrong, which has been told then ---

  std::optional<std::string> text(std::string_view key) {
    const toml::node* const node = file_.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto* const value = node->as_string()) return value->get();
    complain(*node, key, fmt::format("is {}; give a text in quotes", type_words(node->type())));
    return std::nullopt;
  }

  // The number of the word in the list.
  std::optional<std::size_t> word(std::string_view key, std::span<const std::string_view> words) {
    const std::optional<std::string> value = text(key);
    if (!value) return std::nullopt;
    const auto found = std::find(words.begin(), words.end(), *value);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    complain(*file_.get(key), key,
             fmt::format("'{}' is none of {}{}", printable(*value), listed(words), did_you_mean(*value, words)));
    return std::nullopt;
  }

  std::optional<double> number(const toml::node& node, std::string_view key, const Range& range) {
    const std::string need =
        fmt::format("give {} to {}{}{}", range.least, range.greatest, range.unit.empty() ? "" : " ", range.unit);
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) {
      complain(node, key, fmt::format("is {}; {}", type_words(node.type()), need));
      return std::nullopt;
    }
    // Written so that NaN is out of range too.
    if (*value >= range.least && *value <= range.greatest) return value;
    complain(node, key, fmt::format("{} is out of range; {}", *value, need));
    return std::nullopt;
  }

  std::optional<double> number(std::string_view key, const Range& range) {
    const toml::node* const node = file_.get(key);
    return node == nullptr ? std::nullopt : number(*node, key, range);
  }

  std::optional<Vector<3>> three_numbers(std::string_view key, const Range& range, bool whole) {
    const toml::node* const node = file_.get(key);
    if (node == nullptr) return std::nullopt;
    const toml::array* const array = node->as_array();
    if (array == nullptr || array->size() != 3) {
      complain(*node, key,
               fmt::format("is {}; give three numbers, as [0, 0, 0]",
                           array == nullptr ? std::string(type_words(node->type()))
                                            : fmt::format("an array of {}", array->size())));
      return std::nullopt;
    }
    Vector<3> numbers(0.0);
    bool is_good = true;
    for (glm::length_t i = 0; i < 3; ++i) {
      const toml::node& element = (*array)[static_cast<std::size_t>(i)];
      if (whole && element.is_floating_point()) {
        complain(element, key, "has a decimal point or an exponent; give whole numbers");
        is_good = false;
      } else if (const auto value = number(element, key, range)) {
        numbers[i] = *value;
      } else {
        is_good = false;
      }
    }
    return is_good ? std::optional(numbers) : std::nullopt;
  }

  std::optional<LegNumbers> leg_numbers(std::string_view key) {
    const auto numbers = three_numbers(key, {-3.0, 3.0, ""}, true);
    if (!numbers) return std::nullopt;
    LegNumbers of_leg{};
    for (glm::length_t i = 0; i < 3; ++i) {
      of_leg[static_cast<std::size_t>(i)] = static_cast<std::int8_t>((*numbers)[i]);
    }
    if (are_leg_numbers(of_leg)) return of_leg;
    complain(*file_.get(key), key,
             "does not have 1, 2 and 3 once each; give them in some order, with a minus where one counts the other "
             "way, as [1, -3, 2]");
    return std::nullopt;
  }

  // --- Their meaning ---

  void read_device() {
    if (!file_.contains("serial")) {
      complain({1, 1}, "the key serial is missing; give the device's serial number, which `ghostforce doctor` shows");
    } else if (const auto serial = text("serial")) {
      if (is_serial(*serial)) {
        calibration_.serial = *FalconSerial::from(*serial);
      } else {
        complain(*file_.get("serial"), "serial",
                 fmt::format("'{}' is no serial number; give 1 to {} letters, digits, '-' or '_'", printable(*serial),
                             FalconSerial::longest));
      }
    }
    std::vector<std::string_view> names;
    for (const GeometryPreset& preset : geometry_catalog()) names.push_back(preset.name);
    if (const auto chosen = word("geometry", names)) calibration_.geometry = geometry_catalog()[*chosen].geometry;
    if (const auto constant = number("motor_constant_counts_per_N_m", {1000.0, 100000.0, "counts per N·m"})) {
      calibration_.counts_per_newton_metre = *constant;
    }
    if (const auto angle = number("angle_at_zero_count_deg", {-90.0, 90.0, "degrees"})) {
      calibration_.geometry.angle_at_zero_count = *angle * radians_per_degree;
    }
    if (const auto gear = number("gear_ratio", {6.0, 10.0, ""})) calibration_.geometry.gear_ratio = *gear;
    if (const auto strengths = three_numbers("motor_strengths", {0.2, 2.0, ""}, false)) {
      calibration_.motor_strengths = *strengths;
    }
    if (const auto of_leg = leg_numbers("motor_of_leg")) calibration_.motor_of_leg = *of_leg;
    if (const auto of_leg = leg_numbers("encoder_of_leg")) calibration_.encoder_of_leg = *of_leg;
    if (const auto offset = three_numbers("encoder_offset_counts", {-4096.0, 4096.0, "counts"}, true)) {
      for (glm::length_t i = 0; i < 3; ++i) {
        calibration_.encoder_offset[static_cast<std::size_t>(i)] = static_cast<std::int16_t>((*offset)[i]);
      }
    }
  }

  void read_plane() {
    if (const auto center = three_numbers("center_mm", {-200.0, 200.0, "mm"}, false)) {
      calibration_.center = *center / mm_per_m;
    }
    const auto right = word("right_axis", axis_words);
    const auto up = word("up_axis", axis_words);
    if (right) calibration_.right_axis = static_cast<FalconAxis>(*right);
    if (up) calibration_.up_axis = static_cast<FalconAxis>(*up);
    // A word that was refused has left the usual axis in its place, about which the file says nothing.
    const bool are_known = (right || !file_.contains("right_axis")) && (up || !file_.contains("up_axis"));
    if (are_known && are_parallel(calibration_.right_axis, calibration_.up_axis)) {
      const std::string_view key = up ? "up_axis" : "right_axis";
      complain(*file_.get(key), key,
               fmt::format("right_axis is '{}' and up_axis '{}', and a plane needs two different ones; change one",
                           axis_words[static_cast<std::size_t>(calibration_.right_axis)],
                           axis_words[static_cast<std::size_t>(calibration_.up_axis)]));
    }
    if (const auto scale = number("scale", {0.1, 10.0, ""})) calibration_.scale = *scale;
  }

  std::string shown_path_;
  toml::table file_;
  FirstProblems<toml::source_position> problems_;
  FalconCalibration calibration_;
};

// The catalog's, whatever the angle at count zero and the gear. Null: none of them.
const GeometryPreset* preset_of(FalconGeometry geometry) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    geometry.angle_at_zero_count = preset.geometry.angle_at_zero_count;
    geometry.gear_ratio = preset.geometry.gear_ratio;
    if (geometry == preset.geometry) return &preset;
  }
  return nullptr;
}

struct CalibrationFile {
  fs::path path;
  FalconCalibration calibration;
};

fs::path calibration_folder() {
  const fs::path folder = config_folder();
  return folder.empty() ? folder : folder / "falcon";
}

std::vector<CalibrationFile> read_all() {
  const fs::path folder = calibration_folder();
  std::error_code error;
  if (folder.empty() || !fs::exists(folder, error)) return {};
  std::vector<fs::path> paths;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    if (file->path().extension() == ".toml") paths.push_back(file->path());
  }
  if (error) {
    throw Failure(ExitCode::file_trouble, fmt::format("the folder {} cannot be read: {}; look at its permissions",
                                                      printable(folder.string(), longest_path), error.message()));
  }
  std::sort(paths.begin(), paths.end());

  std::vector<CalibrationFile> files;
  std::string problems;
  const auto add_problem = [&](const std::string& what) { problems += (problems.empty() ? "" : "\n") + what; };
  for (const fs::path& path : paths) {
    const std::string shown = printable(path.string(), longest_path);
    if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
      add_problem(fmt::format("{} is {}, and calibrations are files; remove it", shown, kind));
      continue;
    }
    const FileContents file = file_contents(path);
    if (file.error != 0) {
      throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be read: {}", shown, unreadable_words(file.error)));
    }
    try {
      files.push_back({path, read_falcon_calibration(file.text, path.string())});
    } catch (const Failure& failure) {
      add_problem(failure.what());
      continue;
    }
    const auto twin = std::find_if(files.begin(), std::prev(files.end()), [&](const CalibrationFile& other) {
      return other.calibration.serial == files.back().calibration.serial;
    });
    if (twin != std::prev(files.end())) {
      add_problem(fmt::format("{} is about the same device as {}; remove one", shown,
                              printable(twin->path.string(), longest_path)));
    }
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, problems);
  return files;
}

}  // namespace

FalconCalibration read_falcon_calibration(std::string_view text, std::string_view shown_path) {
  return CalibrationReader(shown_path).read(text);
}

std::string falcon_calibration_text(const FalconCalibration& calibration) {
  const GeometryPreset* const preset = preset_of(calibration.geometry);
  if (preset == nullptr) throw Failure(ExitCode::bug, "a calibration has a geometry that no file can name");
  const Vector<3> center_mm = calibration.center * mm_per_m;
  const Vector<3>& strengths = calibration.motor_strengths;
  return fmt::format(
      "# Written by ghostforce.\nformat = {}\nserial = {}\ngeometry = {}\nmotor_constant_counts_per_N_m = {}\n"
      "motor_strengths = [{}, {}, {}]\nmotor_of_leg = [{}]\nencoder_of_leg = [{}]\nangle_at_zero_count_deg = {}\n"
      "gear_ratio = {}\nencoder_offset_counts = [{}]\ncenter_mm = [{}, {}, {}]\nright_axis = {}\nup_axis = {}\n"
      "scale = {}\n",
      known_format, toml_string(calibration.serial.text()), toml_string(preset->name),
      calibration.counts_per_newton_metre, strengths.x, strengths.y, strengths.z,
      fmt::join(calibration.motor_of_leg, ", "), fmt::join(calibration.encoder_of_leg, ", "),
      calibration.geometry.angle_at_zero_count / radians_per_degree, calibration.geometry.gear_ratio,
      fmt::join(calibration.encoder_offset, ", "), center_mm.x, center_mm.y, center_mm.z,
      toml_string(axis_words[static_cast<std::size_t>(calibration.right_axis)]),
      toml_string(axis_words[static_cast<std::size_t>(calibration.up_axis)]), calibration.scale);
}

std::vector<FalconCalibration> recall_falcon_calibrations() {
  std::vector<FalconCalibration> calibrations;
  for (const CalibrationFile& file : read_all()) calibrations.push_back(file.calibration);
  return calibrations;
}

fs::path remember_falcon_calibration(const FalconCalibration& calibration) {
  const std::string_view serial = calibration.serial.text();
  if (!is_serial(serial)) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("'{}' is no serial number that a calibration could be kept by", printable(serial)));
  }
  const std::string text = falcon_calibration_text(calibration);
  const fs::path folder = calibration_folder();
  if (folder.empty()) {
    throw Failure(ExitCode::file_trouble, "there is no home folder for a calibration; set HOME or XDG_CONFIG_HOME");
  }
  fs::path path = folder / (std::string(serial) + ".toml");
  for (const CalibrationFile& file : read_all()) {
    if (file.calibration.serial == calibration.serial) path = file.path;
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Failure(ExitCode::file_trouble, fmt::format("the folder {} cannot be made: {}; calibrations are kept there",
                                                      printable(folder.string(), longest_path), error.message()));
  }
  OutputFile output(path.string());
  output.write(text);
  output.commit();
  return path;
}

}  // namespace ghostforce
