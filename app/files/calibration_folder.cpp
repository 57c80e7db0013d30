#include "app/files/calibration_folder.h"

#include <algorithm>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/files/read_error.h"
#include "app/files/xdg_folders.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

fs::path calibration_folder(std::string_view name) {
  const fs::path folder = config_folder();
  return folder.empty() ? folder : folder / name;
}

ReadProblem twin_problem(const std::string& shown, const CalibrationFile& twin) {
  const std::string other = quoted_text(twin.path.string(), longest_path);
  return {.file = shown,
          .what = twin.serial.text().empty() ? fmt::format("is for any device, and so is {}", other)
                                             : fmt::format("is for the same device as {}", other),
          .remedy = "remove one",
          .joint = " "};
}

}  // namespace

std::vector<CalibrationFile> read_calibrations(std::string_view name, const ReadCalibration& read) {
  const fs::path folder = calibration_folder(name);
  std::error_code error;
  if (folder.empty() || !fs::exists(folder, error)) return {};
  std::vector<fs::path> paths = paths_in(folder, error);
  if (error) {
    throw ReadError(ReadError::Kind::unreadable, {{.file = "the folder " + quoted_text(folder.string(), longest_path),
                                                   .what = "cannot be read: " + error.message(),
                                                   .remedy = "check its permissions",
                                                   .joint = " "}});
  }
  std::erase_if(paths, [](const fs::path& path) { return path.extension() != ".toml"; });

  std::vector<CalibrationFile> files;
  std::vector<ReadProblem> problems;
  for (const fs::path& path : paths) {
    const std::string shown = quoted_text(path.string(), longest_path);
    if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
      problems.push_back({.file = shown,
                          .what = fmt::format("is {}, but a calibration must be a file", kind),
                          .remedy = "remove it",
                          .joint = " "});
      continue;
    }
    const FileContents file = file_contents(path);
    if (file.error != 0) throw unreadable(shown, file.error);
    try {
      files.push_back({path, read(file.text, path.string())});
    } catch (const ReadError& wrong) {
      problems.insert(problems.end(), wrong.problems().begin(), wrong.problems().end());
      continue;
    }
    const auto twin = std::ranges::find(files, files.back().serial, &CalibrationFile::serial);
    if (&*twin != &files.back()) problems.push_back(twin_problem(shown, *twin));
  }
  if (!problems.empty()) throw ReadError(ReadError::Kind::wrong, problems);
  return files;
}

fs::path save_calibration(std::string_view folder_name, const DeviceSerial& serial, std::string_view name,
                          std::string_view text, const ReadCalibration& read) {
  const fs::path folder = calibration_folder(folder_name);
  if (folder.empty()) {
    throw Failure(ExitCode::file_trouble, "there is no home folder for a calibration; set HOME or XDG_CONFIG_HOME");
  }
  fs::path path = folder / (std::string(name) + ".toml");
  for (const CalibrationFile& file : read_calibrations(folder_name, read)) {
    if (file.serial == serial) path = file.path;
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Failure(ExitCode::file_trouble, fmt::format("the folder {} for calibrations cannot be created: {}",
                                                      quoted_text(folder.string(), longest_path), error.message()));
  }
  OutputFile output(path.string());
  output.write(text);
  output.commit();
  return path;
}

bool is_serial(std::string_view text) noexcept {
  return !text.empty() && text.size() <= DeviceSerial::longest && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
  });
}

void expect_serial(std::string_view text) {
  if (is_serial(text)) return;
  throw Failure(ExitCode::wrong_call,
                fmt::format("'{}' is not a serial number that a calibration could be kept under", quoted_text(text)));
}

std::function<void(const TomlValue&)> serial_into(DeviceSerial& serial) {
  return [&serial](const TomlValue& value) {
    const auto text = value.text();
    if (text && is_serial(*text)) {
      serial = *DeviceSerial::from(*text);
    } else if (text) {
      value.refuse(fmt::format("'{}' is not a serial number", quoted_text(*text)),
                   fmt::format("give 1 to {} letters, digits, '-' or '_'", DeviceSerial::longest));
    }
  };
}

}  // namespace ghostforce
