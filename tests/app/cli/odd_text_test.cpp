// Texts that hold what no screen can show, or what ends a text early, wherever the program takes a text from: refused
// with the place where it stands where a person wrote it, drawn as signs where it is a file's name.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/quoted.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/theme.h"
#include "tests/app/paint/vector/vector_panes.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::odd_text_test {
namespace {

using namespace std::string_view_literals;

// --- Characters ------------------------------------------------------------------------------------------------------

TEST(Unicode, ReadsACharacter) {
  const auto read = [](std::string_view text, char32_t code, std::size_t length) {
    const Character character = first_character(text);
    EXPECT_EQ(character.code, code) << text;
    EXPECT_EQ(character.length, length) << text;
  };
  read("a", 'a', 1);
  read("\0b"sv, 0, 1);
  read("ρx", 0x3C1, 2);
  read("€", 0x20AC, 3);
  read("\xED\x9F\xBF", 0xD7FF, 3);
  read("\xEE\x80\x80", 0xE000, 3);
  read("\xF0\x90\x80\x80", 0x10000, 4);
  read("\xF4\x8F\xBF\xBF", 0x10FFFF, 4);
  for (const std::string_view wrong : {"", "\x80", "\xFF", "\xC1\xBF", "\xC3", "\xC3x", "\xE0\x9F\xBF", "\xED\xA0\x80",
                                       "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80"}) {
    read(wrong, 0, 0);
  }
}

TEST(Unicode, NamesTheFirstThatCannotBeShown) {
  const auto words = [](std::string_view text, bool may_have_lines = false) {
    return unshowable_in(text, may_have_lines).value_or("");
  };
  EXPECT_EQ(words("a wall, ρ = 4 😀"), "");
  EXPECT_EQ(words("\0\x01"sv), "the control character U+0000");
  EXPECT_EQ(words("ab\x1b"), "the control character U+001B");
  EXPECT_EQ(words("\x7f"), "the control character U+007F");
  EXPECT_EQ(words("\xC2\x9B"), "the control character U+009B");
  EXPECT_EQ(words("\xC2\xA0"), "") << "a space that keeps words together";
  EXPECT_EQ(words("\xEF\xBF\xBD"), "") << "U+FFFD is a character";
  EXPECT_EQ(words("\xEF\xB7\x8F"), "") << "U+FDCF";
  EXPECT_EQ(words("\xEF\xB7\x90"), "U+FDD0, which is not a character");
  EXPECT_EQ(words("\xEF\xB7\xAF"), "U+FDEF, which is not a character");
  EXPECT_EQ(words("\xEF\xBF\xBF"), "U+FFFF, which is not a character");
  EXPECT_EQ(words("\xF0\x9F\xBF\xBE"), "U+1FFFE, which is not a character");
  EXPECT_EQ(words("a\xFF"), "the byte 0xFF, which is not UTF-8");
  EXPECT_EQ(words("\xED\xA0\x80"), "the byte 0xED, which is not UTF-8") << "half of a pair of UTF-16";
  for (const std::string_view layout : {"a\nb", "a\r\nb", "\ta"}) {
    EXPECT_EQ(words(layout, true), "");
    EXPECT_NE(words(layout, false), "");
  }
  EXPECT_EQ(words("a\rb", true), "the control character U+000D") << "an old Mac's line break, which no screen breaks";
}

// --- Scenes ----------------------------------------------------------------------------------------------------------

std::string scene_with(std::string_view title, std::string_view about) {
  return fmt::format("format = 1\ntitle = {}\nabout = {}\n", title, about) +
         read_whole(source_path("/assets/scenes/wall45.toml"))
             .substr(read_whole(source_path("/assets/scenes/wall45.toml")).find("[wall]"));
}

std::string refusal(std::string_view text, const std::vector<std::string>& overrides = {}) {
  try {
    read_scene(text, "f.toml", overrides);
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
  return "";
}

TEST(SceneTexts, OfOneLineHoldNoControlCharacter) {
  for (const std::string_view code : {"0000", "0001", "0009", "000A", "000D", "001B", "007F", "0085", "009B"}) {
    EXPECT_EQ(refusal(scene_with(fmt::format(R"("a \u{} wall")", code), "\"b\"")),
              fmt::format("f.toml:2:9: the key title: contains the control character U+{}; remove it", code));
  }
  EXPECT_EQ(refusal(scene_with("\"a\"", "\"b\""), {R"(title="\u0000x")"}),
            R"(--set title="\u0000x": the key title: contains the control character U+0000; remove it)");
  EXPECT_EQ(refusal(scene_with("\"a\"", "\"b\""), {"title=\x01x"}),
            R"(--set title=\x01x: the key title: contains the control character U+0001; remove it)");
}

TEST(SceneTexts, HoldOnlyCharacters) {
  for (const std::string_view code : {"FFFE", "FFFF", "FDD0", "FDEF"}) {
    const std::string words = fmt::format("contains U+{}, which is not a character; remove it", code);
    EXPECT_EQ(refusal(scene_with(fmt::format(R"("\u{}")", code), "\"b\"")), "f.toml:2:9: the key title: " + words);
    EXPECT_EQ(refusal(scene_with("\"a\"", fmt::format(R"("\u{}")", code))), "f.toml:3:9: the key about: " + words);
  }
  EXPECT_NE(refusal(scene_with("\"\xEF\xBF\xBE\"", "\"b\"")).find("U+FFFE"), std::string::npos) << "written as it is";
  for (const std::string_view half : {R"("\uD800")", R"("\uDFFF")", "\"\xED\xA0\x80\""}) {
    EXPECT_TRUE(refusal(scene_with(half, "\"b\"")).starts_with("f.toml:2:")) << half;
  }
}

TEST(SceneTexts, AboutMayHaveLinesAndTabs) {
  const Scene scene = read_scene(scene_with("\"a\"", "\"\"\"\nFirst.\n\tThen.\r\nLast.\"\"\""), "f.toml");
  EXPECT_NE(scene.about.find("First.\n\tThen."), std::string::npos) << scene.about;
  EXPECT_EQ(read_scene(scene_text(scene), "g.toml").about, scene.about);
  EXPECT_NE(refusal(scene_with("\"a\"", R"("\u0000")")).find("f.toml:3:9: the key about: contains"), std::string::npos);
}

// What once ended each of these with 134 or 70.
TEST(SceneTexts, OfAnOddKindAreAWrongCallEverywhere) {
  const TemporaryFolder folder;
  for (const std::string_view title : {R"("\u0000a wall")", R"("\uFFFE")", R"("\uFDD0")"}) {
    write_whole(folder / "odd.toml", scene_with(title, "\"b\""));
    std::filesystem::create_directories(folder / "cases");
    write_whole(folder / "cases/a.toml", "scene = \"../odd.toml\"\n");
    std::string run = run_ghostforce({"simulate", "wall45", "--set", "goal.duration_s=0.1"}).out;
    const std::size_t at = run.find("# title = ");
    ASSERT_NE(at, std::string::npos);
    run.replace(at, run.find('\n', at) - at, fmt::format("# title = {}", title));
    write_whole(folder / "odd.csv", run);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"render", folder / "odd.toml", "-o", folder / "a.png"},
          {"render", folder / "odd.toml", "-o", folder / "a.pdf"},
          {"render", folder / "odd.toml", "-o", folder / "a.svg"},
          {"run", folder / "odd.toml", "--input", "script", "--exit-after", "1"},
          {"simulate", folder / "odd.toml"},
          {"check", folder / "cases"}}) {
      const Outcome outcome = run_ghostforce(words);
      EXPECT_EQ(outcome.exit_code, 2) << words[0] << ' ' << title << '\n' << outcome.err;
      EXPECT_NE(outcome.err.find("odd.toml:2:9: the key title: contains "), std::string::npos) << outcome.err;
      EXPECT_EQ(outcome.err.find('\0'), std::string::npos);
    }
    // The scene of a recording stands in its lines, and so does the place.
    const Outcome replayed = run_ghostforce({"replay", folder / "odd.csv"});
    EXPECT_EQ(replayed.exit_code, 2) << replayed.err;
    EXPECT_NE(replayed.err.find("odd.csv:5:11: the key title: contains "), std::string::npos) << replayed.err;
    // Its hand can be played in another one.
    const Outcome elsewhere = run_ghostforce({"replay", folder / "odd.csv", "wall45"});
    EXPECT_EQ(elsewhere.exit_code, 0) << elsewhere.err;
    EXPECT_NE(elsewhere.err.find("the scene in it cannot be read"), std::string::npos) << elsewhere.err;
  }
}

TEST(CaseTexts, OfAnOddKindAreToldWithTheirPlace) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "cases");
  write_whole(folder / "cases/a.toml",
              "scene = \"\\u0000wall45\"\nmatch = \"\\uFFFF\"\ntheme = \"\\u001B\"\n[golden]\nmesa = \"\\u009B\"\n");
  const Outcome outcome = run_ghostforce({"check", folder / "cases"});
  EXPECT_EQ(outcome.exit_code, 2);
  for (const std::string_view words :
       {"a.toml:1:9: the key scene: contains the control character U+0000; remove it",
        "a.toml:2:9: the key match: contains U+FFFF, which is not a character; remove it",
        "a.toml:3:9: the key theme: '\\x1B' is not one of light, dark, projector",
        "a.toml:5:8: the key golden.mesa: contains the control character U+009B"}) {
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << '\n' << outcome.err;
  }
}

// --- Names of files --------------------------------------------------------------------------------------------------

TEST(VectorWords, AreDrawnWhateverTheyAre) {
  for (const std::string_view odd : {"\0x"sv, "\xFF"sv, "\xEF\xBF\xBE"sv, "\xED\xA0\x80"sv, "\x1B[2J"sv, ""sv}) {
    for (const VectorFormat format : {VectorFormat::pdf, VectorFormat::svg}) {
      std::vector<Pane> panes = panes_of("fig1", Compare::overlay, light);
      panes.front().marks.push_back(
          {Role::legend, {}, Label{{}, {}, std::string(odd), normal_text, light.text, light.background}});
      EXPECT_NO_THROW(paint_vector(panes, light, size, 1.0, format, odd)) << odd;
    }
    EXPECT_GE(measure_vector_text(odd, {10.0}).x, 0.0);
  }
}

TEST(FileNames, MayHoldAnythingInFigures) {
  const TemporaryFolder folder;
  for (const std::string name : {"\xFF.csv", "\xEF\xBF\xBE.csv", "a\x01.csv"}) {
    ASSERT_EQ(run_ghostforce({"simulate", "wall45", "-o", folder / name}).exit_code, 0);
    const Outcome outcome =
        run_ghostforce({"figures", "-o", folder / "figures", "--hand", folder / name, "--only", "figure-6"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce::odd_text_test
