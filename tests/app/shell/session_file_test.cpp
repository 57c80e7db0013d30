// Sessions as files: every Action comes back as it was, and what is wrong is told with its place.
#include "app/shell/session_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/shell/action_text.h"
#include "tests/support/places.h"
#include "tests/support/shrink.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::session_file_test {
namespace {

// Of each type that a field can have at least two, as they are written.
const std::vector<std::string> values{"-7",
                                      "7",
                                      "37",
                                      "0.30000000000000004",
                                      "inf",
                                      "-1e-300,inf",
                                      "0.1,-0.2",
                                      "0.1,-0.2,naive",
                                      "none",
                                      "yes",
                                      "no",
                                      "'a b.toml' 'it'\\''s.png' '\"c\".csv'",
                                      "anisotropic",
                                      "naive",
                                      "stage",
                                      "workbench",
                                      "ribbon",
                                      "overlay",
                                      "active-only",
                                      "full",
                                      "reduced",
                                      "circle-middle",
                                      "circle-edge",
                                      "first",
                                      "both",
                                      "over-ratio",
                                      "hand-over-time",
                                      "help",
                                      "save-clip",
                                      "typed",
                                      "live",
                                      "position",
                                      "speed",
                                      "lifting",
                                      "pushing-away",
                                      "predictions",
                                      "trails",
                                      "dark",
                                      "projector",
                                      "it's \"a\" \\ name=\t\n\x01 with ñ"};

std::string start() {
  return start_line({.program = "1.2.3", .scene = "format = 1\n"});
}

// Empty: all is well.
std::string problems_of(const std::string& text) {
  try {
    read_session(text, "F");
    return {};
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
}

// Those of `values` that a field can be. Each is written as it was read.
std::vector<std::string> possible_values(const ActionKind& kind, const LineField& field) {
  std::vector<std::string> possible;
  Action action = kind.make();
  for (const std::string& value : values) {
    if (!field.read(value, object_of(action))) continue;
    EXPECT_EQ(field.text(object_of(action)), value) << kind.line.name << ' ' << field.name;
    possible.push_back(value);
  }
  return possible;
}

void expect_comes_back(const ActionKind& kind, const std::vector<std::string>& told) {
  const auto fields = kind.line.fields();
  Action done = kind.make();
  for (std::size_t i = 0; i < fields.size(); ++i) ASSERT_TRUE(fields[i].read(told[i], object_of(done)));
  const std::string line = action_line({0.1, done});
  const RecordedSession back = read_session(start() + line, "F");
  ASSERT_EQ(back.actions.size(), 1U) << line;
  EXPECT_EQ(back.actions[0].time_s, 0.1);
  EXPECT_EQ(action_line(back.actions[0]), line);
  const Action& read = back.actions[0].action;
  ASSERT_EQ(read.index(), done.index()) << line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    EXPECT_EQ(fields[i].text(object_of(read)), told[i]) << line << fields[i].name;
}

TEST(SessionFile, EveryActionComesBackWithEveryField) {
  for (const ActionKind& kind : action_kinds()) {
    std::vector<std::vector<std::string>> possible;
    for (const LineField& field : kind.line.fields()) {
      possible.push_back(possible_values(kind, field));
      ASSERT_GE(possible.back().size(), 2U) << kind.line.name << ' ' << field.name << ": " << field.type->wanted();
    }
    // Fields of one type have different values in each round.
    for (std::size_t round = 0; round < values.size(); ++round) {
      std::vector<std::string> told;
      for (const std::vector<std::string>& each : possible) told.push_back(each[(round + told.size()) % each.size()]);
      expect_comes_back(kind, told);
    }
  }
}

TEST(SessionFile, WhatALineSaysIsWhatIsDone) {
  const RecordedSession session = read_session(start() +
                                                   "1 move-hand-to goal=0.1,-0.2\n"
                                                   "1 zoom-view factor=2 place=0.1,-0.2,naive\n"
                                                   "1 toggle-mode mode=ribbon\n"
                                                   "1 change-plots is-open=yes tab=hand-over-time follows=no from=1 "
                                                   "to=2 cursor=3\n"
                                                   "1 drop-files paths=\"'a b.toml' c.csv\"\n",
                                               "F");
  ASSERT_EQ(session.actions.size(), 5U);
  const auto& done = session.actions;
  EXPECT_EQ(std::get<MoveHandTo>(done[0].action).goal, Vector<2>(0.1, -0.2));
  const ZoomView zoom = std::get<ZoomView>(done[1].action);
  EXPECT_EQ(zoom.factor, 2.0);
  ASSERT_TRUE(zoom.place);
  EXPECT_EQ(zoom.place->at, Vector<2>(0.1, -0.2));
  EXPECT_EQ(zoom.place->pane, StrategyId::naive);
  EXPECT_EQ(std::get<ToggleMode>(done[2].action).mode, StageMode::ribbon);
  const PlotView plots = std::get<ChangePlots>(done[3].action).after;
  EXPECT_TRUE(plots.is_open);
  EXPECT_FALSE(plots.follows);
  EXPECT_EQ(plots.tab, PlotTab::hand);
  EXPECT_EQ(plots.from_s, 1.0);
  EXPECT_EQ(plots.to_s, 2.0);
  EXPECT_EQ(plots.cursor_s, 3.0);
  EXPECT_EQ(std::get<DropFiles>(done[4].action).paths, (std::vector<std::string>{"a b.toml", "c.csv"}));
}

TEST(SessionFile, TheDocumentationNamesEveryAction) {
  const std::string page = read_whole(source_path("/docs/sessions.md"));
  for (const ActionKind& kind : action_kinds()) {
    std::string row = "`" + std::string(kind.line.name);
    for (const LineField& field : kind.line.fields()) row += fmt::format(" {}=", field.name);
    EXPECT_NE(page.find(row + "`"), std::string::npos) << "docs/sessions.md lacks " << row;
  }
}

TEST(SessionFile, EveryNameOfACatalogComesBack) {
  std::string text = start();
  std::vector<TimedAction> actions;
  for (const Strategy& each : strategy_catalog()) actions.push_back({1.0, ChooseByNumber{each.id}});
  for (const FaceEntry& each : face_catalog) actions.push_back({1.0, ShowFace{each.id}});
  for (const StageModeEntry& each : stage_mode_catalog()) actions.push_back({1.0, ToggleMode{each.id}});
  for (int i = 0; i <= static_cast<int>(Dialog::reset_preferences); ++i)
    actions.push_back({1.0, OpenDialog{static_cast<Dialog>(i)}});
  for (const auto source : {BeliefSource::typed, BeliefSource::measured, BeliefSource::live})
    actions.push_back({1.0, Believe{source, {}}});
  for (const auto option : {&ViewOptions::ghost_forces, &ViewOptions::predictions, &ViewOptions::trails})
    actions.push_back({1.0, ToggleViewOption{option}});
  for (const TimedAction& each : actions) text += action_line(each);
  const RecordedSession back = read_session(text, "F");
  ASSERT_EQ(back.actions.size(), actions.size());
  for (std::size_t i = 0; i < actions.size(); ++i) EXPECT_EQ(action_line(back.actions[i]), action_line(actions[i]));
  EXPECT_EQ(text.find("= ", start().size()), std::string::npos) << "a name is missing";
}

TEST(SessionFile, HowItBeganComesBack) {
  const SessionStart start{.program = "1.2",
                           .input = "virtual-falcon",
                           .face = Face::workbench,
                           .mode = StageMode::why,
                           .lesson = "my lesson.toml",
                           .language = "es",
                           .width = 1000,
                           .height = 700,
                           .scene = "title = \"a\"\n# \\ \n"};
  const RecordedSession session{start, {{0.5, TogglePause{}}}, 2.5};
  const RecordedSession back = read_session(session_text(session), "F");
  EXPECT_EQ(start_line(back.start), start_line(start));
  EXPECT_EQ(back.start.scene, start.scene);
  EXPECT_EQ(back.start.lesson, start.lesson);
  EXPECT_EQ(back.end_s, 2.5);
}

// As a program that has crashed leaves it.
TEST(SessionFile, WithoutItsEndItEndsWithTheLastAction) {
  EXPECT_EQ(read_session(start() + "0.25 undo\n", "F").end_s, 0.25);
  EXPECT_EQ(read_session(start(), "F").end_s, 0.0);
}

TEST(SessionFile, WhatIsWrongIsToldWithItsPlace) {
  struct Wrong {
    std::string lines;  // after the first
    std::string told;
  };
  for (const Wrong& wrong : {
           Wrong{"1 fly\n", "F:2:3: 'fly' is nothing that can be done; name an action"},
           Wrong{"1 toggle-paus\n", "did you mean 'toggle-pause'?"},
           Wrong{"1 turn-wall-to\n", "F:2:3: turn-wall-to lacks angle; add angle=…, a number"},
           Wrong{"1 turn-wall-to angle=1 angle=2\n", "F:2:24: angle is given twice; remove one"},
           Wrong{"1 turn-wall-to angle=1 angel=2\n",
                 "F:2:24: turn-wall-to has no 'angel'; remove it; did you mean 'angle'?"},
           Wrong{"1 look-back-to time=yes\n", "F:2:16: time is 'yes'; give a number, or none"},
           Wrong{"1 turn-wall-to angle=nan\n", "F:2:16: angle is 'nan'; give a number"},
           Wrong{"1 turn-wall-to angle\n", "turn-wall-to has no 'angle'"},
           Wrong{"1 turn-wall-to angle=\"1\n", "F:2:22: the quote is not closed"},
           Wrong{"1 save-scene path=\"a\\qb\"\n", "F:2:21: after this backslash"},
           Wrong{"1 save-scene path=\"a\"b\n", "F:2:22: something follows the quote"},
           Wrong{"1 move-hand-to goal=1\n", "F:2:16: goal is '1'; give two numbers with a comma"},
           Wrong{"1 choose-by-number id=best\n", "give one of full, naive, anisotropic"},
           Wrong{"1 drop-files paths=\"\"\n", "give one or more words"},
           Wrong{"nan undo\n", "F:2:1: 'nan' is not a time"},
           Wrong{"inf undo\n", "F:2:1: 'inf' is not a time"},
           Wrong{"-1 undo\n", "F:2:1: '-1' is not a time"},
           Wrong{"undo\n", "F:2:1: 'undo' is not a time"},
           Wrong{"2 undo\n1.5 redo\n", "F:3:1: the time goes back, from 2 s to 1.5 s; put the lines in their order"},
           Wrong{"2\n", "F:2:1: the line has a time alone"},
           Wrong{"\n", "F:2:1: the line is empty; remove it"},
           Wrong{"2 end\n3 undo\n", "F:3:1: something follows the end"},
           Wrong{"2 undo", "F:2:7: the file ends within this line"},
       }) {
    EXPECT_NE(problems_of(start() + wrong.lines).find(wrong.told), std::string::npos)
        << wrong.lines << problems_of(start() + wrong.lines);
  }
  EXPECT_EQ(problems_of(start() + "1 undo\n"), "");
}

TEST(SessionFile, AllThatIsWrongIsToldAtOnce) {
  const std::string told = problems_of(start() + "1 fly\n2 swim far=1\n1 undo\n");
  for (const char* const place : {"F:2:3", "F:3:3", "F:4:1"}) EXPECT_NE(told.find(place), std::string::npos) << told;
}

TEST(SessionFile, OnlyASessionIsRead) {
  EXPECT_NE(problems_of("").find("F: the file is empty"), std::string::npos);
  EXPECT_NE(problems_of("strategy,t_s\n").find("F:1:1: this is no recorded session"), std::string::npos);
  const std::string newer = problems_of("ghostforce-session format=2 wings=4\n1 fly\n");
  EXPECT_NE(newer.find("F:1:20: the format 2 is not known"), std::string::npos) << newer;
  EXPECT_EQ(newer.find('\n'), std::string::npos) << newer;
  std::string small = start();
  small.replace(small.find("width=1280"), 10, "width=0");
  EXPECT_NE(problems_of(small).find("no window has 0×800 points"), std::string::npos);
}

TEST(Shrink, FindsTheTwoOfFiveHundredThatItTakes) {
  std::vector<int> all(500);
  for (int i = 0; i < 500; ++i) all[static_cast<std::size_t>(i)] = i;
  int tries = 0;
  const auto fails = [&](const std::vector<int>& list) {
    ++tries;
    const auto first = std::ranges::find(list, 17);
    return std::find(first, list.end(), 401) != list.end();
  };
  EXPECT_EQ(shrink<int>(all, fails), (std::vector{17, 401}));
  EXPECT_LT(tries, 100);
  EXPECT_TRUE(shrink<int>(all, [](const auto&) { return true; }).empty());
  EXPECT_EQ(shrink<int>(all, [](const auto& list) { return list.size() == 500; }), all);
  // What was found in time.
  EXPECT_EQ(shrink<int>(all, fails, 1).size(), 500U);
}

}  // namespace
}  // namespace ghostforce::session_file_test
