// The receipt of a session: what it tells, as values, as JSON and on its page; and that it is written beside a
// recording, whole or not at all.
#include "app/shell/receipt.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/camera.h"
#include "app/shell/receipt_writing.h"
#include "app/state/set_up.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::receipt_test {
namespace {

using Json = nlohmann::json;

ServoReport report_at(double time_s) {
  ServoReport report;
  report.snapshot.time_s = time_s;
  return report;
}

TEST(SessionLog, KeepsEachReasonAndFaultWithTheTimeWhenItBegan) {
  SessionLog log;
  ServoReport report = report_at(1.0);
  log.note(report, "");
  for (const auto& [time_s, reason, fault] :
       std::vector<std::tuple<double, OffReason, std::string_view>>{{2.0, OffReason::key, ""},
                                                                    {2.1, OffReason::key, ""},
                                                                    {3.0, OffReason::none, "unplugged"},
                                                                    {3.1, OffReason::too_fast, "unplugged"},
                                                                    {4.0, OffReason::none, ""},
                                                                    {5.0, OffReason::too_fast, "busy"}}) {
    report.snapshot.time_s = time_s;
    report.motors.reason = reason;
    log.note(report, fault);
  }
  const auto text_of = [](const std::vector<SessionLog::Event>& events) {
    std::string text;
    for (const SessionLog::Event& event : events) text += fmt::format("{} {} ", event.time_s, event.name);
    return text;
  };
  EXPECT_EQ(text_of(log.motors_off()), "2 key 3.1 too_fast 5 too_fast ");
  EXPECT_EQ(text_of(log.device_faults()), "3 unplugged 5 busy ");
}

TEST(SessionLog, KeepsTheHandThatWasKnownLastAndTheGreatestHeatOfEachMotor) {
  SessionLog log;
  ServoReport report = report_at(1.0);
  log.note(report, "");
  EXPECT_FALSE(log.hand());
  report.hand = {.estimate = {.why = HandUnknown::none, .k_u = 310.0, .sigma = 25.0}, .at_s = 0.9};
  report.motors.heat = {0.5, 0.25, 0.0};
  log.note(report, "");
  report.hand.estimate = {.why = HandUnknown::no_contact};
  report.motors.heat = {0.25, 0.5, 0.125};
  log.note(report, "");
  ASSERT_TRUE(log.hand());
  EXPECT_EQ(log.hand()->estimate.k_u, 310.0);
  EXPECT_EQ(log.hand()->time_s, 0.9);
  EXPECT_EQ(log.greatest_heat(), (MotorHeats{0.5, 0.5, 0.125}));
}

Receipt full_receipt() {
  Receipt receipt{
      .origin = {"1.2.3", "abc1234", "Release, some compiler", "some libraries 4.5", "file.bin, SHA-256 00"},
      .recording = "visit.csv",
      .seconds = 12.5,
      .dropped = 3,
      .input = "falcon",
      .device = DeviceFacts{.name = "Falcon", .serial = "12PZ657E", .calibration = "# a remark\nscale = 1\n"},
      .set_up = "ghostforce run wall45",
      .scene = "format = 1\n",
      .rate_hz = 1000.0,
      .believed_k_u = 200.0,
      .real_time = "real-time priority"};
  for (int tick = 0; tick < 999; ++tick) receipt.periods.add(0.001, false);
  receipt.periods.add(1.0, true);
  ServoReport report = report_at(2.0);
  report.hand = {.estimate = {.why = HandUnknown::none, .k_u = 310.0, .sigma = 25.0}, .at_s = 1.5};
  report.motors.reason = OffReason::over_force;
  report.motors.heat = {0.5, 0.25, 0.125};
  receipt.log.note(report, "unplugged");
  return receipt;
}

TEST(Receipt, TellsAllOfItAsJson) {
  const Json json = Json::parse(receipt_json(full_receipt()));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["program"], Json::parse(R"({"version": "1.2.3", "commit": "abc1234", "build": "Release, some compiler",
                                             "libraries": "some libraries 4.5"})"));
  EXPECT_EQ(json["recording"], Json::parse(R"({"file": "visit.csv", "seconds": 12.5, "samples_lost": 3})"));
  EXPECT_EQ(json["device"]["serial"], "12PZ657E");
  EXPECT_EQ(json["device"]["calibration"]["text"], "# a remark\nscale = 1\n");
  EXPECT_EQ(json["firmware_file"], "file.bin, SHA-256 00");
  EXPECT_EQ(json["settings"]["set_up"], "ghostforce run wall45");
  EXPECT_EQ(json["settings"]["force_limit_N"], SafetyOptions{}.force_limit);
  EXPECT_EQ(json["hand"], Json::parse(R"({"believed_k_u_N_per_m": 200.0,
                                          "measured": {"t_s": 1.5, "k_u_N_per_m": 310.0, "sigma_N_per_m": 25.0}})"));
  EXPECT_EQ(json["motors_off"], Json::parse(R"([{"t_s": 2.0, "name": "over_force"}])"));
  EXPECT_EQ(json["device_faults"], Json::parse(R"([{"t_s": 2.0, "name": "unplugged"}])"));
  const Json& rates = json["rates"];
  EXPECT_EQ(rates["ticks"], 1000);
  EXPECT_EQ(rates["late_ticks"], 1);
  EXPECT_EQ(rates["worst_period_s"], 1.0);
  EXPECT_NEAR(rates["mean_hz"].get<double>(), 1000.0 / 1.999, 1e-9);
  ASSERT_EQ(rates["histogram"].size(), 2U) << "empty bins are left out";
  EXPECT_EQ(rates["histogram"][0]["ticks"], 999);
  EXPECT_LT(rates["histogram"][0]["from_s"].get<double>(), 0.001);
  EXPECT_GT(rates["histogram"][0]["to_s"].get<double>(), 0.001);
  EXPECT_TRUE(rates["histogram"][1]["to_s"].is_null()) << "the last has no end";
  EXPECT_EQ(json["heat"]["greatest"], Json::parse("[0.5, 0.25, 0.125]"));
  EXPECT_EQ(json["heat"]["is_measured"], false);
}

TEST(Receipt, OfAnInputWithoutADeviceHasNone) {
  Receipt receipt = full_receipt();
  receipt.device.reset();
  receipt.log = {};
  const Json json = Json::parse(receipt_json(receipt));
  EXPECT_TRUE(json["device"].is_null());
  EXPECT_TRUE(json["heat"].is_null());
  EXPECT_TRUE(json["hand"]["measured"].is_null());
  EXPECT_TRUE(json["motors_off"].empty());
}

std::string words_on(const std::vector<Pane>& panes) {
  std::string words;
  for (const Pane& pane : panes) {
    for (const Mark& mark : pane.marks) {
      if (const auto* const label = std::get_if<Label>(&mark.form)) words += label->text + "\n";
    }
  }
  return words;
}

// All in sight, however much there is to tell.
void expect_on_page(const std::vector<Pane>& panes) {
  for (const Pane& pane : panes) {
    for (const Mark& mark : pane.marks) {
      const auto* const label = std::get_if<Label>(&mark.form);
      if (label == nullptr) continue;
      const Vector<2> least = pane.corner + to_screen(pane.camera, label->anchor) + label->offset;
      const Vector<2> most = least + measure_vector_text(label->text, label->style);
      EXPECT_GE(least.x, 0.0) << label->text;
      EXPECT_GE(least.y, 0.0) << label->text;
      EXPECT_LE(most.x, receipt_sheet_size.x) << label->text;
      EXPECT_LE(most.y, receipt_sheet_size.y) << label->text;
    }
  }
}

TEST(ReceiptPage, SaysItInWordsWithAChartOfThePeriods) {
  const std::vector<Pane> panes = receipt_sheet(full_receipt(), measure_vector_text);
  ASSERT_EQ(panes.size(), 2U);
  expect_on_page(panes);
  const std::string words = words_on(panes);
  for (const char* const some :
       {"visit.csv", "1.2.3", "some libraries 4.5", "Falcon 12PZ657E", "scale = 1", "over_force", "unplugged",
        "310 ± 25 N/m", "50 %, 25 % and 12 %", "ghostforce run wall45", "period [ms]"}) {
    EXPECT_NE(words.find(some), std::string::npos) << some << "\n" << words;
  }
  EXPECT_EQ(words.find("a remark"), std::string::npos);
}

TEST(ReceiptPage, SaysWhereTheRestIsIfThereIsNoRoom) {
  Receipt receipt = full_receipt();
  ServoReport report = report_at(3.0);
  for (int i = 0; i < 300; ++i) {
    report.motors.reason = i % 2 == 0 ? OffReason::none : OffReason::too_fast;
    receipt.log.note(report, i % 2 == 0 ? "busy" : "unplugged");
  }
  for (int i = 0; i < 1000; ++i) receipt.set_up += " --set wall.normal_deg=120";
  const std::vector<Pane> panes = receipt_sheet(receipt, measure_vector_text);
  expect_on_page(panes);
  EXPECT_NE(words_on(panes).find("… the rest is in the JSON file"), std::string::npos);
  EXPECT_NE(words_on(panes).find("Device faults"), std::string::npos) << "long rows leave room for the others";
}

class ReceiptWindow : public DrivenWindow {
 protected:
  void open_with_receipts() { open({.receipt_origin = origin}); }
  void record(const std::string& path) {
    act(StartRecording{path});
    frames(2);
  }
  void stop() {
    act(StopRecording{});
    frames(2);
  }
  Json receipt() const { return Json::parse(read_whole(folder_ / "run.receipt.json")); }

  const ReceiptOrigin origin{.version = "1.2.3", .build = "some compiler", .libraries = "libraries"};
  TemporaryFolder folder_;
};

TEST_F(ReceiptWindow, LiesBesideTheRecordingAndIsTheSameOnEveryRun) {
  std::vector<std::string> seen;
  for (const std::string name : {"run", "other"}) {
    open_with_receipts();
    record(folder_ / name + ".csv");
    act(ChooseStrategy{StrategyId::anisotropic});
    frames(30);
    stop();
    EXPECT_NE(notice().find(".csv. Its receipt is beside it."), std::string::npos) << notice();
    EXPECT_FALSE(is_problem());
    std::string json = read_whole(folder_ / name + ".receipt.json");
    json.replace(json.find(name + ".csv"), name.size() + 4, "FILE");
    seen.push_back(json);
    EXPECT_TRUE(read_whole(folder_ / name + ".receipt.pdf").starts_with("%PDF-"));
  }
  EXPECT_EQ(folder_.count(), 6);
  EXPECT_EQ(seen[0], seen[1]);
  const Json json = receipt();
  EXPECT_EQ(json["input"], "mouse");
  EXPECT_NEAR(json["recording"]["seconds"].get<double>(),
              static_cast<double>(load_run(folder_ / "run.csv").ticks.size()) / 1000.0, 1e-9);
  EXPECT_EQ(read_set_up_line(json["settings"]["set_up"].get<std::string>()).scene.settings.active,
            StrategyId::anisotropic);
  EXPECT_EQ(read_scene(json["settings"]["scene"].get<std::string>(), "receipt").settings.active,
            StrategyId::anisotropic);
  EXPECT_EQ(json["rates"]["ticks"], 0) << "no time was measured, for the test made the ticks";
}

TEST_F(ReceiptWindow, OverwritesNothingAndLosesNoRecording) {
  for (const std::string there : {"run.receipt.json", "run.receipt.pdf"}) {
    const TemporaryFolder folder;
    write_whole(folder / there, "precious");
    open_with_receipts();
    record(folder / "run.csv");
    frames(10);
    stop();
    EXPECT_NE(notice().find("Its receipt could not be written: "), std::string::npos) << notice();
    EXPECT_NE(notice().find(there), std::string::npos) << notice();
    EXPECT_TRUE(is_problem());
    EXPECT_EQ(application_->recording_problem(), notice());
    EXPECT_EQ(read_whole(folder / there), "precious");
    EXPECT_GT(load_run(folder / "run.csv").ticks.size(), 100U);
    EXPECT_EQ(folder.count(), 2) << "not one of the two without the other";
  }
}

TEST_F(ReceiptWindow, TellsTheDeviceThatPushed) {
  open_virtual_falcon({.receipt_origin = origin});
  const auto state = [&] { return application_->report().motors.state; };
  record(folder_ / "run.csv");
  lead_to({-0.015, 0.015});
  act(ArmMotors{});
  ASSERT_TRUE(frames_until(5.0, [&] { return state() == SafetyState::on; }));
  lead_to({0.012, -0.012});
  const double heat = std::ranges::max(application_->report().motors.heat);
  const double before_s = now().time_s;
  act(Escape{});
  ASSERT_TRUE(frames_until(1.0, [&] { return state() == SafetyState::off; }));
  stop();
  const Json json = receipt();
  EXPECT_EQ(json["input"], "virtual-falcon");
  EXPECT_EQ(json["device"]["is_simulated"], true);
  EXPECT_EQ(json["device"]["serial"].get<std::string>(), virtual_falcon().report().serial.text());
  EXPECT_EQ(json["device"]["calibration"]["is_its_own"], false);
  EXPECT_NE(json["device"]["calibration"]["text"].get<std::string>().find("gear_ratio = "), std::string::npos);
  EXPECT_GT(json["device"]["exchanges"].get<int>(), 1000);
  ASSERT_EQ(json["motors_off"].size(), 1U) << json["motors_off"];
  EXPECT_EQ(json["motors_off"][0]["name"], "key");
  EXPECT_NEAR(json["motors_off"][0]["t_s"].get<double>(), before_s, 0.25);
  double greatest = 0.0;
  for (const Json& each : json["heat"]["greatest"]) greatest = std::max(greatest, each.get<double>());
  EXPECT_GT(heat, 0.001);
  EXPECT_GE(greatest, heat);
}

}  // namespace
}  // namespace ghostforce::receipt_test
