// Looking back: the window shows a moment of the last minute as it was, and nothing but the picture goes back.
#include "app/shell/looking_back.h"

#include <limits>
#include <map>
#include <string>
#include <variant>

#include "app/files/input_file.h"
#include "app/state/key_bindings.h"
#include "core/tick.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::looking_back_test {
namespace {

class LookingBackTest : public DrivenWindow {
 protected:
  // A hand that moves for half a second.
  void move_about() {
    session().goal = {0.03, 0.03};
    frames(15);
    session().goal = {0.01, -0.02};
    frames(15);
  }
  void pause() {
    press(key::space);
    ASSERT_TRUE(session().paused);
  }
  // Looks at a moment so long before the present.
  void look_back(double by_s) {
    session().stage.looks_back_to_s = now().time_s - by_s;
    frames(2);
    ASSERT_TRUE(session().stage.looks_back_to_s.has_value());
  }
  const std::optional<double>& looks_back_to_s() { return session().stage.looks_back_to_s; }
  std::int64_t shown_tick() const { return application_->shown().snapshot.tick; }
  Vector<2> drawn_device(StrategyId id) const {
    for (const Mark& mark : screen().panes()[0].marks) {
      if (mark.role == Role::device && mark.strategy == id && std::holds_alternative<Marker>(mark.form)) {
        if (!mark.about) return std::get<Marker>(mark.form).center;
      }
    }
    ADD_FAILURE() << "no device";
    return {};
  }
  Vector<2> drawn_normal() const {
    for (const Mark& mark : screen().panes()[0].marks) {
      if (const auto* wall = std::get_if<HalfPlane>(&mark.form)) return wall->normal;
    }
    ADD_FAILURE() << "no wall";
    return {};
  }
};

TEST_F(LookingBackTest, TheCommaAndTheFullStopLandOnEachTick) {
  move_about();
  pause();
  const std::int64_t present = now().tick;
  for (int back = 1; back <= 12; ++back) {
    press(key::comma);
    ASSERT_EQ(shown_tick(), present - back);
    ASSERT_EQ(looks_back_to_s(), application_->shown().snapshot.time_s);
  }
  // Several in one frame, none lost.
  for (int k = 0; k < 5; ++k) send_key(key::comma, GLFW_PRESS, 0);
  send_key(key::period, GLFW_PRESS, 0);
  frames(10);
  EXPECT_EQ(shown_tick(), present - 16);
  for (int back = 15; back > 0; --back) {
    press(key::period);
    ASSERT_EQ(shown_tick(), present - back);
  }
  EXPECT_EQ(now().tick, present) << "no time has passed";
  press(key::period);
  EXPECT_FALSE(looks_back_to_s()) << "at the newest end";
  EXPECT_EQ(shown_tick(), present);
  EXPECT_EQ(now().tick, present);
  press(key::period);
  frames(2);
  EXPECT_EQ(now().tick, present + 1) << "and beyond, a tick of the servo";
  EXPECT_EQ(shown_tick(), present + 1);
  EXPECT_TRUE(session().paused);
}

TEST_F(LookingBackTest, TheCommaPausesFirst) {
  move_about();
  ASSERT_FALSE(session().paused);
  press(key::comma);
  EXPECT_TRUE(session().paused);
  ASSERT_TRUE(looks_back_to_s().has_value());
  EXPECT_LT(shown_tick(), now().tick);
  const std::int64_t present = now().tick;
  frames(5);
  EXPECT_EQ(now().tick, present);
}

TEST_F(LookingBackTest, StepsBeyondTheNewestAreTakenByTheServo) {
  move_about();
  pause();
  const std::int64_t present = now().tick;
  press(key::comma);
  session().ticks_through_history = 4;
  frames(3);
  EXPECT_FALSE(looks_back_to_s());
  EXPECT_EQ(now().tick, present + 3);
}

// What the picture shows must be a state that was, under the settings that it had.
TEST_F(LookingBackTest, EachTickIsSeenUnderItsOwnSettings) {
  frames(5);
  std::map<std::int64_t, double> angle_of_tick;  // as they were sent
  double angle = session().settings.wall_normal_angle;
  const auto run = [&] {
    for (int k = 0; k < 16; ++k) {
      application_->servo().step();
      angle_of_tick[application_->servo().newest().snapshot.tick] = angle;
    }
    application_->frame(frame_s);
  };
  run();
  for (int change = 0; change < 12; ++change) {
    session().settings.wall_normal_angle += 0.01;
    application_->frame(frame_s);  // sends it
    angle = session().settings.wall_normal_angle;
    run();
  }
  const Settings chosen = session().settings;
  pause();
  const std::int64_t present = now().tick;
  for (const auto& [tick, expected] : angle_of_tick) {
    ASSERT_LE(tick, present);
    const double time_s = static_cast<double>(tick) / chosen.rate;
    session().stage.looks_back_to_s = time_s + 1e-6;
    const ShownMoment shown = application_->shown();
    ASSERT_EQ(shown.snapshot.tick, tick);
    // The file's digits: what runs is what a recording can hold.
    ASSERT_NEAR(shown.settings.wall_normal_angle, expected, 1e-12) << tick;
    // Each tick's contact lies on the wall that it is shown with.
    for (const auto& each : shown.snapshot.strategies) {
      if (each.in_contact) {
        ASSERT_NEAR(depth(wall_of(shown.settings), each.contact), 0.0, 1e-9) << tick;
      }
    }
    EXPECT_EQ(session().settings, chosen);
  }
}

TEST_F(LookingBackTest, ThePictureIsOfThatMoment) {
  move_about();
  const Snapshot then = now();
  const Vector<2> normal = drawn_normal();
  const Vector<2> device = drawn_device(StrategyId::naive);
  session().settings.wall_normal_angle += 0.3;
  session().goal = {0.02, 0.03};
  frames(30);
  ASSERT_NE(drawn_normal(), normal);
  ASSERT_NE(drawn_device(StrategyId::naive), device);
  const Settings settings = session().settings;
  const Vector<2> goal = session().goal;

  look_back(now().time_s - then.time_s);
  EXPECT_EQ(application_->shown().snapshot.tick, then.tick);
  EXPECT_NEAR(glm::distance(drawn_normal(), normal), 0.0, 1e-12);
  EXPECT_EQ(drawn_device(StrategyId::naive), device);
  EXPECT_EQ(application_->shown().snapshot.goal, then.goal);
  EXPECT_TRUE(application_->shown().is_past);
  // Only in the picture.
  EXPECT_EQ(session().settings, settings);
  EXPECT_EQ(session().goal, goal);
  EXPECT_GT(now().tick, then.tick);
  const std::int64_t present = now().tick;
  frames(3);
  EXPECT_GT(now().tick, present) << "time goes on";
  EXPECT_EQ(application_->shown().snapshot.tick, then.tick);

  press(key::escape);
  EXPECT_FALSE(application_->shown().is_past);
  EXPECT_NE(drawn_normal(), normal);
}

TEST_F(LookingBackTest, ShowsTheMomentForEveryStrategy) {
  open({});
  move_about();
  look_back(0.2);
  frames(3);
  const auto tick = application_->shown().snapshot.tick;
  press(key::digit_3);
  frames(4);
  EXPECT_TRUE(looks_back_to_s());
  EXPECT_EQ(application_->shown().snapshot.tick, tick);
  EXPECT_EQ(application_->shown().settings.active, StrategyId::anisotropic);
}

TEST_F(LookingBackTest, ChangingAnythingEndsIt) {
  const auto ends = [&](const char* what, auto&& change) {
    open({});
    move_about();
    look_back(0.2);
    frames(3);
    ASSERT_TRUE(looks_back_to_s()) << "it lasts until then";
    change();
    frames(4);
    EXPECT_FALSE(looks_back_to_s()) << what;
    EXPECT_FALSE(application_->shown().is_past) << what;
  };
  ends("a setting", [&] { session().settings.stiffnesses.k_r = 321.0; });
  ends("the goal", [&] { press(key::left); });
  ends("a drag of the goal", [&] { drag(on_window({0.0, 0.0}), on_window({0.01, 0.01})); });
  ends("a reset", [&] { press(key::r); });
  ends("another scene", [&] { act(OpenScene{"fig1"}); });
  ends("another input", [&] { act(ChooseInput{"script"}); });
  ends("Esc", [&] { press(key::escape); });
  ends("another mode", [&] { press(key::y); });
  ends("leaving its mode", [&] {
    press(key::h);
    EXPECT_TRUE(looks_back_to_s()) << "entering it does not end it";
    press(key::h);
  });
  ends("a moment that is not past", [&] { session().stage.looks_back_to_s = 1e9; });
  ends("no moment", [&] { session().stage.looks_back_to_s = std::numeric_limits<double>::quiet_NaN(); });
}

TEST_F(LookingBackTest, BothFacesLookAtOneMoment) {
  move_about();
  press(key::h);
  look_back(0.2);
  const std::optional<double> moment = looks_back_to_s();
  for (int i = 0; i < 3; ++i) {
    press(key::f4);
    EXPECT_EQ(looks_back_to_s(), moment) << i;
    EXPECT_TRUE(application_->shown().is_past);
  }
}

// After a reset the last minute begins with the scripted hand, which came from outside the picture.
TEST_F(LookingBackTest, TheStageShowsTheHandThatWas) {
  open({.face = Face::stage});
  press(key::r, modifier::alt);
  press(key::h);
  frames(20);
  const auto is_seen = [&](const Vector<2>& place) {
    const StagePicture& picture = screen().stage().picture();
    return contains(picture.scene, to_screen(picture.pane.camera, place));
  };
  for (const double by_s : {0.5, 1.2, 2.0, 2.9}) {
    look_back(by_s);
    frames(60);
    EXPECT_TRUE(is_seen(application_->shown().snapshot.goal)) << by_s;
    EXPECT_TRUE(is_seen(session().goal)) << by_s;
  }
}

TEST_F(LookingBackTest, SpaceAndEscGoOnLive) {
  for (const int key : {key::space, key::escape}) {
    open({});
    move_about();
    press(key::comma);
    ASSERT_TRUE(looks_back_to_s());
    const std::int64_t present = now().tick;
    press(key);
    EXPECT_FALSE(looks_back_to_s());
    EXPECT_FALSE(session().paused);
    EXPECT_GT(now().tick, present);
    // Not paused before either: it goes on, and does not stop.
    look_back(0.1);
    press(key);
    EXPECT_FALSE(looks_back_to_s());
    EXPECT_FALSE(session().paused);
  }
  press(key::space);
  press(key::escape);
  EXPECT_TRUE(session().paused) << "Esc is no way out of a pause";
}

TEST_F(LookingBackTest, EscClosesWhatIsOpenFirst) {
  move_about();
  look_back(0.1);
  press(key::f1);
  press(key::escape);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_TRUE(looks_back_to_s());
  press(key::escape);
  EXPECT_FALSE(looks_back_to_s());
}

TEST_F(LookingBackTest, WhatIsOlderThanAllIsTheOldest) {
  move_about();
  session().stage.looks_back_to_s = -100.0;
  frames(2);
  const auto oldest = application_->history().moments().oldest();
  ASSERT_TRUE(oldest);
  EXPECT_EQ(looks_back_to_s(), oldest->snapshot.time_s);
  EXPECT_EQ(shown_tick(), oldest->snapshot.tick);
  press(key::comma);
  EXPECT_EQ(shown_tick(), oldest->snapshot.tick) << "there is nothing before it";
}

// The same hand twice; once somebody looks back meanwhile, by the pause as by scrubbing.
TEST_F(LookingBackTest, ServoAndRecordingKnowNothingOfIt) {
  const TemporaryFolder folder;
  const auto visit = [&](const std::string& path, bool looks_back) {
    open({.record = path});
    const auto scrub = [&](double by_s) {
      if (looks_back) session().stage.looks_back_to_s = now().time_s - by_s;
    };
    session().goal = {0.03, 0.03};
    for (int k = 0; k < 20; ++k) {
      scrub(0.01 * k);
      frames(1);
    }
    session().settings.wall_normal_angle += 0.2;
    frames(20);
    press(key::space);
    for (int k = 0; k < 10; ++k) {
      looks_back ? press(key::comma) : frames(3);
    }
    if (looks_back) {
      EXPECT_EQ(shown_tick(), now().tick - 10);
    }
    press(key::space);
    EXPECT_FALSE(session().paused);
    session().settings.active = StrategyId::naive;
    frames(20);
    scrub(0.3);
    frames(20);
    act(StopRecording{});
    frames(2);
    return now();
  };
  const Snapshot without = visit(folder / "without.csv", false);
  const Snapshot with = visit(folder / "with.csv", true);
  EXPECT_EQ(with.tick, without.tick);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_EQ(with.strategies[i].device, without.strategies[i].device);
  }
  const std::string recorded = read_whole(folder / "without.csv");
  EXPECT_GT(recorded.size(), 100'000U);
  EXPECT_EQ(read_whole(folder / "with.csv"), recorded);
}

// A window at rest that somebody looks back in need not be drawn again and again.
TEST_F(LookingBackTest, APausedWindowStaysIdle) {
  move_about();
  press(key::comma);
  // Words may first find better places.
  for (int i = 0; i < 240 && application_->needs_drawing(); ++i) frames(1);
  EXPECT_TRUE(application_->is_idle());
  EXPECT_FALSE(application_->needs_drawing());
  const Image before = picture();
  frames(5);
  EXPECT_EQ(picture(), before);
}

TEST_F(LookingBackTest, ThePlotsShowTheMoment) {
  press(key::f3);
  move_about();
  PlotView& plots = session().plots;
  look_back(0.1);
  EXPECT_LE(plots.from_s, *looks_back_to_s());
  EXPECT_GE(plots.to_s, *looks_back_to_s());
  const Image nearer = picture();
  plots.to_s = plots.from_s + 0.2;
  press(key::comma);
  session().stage.looks_back_to_s = now().time_s - 0.7;
  frames(3);
  EXPECT_LE(plots.from_s, *looks_back_to_s()) << "brought into sight";
  EXPECT_GE(plots.to_s, *looks_back_to_s());
  EXPECT_NEAR(plots.span_s(), 0.2, 1e-9);
  EXPECT_NE(picture(), nearer);
  press(key::space);
  frames(2);
  EXPECT_EQ(plots.to_s, application_->history().plots().newest_s());
}

TEST_F(LookingBackTest, AClickInThePlotsLooksAtItsTime) {
  press(key::f3);
  move_about();
  const double top = static_cast<double>(screen().scene_corner().y) + screen().scene_size().y;
  drag({200.0, top + 100.0}, {320.0, top + 100.0});
  EXPECT_FALSE(looks_back_to_s()) << "a drag only chooses the times in sight";
  click_at(200.0, top + 100.0);
  ASSERT_TRUE(looks_back_to_s());
  ASSERT_TRUE(session().plots.cursor_s);
  EXPECT_EQ(*looks_back_to_s(), *session().plots.cursor_s);
  EXPECT_TRUE(application_->shown().is_past);
  click_at(713.0, top + 20.0);  // "Live"
  EXPECT_FALSE(looks_back_to_s());
}

}  // namespace
}  // namespace ghostforce::looking_back_test
