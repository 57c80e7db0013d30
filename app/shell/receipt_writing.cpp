#include "app/shell/receipt_writing.h"

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/output_file.h"
#include "app/picture/theme.h"

namespace ghostforce {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<SessionLog::Event>& events) {
  Json list = Json::array();
  for (const SessionLog::Event& event : events) list.push_back({{"t_s", event.time_s}, {"name", event.name}});
  return list;
}

Json json_of(const DeviceFacts& device) {
  return {{"name", device.name},
          {"serial", device.serial},
          {"is_simulated", device.is_simulated},
          {"calibration", {{"is_its_own", device.has_own_calibration}, {"text", device.calibration}}},
          {"exchanges", device.exchanges},
          {"lost_exchanges", device.lost_exchanges},
          {"discarded_bytes", device.discarded_bytes},
          {"line_errors", device.line_errors}};
}

// The first and the last bin have one end.
Json json_of(const LoopPeriods& periods) {
  Json list = Json::array();
  for (std::size_t bin = 0; bin < LoopPeriods::bin_count; ++bin) {
    if (periods.count(bin) == 0) continue;
    list.push_back({{"from_s", bin > 0 ? Json(LoopPeriods::begin_of(bin)) : Json()},
                    {"to_s", bin + 1 < LoopPeriods::bin_count ? Json(LoopPeriods::begin_of(bin + 1)) : Json()},
                    {"ticks", periods.count(bin)}});
  }
  return list;
}

Json json_of(const std::optional<SessionLog::Hand>& hand) {
  if (!hand) return nullptr;
  return {{"t_s", hand->time_s}, {"k_u_N_per_m", hand->estimate.k_u}, {"sigma_N_per_m", hand->estimate.sigma}};
}

}  // namespace

std::string receipt_json(const Receipt& receipt) {
  const ReceiptOrigin& origin = receipt.origin;
  const LoopPeriods& periods = receipt.periods;
  const auto or_null = [](const std::string& words) { return words.empty() ? Json() : Json(words); };
  Json heat;
  if (receipt.device) {
    heat = {{"greatest", receipt.log.greatest_heat()},
            {"is_measured", false},
            {"continuous_share", motor_continuous_share},
            {"time_constant_s", motor_heat_time_constant_s}};
  }
  const Json all{
      {"format", Receipt::format},
      {"program",
       {{"version", origin.version},
        {"commit", or_null(origin.commit)},
        {"build", origin.build},
        {"libraries", origin.libraries}}},
      {"recording", {{"file", receipt.recording}, {"seconds", receipt.seconds}, {"samples_lost", receipt.dropped}}},
      {"input", receipt.input},
      {"device", receipt.device ? json_of(*receipt.device) : Json()},
      {"firmware_file", or_null(origin.firmware)},
      {"settings",
       {{"set_up", receipt.set_up},
        {"scene", receipt.scene},
        {"force_limit_N", receipt.safety.force_limit},
        {"greatest_k_r_N_per_m", receipt.safety.greatest_k_r},
        {"needs_button", receipt.safety.needs_button}}},
      {"hand", {{"believed_k_u_N_per_m", receipt.believed_k_u}, {"measured", json_of(receipt.log.hand())}}},
      {"motors_off", json_of(receipt.log.motors_off())},
      {"device_faults", json_of(receipt.log.device_faults())},
      {"rates",
       {{"asked_hz", receipt.rate_hz},
        {"mean_hz", periods.mean_hz()},
        {"ticks", periods.ticks()},
        {"late_ticks", periods.late_ticks()},
        {"worst_period_s", periods.worst_s()},
        {"histogram", json_of(periods)},
        {"real_time", receipt.real_time}}},
      {"heat", heat},
  };
  return all.dump(2) + "\n";
}

void write_receipt(const Receipt& receipt, const FilePainter& painter, const std::string& recording) {
  const std::filesystem::path path(recording);
  const std::string stem =
      path.extension() == ".csv" ? std::filesystem::path(path).replace_extension().string() : recording;
  const std::array paths{stem + ".receipt.json", stem + ".receipt.pdf"};
  for (const std::string& each : paths) {
    std::error_code ignored;
    if (std::filesystem::exists(std::filesystem::symlink_status(each, ignored))) {
      throw Failure(ExitCode::file_trouble,
                    fmt::format("{} already exists, and a receipt never overwrites a file; record under another name",
                                quoted_text(each, longest_path)));
    }
  }
  const std::vector<Pane> page = receipt_sheet(receipt, painter.measure);
  const std::array contents{
      receipt_json(receipt),
      painter.paint({.panes = page, .theme = paper(), .size = receipt_sheet_size, .title = receipt.set_up}, paths[1])};
  std::deque<OutputFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) files.emplace_back(paths[i]).write(contents[i]);
  OutputFile::commit_all(files);
}

}  // namespace ghostforce
