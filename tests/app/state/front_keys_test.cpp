// The keys of both fronts, without a window: each is whole, and the page asks for none that a browser keeps.
#include "app/state/front_keys.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/state/key_bindings.h"
#include "app/state/keys.h"

namespace ghostforce::front_keys_test {
namespace {

constexpr int ctrl = modifier::control;
constexpr int shift = modifier::shift;
constexpr int alt = modifier::alt;

using Chord = std::pair<int, int>;  // key, modifiers

// What browsers on Linux, Windows and macOS do with these, a page cannot change, or should not: a new tab or window, one
// closed or opened again, printing, reloading, searching, history, bookmarks, downloads, zoom, help, the tools.
const std::set<Chord> kept_by_browsers{{key::t, ctrl},
                                       {key::t, ctrl | shift},
                                       {key::n, ctrl},
                                       {key::n, ctrl | shift},
                                       {key::w, ctrl},
                                       {key::w, ctrl | shift},
                                       {key::q, ctrl},
                                       {key::q, ctrl | shift},
                                       {key::p, ctrl},
                                       {key::p, ctrl | shift},
                                       {key::r, ctrl},
                                       {key::r, ctrl | shift},
                                       {key::f, ctrl},
                                       {key::g, ctrl},
                                       {key::l, ctrl},
                                       {key::k, ctrl},
                                       {key::d, ctrl},
                                       {key::h, ctrl},
                                       {key::j, ctrl},
                                       {key::u, ctrl},
                                       {key::c, ctrl | shift},
                                       {key::i, ctrl | shift},
                                       {key::j, ctrl | shift},
                                       {key::k, ctrl | shift},
                                       {key::equal, ctrl},
                                       {key::minus, ctrl},
                                       {key::digit_0, ctrl},
                                       {key::equal, ctrl | shift},
                                       {key::tab, ctrl},
                                       {key::tab, alt},
                                       {key::left, alt},
                                       {key::right, alt},
                                       {key::up, alt},
                                       {key::home, alt},
                                       {key::d, alt},
                                       {key::f, alt},
                                       {key::f4, alt},
                                       {key::f4, ctrl},
                                       {key::f1, 0},
                                       {key::f3, 0},
                                       {key::f5, 0},
                                       {key::f6, 0},
                                       {key::f7, 0},
                                       {key::f10, 0},
                                       {key::f11, 0},
                                       {key::f12, 0},
                                       {key::number_pad_add, ctrl},
                                       {key::number_pad_subtract, ctrl}};

struct Front {
  const char* name;
  FrontKeys keys;
};

constexpr std::array fronts{Front{"desktop", keys_on_desktop}, Front{"page", keys_in_page}};

Chord pressed(const KeyBinding& binding) {
  return {binding.key, binding.modifiers};
}

bool is_typed(const KeyBinding& binding) {
  return binding.key < key::escape && (binding.modifiers & (ctrl | alt)) == 0;
}

const KeyBinding* find(const std::vector<KeyBinding>& table, std::string_view sentence) {
  const auto found = std::ranges::find(table, sentence, &KeyBinding::sentence);
  return found == table.end() ? nullptr : &*found;
}

TEST(FrontKeys, AreTheDesktopsHere) {
  const std::vector<KeyBinding> table = key_table_of(keys_on_desktop);
  EXPECT_TRUE(std::ranges::equal(key_table(), table, {}, pressed, pressed));
  EXPECT_EQ(front_keys().help.shown, keys_on_desktop.help.shown);
}

TEST(FrontKeys, NoKeyHasTwoActionsAndEachHasItsWords) {
  for (const Front& front : fronts) {
    SCOPED_TRACE(front.name);
    const std::vector<KeyBinding> table = key_table_of(front.keys);
    std::set<Chord> seen;
    std::set<std::string_view> groups;
    ASSERT_FALSE(table.front().group.empty());
    for (const KeyBinding& binding : table) {
      EXPECT_TRUE(seen.insert(pressed(binding)).second) << binding.shown << ' ' << binding.sentence;
      EXPECT_EQ(binding.shown.empty(), binding.sentence.empty());
      EXPECT_NE(binding.key, 0);
      EXPECT_TRUE(binding.action || binding.key == key::tab);
      if (!binding.group.empty()) {
        EXPECT_TRUE(groups.insert(binding.group).second) << binding.group;
      }
    }
    for (const MouseGesture& gesture : mouse_table()) EXPECT_TRUE(groups.contains(gesture.group)) << gesture.shown;
  }
}

// Who types a file's name must be able to type all letters.
TEST(FrontKeys, WhatIsTypedIsForTheField) {
  for (const Front& front : fronts) {
    SCOPED_TRACE(front.name);
    for (const KeyBinding& binding : key_table_of(front.keys)) {
      EXPECT_FALSE(is_typed(binding) && binding.also_in_fields) << binding.shown << ' ' << binding.sentence;
    }
  }
}

TEST(FrontKeys, ThePageLeavesBrowsersWhatTheyKeep) {
  for (const KeyBinding& binding : key_table_of(keys_in_page)) {
    if (pressed(binding) == Chord{key::p, ctrl}) continue;  // the palette has it everywhere: nobody prints this page
    EXPECT_FALSE(kept_by_browsers.contains(pressed(binding))) << binding.shown << ' ' << binding.sentence;
  }
  const auto kept = std::ranges::count_if(key_table_of(keys_on_desktop), [](const KeyBinding& binding) {
    return kept_by_browsers.contains(pressed(binding));
  });
  EXPECT_GT(kept, 10) << "the test itself must be able to fail";
}

// What the page cannot do is the browser's to do; all else it can, under the same words but for what differs.
TEST(FrontKeys, ThePageDoesAllElse) {
  const std::vector<KeyBinding> page = key_table_of(keys_in_page);
  std::vector<std::string> absent;
  for (const KeyBinding& binding : key_table_of(keys_on_desktop)) {
    if (binding.sentence.empty() || find(page, binding.sentence) != nullptr) continue;
    absent.emplace_back(binding.sentence);
  }
  EXPECT_EQ(absent, (std::vector<std::string>{std::string(english_stage.key_rows.view),
                                              "Text size: larger, smaller, default", "Quit"}));
  EXPECT_NE(find(page, english_stage.key_rows.view_in_page), nullptr);
  constexpr std::string_view link = "A link to what is shown, for others";
  EXPECT_NE(find(page, link), nullptr);
  EXPECT_EQ(find(key_table_of(keys_on_desktop), link), nullptr) << "there is no page to link to";
  for (const KeyBinding& binding : page) {
    EXPECT_FALSE(binding.key == key::q && (binding.modifiers & ctrl) != 0) << "it would be the browser that quits";
  }
}

// As shown and as bound: "Ctrl+Shift+P" is Ctrl and Shift and P.
TEST(FrontKeys, AreShownAsTheyAre) {
  for (const Front& front : fronts) {
    SCOPED_TRACE(front.name);
    const FrontKeys& all = front.keys;
    for (const FrontKey& each : {all.help, all.lessons, all.device_status, all.plots, all.full_screen, all.next_theme,
                                 all.save_picture, all.copy_picture, all.copy_values}) {
      EXPECT_EQ(each.shown, chord_of({each.key, each.modifiers, {}, {}, {}}));
    }
    const bool has_shift = (all.move_view_modifiers & shift) != 0;
    const std::vector<KeyBinding> table = key_table_of(all);
    EXPECT_NE(find(table, has_shift ? english_stage.key_rows.view_in_page : english_stage.key_rows.view), nullptr);
  }
}

TEST(FrontKeys, ItIsOursWhatTheTableHas) {
  for (const bool is_typing : {false, true}) {
    EXPECT_TRUE(is_ours({.key = key::p, .modifiers = ctrl}, is_typing)) << "or the browser prints";
  }
  EXPECT_TRUE(is_ours({.key = key::space}, false));
  EXPECT_TRUE(is_ours({.key = key::o}, false));
  EXPECT_TRUE(is_ours({.key = key::o, .is_repeat = true}, false)) << "that nothing happens again is ours too";
  EXPECT_TRUE(is_ours({.key = key::s, .modifiers = ctrl}, false));
  EXPECT_FALSE(is_ours({.key = key::w, .modifiers = ctrl}, false));
  EXPECT_FALSE(is_ours({.key = key::g, .modifiers = ctrl}, false));
  EXPECT_FALSE(is_ours({.key = key::f12}, false));
  EXPECT_FALSE(is_ours({.key = key::j}, false));
}

TEST(FrontKeys, WhileSomebodyTypesItIsOursWhatIsTyped) {
  for (const int key : {key::g, key::j, key::space, key::backspace, key::home, key::tab, key::slash, key::apostrophe}) {
    EXPECT_TRUE(is_ours({.key = key}, true)) << key;
    EXPECT_TRUE(is_ours({.key = key, .modifiers = shift}, true)) << key;
  }
  EXPECT_TRUE(is_ours({.key = key::s, .modifiers = ctrl}, true));
  EXPECT_FALSE(is_ours({.key = key::z, .modifiers = ctrl}, true)) << "it is the field's to take back";
  EXPECT_FALSE(is_ours({.key = key::f12}, true));
  EXPECT_FALSE(is_ours({.key = key::left, .modifiers = alt}, true));
}

}  // namespace
}  // namespace ghostforce::front_keys_test
