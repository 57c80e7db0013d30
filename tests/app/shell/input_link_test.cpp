// An input that only this test knows: given to the window as a row of the list, it moves the goal, shows what it has to
// show and says how it ended, and nothing else in the program has heard of it.
#include "app/shell/input_link.h"

#include <atomic>

#include "device/falcon/falcon_input.h"
#include "tests/app/shell/driven_window.h"
#include "tests/device/falcon/fake_falcons.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::input_link_test {
namespace {

// The goal is on one side until it is told to be on the other.
class Switch final : public Input {
 public:
  void restart(const Vector<2>& goal) noexcept override { start_ = goal; }
  Vector<2> goal(std::int64_t /*tick*/, double /*rate*/) noexcept override {
    return is_over_ ? Vector<2>(-start_.x, start_.y) : start_;
  }
  void turn() noexcept { is_over_ = !is_over_; }

 private:
  std::atomic<bool> is_over_ = false;
  Vector<2> start_{0.0};
};

// What the link has lived through, as the test sees it.
struct Log {
  int begun = 0;
  int samples = 0;
  int drawn = 0;
  int sent = 0;
  int ended = 0;
  bool has_news = false;
  std::string why_not_leave;
  Vector<2> button{0.0};  // the middle of the one that it draws
};

class SwitchLink final : public InputLink {
 public:
  SwitchLink(Switch& input, const Scene&, const InputOptions&, Log* log) : input_(input), log_(*log) {}
  ~SwitchLink() override { ++log_.ended; }

  void begin(Session& /*session*/) override { ++log_.begun; }
  void add(const Snapshot& /*snapshot*/) override { ++log_.samples; }
  void fill(LoopReading& reading) const override {
    reading.draw_input = [this](const PanelContext&) {
      ++log_.drawn;
      if (ImGui::Button("Turn the switch")) input_.turn();
      const ImVec2 least = ImGui::GetItemRectMin();
      const ImVec2 most = ImGui::GetItemRectMax();
      log_.button = 0.5 * Vector<2>(static_cast<double>(least.x + most.x), static_cast<double>(least.y + most.y));
    };
  }
  void send(Session& /*session*/, double /*interval_s*/) override { ++log_.sent; }
  bool is_idle() const noexcept override { return false; }
  bool has_news() const noexcept override { return log_.has_news; }
  std::string why_not_leave() override { return log_.why_not_leave; }
  EndOfRun end() const override { return {ExitCode::device_absent, "The switch is gone."}; }

 private:
  Switch& input_;
  Log& log_;
};

const InputMaker<Switch> switch_kind{{{"switch", "Switch", "The goal is on one side or on the other."}},
                                     [](const Scene&, const InputOptions&) { return std::make_unique<Switch>(); }};

class InputLinkTest : public DrivenWindow {
 protected:
  void open_with_switch(std::string input) {
    ApplicationOptions options{.inputs = portable_inputs({}), .input = std::move(input)};
    options.inputs.push_back(linked<SwitchLink>(switch_kind, &log_));
    open(options, "wall45", 1280, 1600);  // high enough for the panel Input
  }

  Log log_;
};

TEST_F(InputLinkTest, AnInputOfTheListIsChosenAndMovesTheGoal) {
  open_with_switch("mouse");
  EXPECT_EQ(log_.begun, 0);
  EXPECT_EQ(application_->reading().inputs.back().title, "Switch");
  EXPECT_EQ(application_->reading().draw_input, nullptr);
  act(ChooseInput{"switch"});
  frames(3);
  EXPECT_EQ(session().input, "switch");
  EXPECT_EQ(application_->reading().input_title, "Switch");
  EXPECT_FALSE(session().pointer_moves_goal);
  EXPECT_EQ(now().goal, session().goal);
  EXPECT_EQ(log_.begun, 1);
  EXPECT_EQ(log_.ended, 0);
}

TEST_F(InputLinkTest, WhatItShowsIsDrawnInItsPanelAndCanBeClicked) {
  open_with_switch("switch");
  frames(3);
  ASSERT_GT(log_.drawn, 0);
  EXPECT_GT(log_.sent, 0);
  EXPECT_GT(log_.samples, 0);
  const Vector<2> before = now().goal;
  ASSERT_NE(before.x, 0.0);
  click_at(log_.button.x, log_.button.y);
  EXPECT_EQ(now().goal, Vector<2>(-before.x, before.y));
}

TEST_F(InputLinkTest, KeepsTheWindowAwakeAndSaysHowItEnded) {
  open_with_switch("switch");
  session().paused = true;
  frames(10);
  EXPECT_FALSE(application_->is_idle());
  EXPECT_FALSE(application_->needs_drawing());
  log_.has_news = true;
  EXPECT_TRUE(application_->needs_drawing());
  EXPECT_EQ(application_->input_link().end().code, ExitCode::device_absent);
  act(ChooseInput{"mouse"});
  frames(10);
  EXPECT_EQ(log_.ended, 1);
  EXPECT_TRUE(session().pointer_moves_goal);
  EXPECT_TRUE(application_->is_idle());
  EXPECT_EQ(application_->input_link().end().code, ExitCode::done);
}

TEST_F(InputLinkTest, AnInputThatIsNotInTheListIsRefusedAndTheOneInUseStays) {
  open_with_switch("switch");
  act(ChooseInput{"falcon"});
  frames(2);
  EXPECT_EQ(session().input, "switch");
  EXPECT_TRUE(is_problem());
  EXPECT_NE(notice().find("falcon"), std::string::npos) << notice();
}

TEST_F(InputLinkTest, AnInputThatHasToStayStaysAndSaysWhy) {
  open_with_switch("switch");
  log_.why_not_leave = "It still pushes.";
  act(ChooseInput{"mouse"});
  frames(2);
  EXPECT_EQ(session().input, "switch");
  EXPECT_TRUE(is_problem());
  EXPECT_EQ(notice(), "It still pushes.");
  const int samples = log_.samples;
  frames(3);
  EXPECT_GT(log_.samples, samples) << "it goes on";
  log_.why_not_leave.clear();
  act(ChooseInput{"mouse"});
  frames(2);
  EXPECT_EQ(session().input, "mouse");
}

// A Falcon that is away, and that an earlier driver could not stop.
TEST_F(InputLinkTest, AFalconThatIsOwedAStopIsNotLeft) {
  FakeFalcon falcon("12PZ657E");
  falcon.unplug();
  std::int64_t now_ns = 1'000'000'000;
  const InputMaker<FalconInput> maker{
      {{"falcon", "Falcon", "A Falcon."}}, [&](const Scene& scene, const InputOptions& options) {
        return std::make_unique<FalconInput>(std::make_unique<FakeFalcons>(std::vector{&falcon}, now_ns),
                                             options.falcon, scene.view.center);
      }};
  ApplicationOptions options{.inputs = portable_inputs({}), .input = "falcon"};
  options.inputs.push_back(falcon_entry(maker, {}));
  options.input_options.falcon.debts = std::make_shared<StopDebts>();
  options.input_options.falcon.debts->add(device_serial_of(falcon.serial));
  open(options, "wall45", 1280, 720);
  act(ChooseInput{"mouse"});
  frames(2);
  EXPECT_EQ(session().input, "falcon");
  EXPECT_NE(notice().find("may still push"), std::string::npos) << notice();
  act(OpenScene{"fig1"});
  frames(2);
  EXPECT_EQ(session().scene->title, load_scene("fig1").title) << "another scene is no other input";
  EXPECT_TRUE(application_->report().motors.may_still_push);
  falcon.plug();
  for (int i = 0; i < 200 && application_->report().motors.may_still_push; ++i) frames(2);
  EXPECT_FALSE(application_->report().motors.may_still_push);
  act(ChooseInput{"mouse"});
  frames(2);
  EXPECT_EQ(session().input, "mouse");
}

// As where the display is lost, and no destructor will run.
TEST_F(InputLinkTest, IsLetGo) {
  open_with_switch("switch");
  frames(3);
  application_->stop();
  application_->let_go_of_input();
  EXPECT_EQ(log_.ended, 1);
}

// A page in a browser has no Cairo.
TEST_F(InputLinkTest, WithoutAPainterOfFilesPixelsAndNumbersCanStillBeSaved) {
  application_.reset();
  application_ =
      std::make_unique<Application>(*window_, load_scene("wall45"), ApplicationOptions{.inputs = portable_inputs({})});
  frames(2);
  const TemporaryFolder folder;
  act(SavePicture{.path = folder / "a.png"});
  act(SavePlots{.path = folder / "a.csv"});
  frames(1);
  EXPECT_FALSE(is_problem()) << notice();
  EXPECT_EQ(folder.count(), 2);
  act(SavePicture{.path = folder / "a.pdf"});
  frames(1);
  EXPECT_TRUE(is_problem());
  EXPECT_NE(notice().find(".png"), std::string::npos) << notice();
  EXPECT_EQ(folder.count(), 2);
}

}  // namespace
}  // namespace ghostforce::input_link_test
