// SVG and PDF files: whole, the same every time, with everything that was asked for; and the program that writes them
// with neither display nor OpenGL.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/desktop_inputs.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/layers.h"
#include "app/shell/application.h"
#include "app/shell/desktop/glfw_window.h"
#include "tests/app/paint/vector/vector_panes.h"
#include "tests/support/no_opengl.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::vector_file_test {
namespace {

Outcome render(std::vector<std::string> words) {
  words.insert(words.begin(), "render");
  return run_ghostforce(std::move(words));
}

std::string vector_file(VectorFormat format, std::string_view title = "A title") {
  return paint_vector(panes_of("fig1", Compare::overlay, light), light, size, 1.0, format, title);
}

// ---- Files ----------------------------------------------------------------------------------------------------------

// Opened tags are closed, in turn; what a reader of XML refuses first. Empty where all is well.
std::string fault_in(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return "a tag without an end";
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.starts_with('?') || tag.ends_with('/')) continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with('/')) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name.substr(1)) {
      return name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back() + " is not closed";
}

// ---- What is in a file, in whichever way this version of Cairo writes it --------------------------------------------

// The numbers at the beginning of a text, which brackets, commas, signs of percent and blanks keep apart.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = text.find_first_not_of("[(,% ", at)) != std::string_view::npos;) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (error != std::errc()) break;
    numbers.push_back(number);
    at = static_cast<std::size_t>(end - text.data());
  }
  return numbers;
}

// What follows a key; empty where there is none.
std::string_view after(std::string_view key, std::string_view text) {
  const std::size_t at = text.find(key);
  return at == std::string_view::npos ? std::string_view() : text.substr(at + key.size());
}

std::vector<std::string_view> tags_in(std::string_view svg) {
  std::vector<std::string_view> tags;
  for (std::string_view rest = after("<", svg); !rest.empty(); rest = after("<", rest)) {
    tags.push_back(rest.substr(0, rest.find('>')));
  }
  return tags;
}

// A tag's property, an attribute of its own (Cairo 1.18) or one of its style (1.16).
std::string_view property(std::string_view name, std::string_view tag) {
  for (const std::string_view before : {" ", ";", "\""}) {
    for (const std::string_view behind : {"=\"", ":"}) {
      const std::string_view value = after(fmt::format("{}{}{}", before, name, behind), tag);
      if (!value.empty()) return value.substr(0, value.find_first_of("\";"));
    }
  }
  return {};
}

bool is_colour(std::string_view value, Colour colour) {
  const std::vector<double> percent = numbers_in(after("rgb", value));
  const auto is_close = [](double share, std::uint8_t channel) { return std::abs(2.55 * share - channel) < 0.01; };
  return percent.size() == 3 && is_close(percent[0], colour.red) && is_close(percent[1], colour.green) &&
         is_close(percent[2], colour.blue);
}

// Whether a line or an area is of this colour.
bool paints(std::string_view svg, Colour colour) {
  return std::ranges::any_of(tags_in(svg), [&](std::string_view tag) {
    return is_colour(property("stroke", tag), colour) || is_colour(property("fill", tag), colour);
  });
}

// Whether a line has these dashes.
bool dashes(std::string_view svg, const LinePattern& pattern) {
  return std::ranges::any_of(tags_in(svg), [&](std::string_view tag) {
    return std::ranges::equal(numbers_in(property("stroke-dasharray", tag)), pattern);
  });
}

TEST(VectorFile, IsAWellFormedSvgOfTheSizeAskedFor) {
  const std::string file = vector_file(VectorFormat::svg, "a <b> & \"c\"\x01");
  EXPECT_TRUE(file.starts_with("<?xml")) << file.substr(0, 80);
  EXPECT_EQ(fault_in(file), "");
  EXPECT_NE(fault_in("<a><b></a></b>"), "");
  EXPECT_NE(file.find("width=\"904pt\" height=\"600pt\" viewBox=\"0 0 904 600\""), std::string::npos);
  EXPECT_NE(file.find("<title>a &lt;b&gt; &amp; &quot;c&quot;\\x01</title>"), std::string::npos) << file.substr(0, 400);
}

TEST(VectorFile, HoldsNothingThatXmlForbidsWhateverTheTitleIs) {
  for (const std::string forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF", "\x01", "\x1B", "\xFF", "\xED\xA0\x80"}) {
    const std::string file = vector_file(VectorFormat::svg, "a " + forbidden + " b");
    EXPECT_EQ(file.find(forbidden), std::string::npos);
    EXPECT_EQ(fault_in(file), "");
    EXPECT_NE(file.find("<title>a "), std::string::npos);
  }
}

TEST(VectorFile, IsAPdfWithItsTitleAndWithWords) {
  const std::string file = vector_file(VectorFormat::pdf, "A wall");
  EXPECT_TRUE(file.starts_with("%PDF-"));
  EXPECT_TRUE(file.ends_with("%%EOF\n"));
  EXPECT_NE(file.find("/Title (A wall)"), std::string::npos);
  EXPECT_EQ(numbers_in(after("/MediaBox", file)), (std::vector<double>{0.0, 0.0, 904.0, 600.0}));
  // Letters that a search understands, of the program's own font.
  EXPECT_NE(file.find("/ToUnicode"), std::string::npos);
  EXPECT_NE(file.find("+DejaVuSans"), std::string::npos);
}

TEST(VectorFile, HasTheSameBytesOnEveryCallAndNoDate) {
  for (const VectorFormat format : {VectorFormat::svg, VectorFormat::pdf}) {
    const std::string first = vector_file(format);
    EXPECT_EQ(vector_file(format), first);
    EXPECT_EQ(first.find("Date"), std::string::npos);
  }
}

TEST(VectorFile, HoldsEachStrategysColourAndDashes) {
  const std::string file = vector_file(VectorFormat::svg);
  for (const Strategy& each : strategy_catalog()) {
    const bool is_active = each.id == load_scene("fig1").settings.active;
    const Colour colour = is_active ? light.strategy[index_of(each.id)] : pale_colour(light, each.id);
    EXPECT_TRUE(paints(file, colour)) << each.name;
    LinePattern pattern = strategy_style(each.id).pattern;
    if (pattern == solid_line) continue;
    EXPECT_TRUE(dashes(file, pattern)) << each.name;
    pattern[3] += 0.5;
    EXPECT_FALSE(dashes(file, pattern)) << each.name;
  }
  EXPECT_FALSE(paints(file, rgb(0x010203)));
}

TEST(VectorFile, IsToldByItsEnding) {
  EXPECT_EQ(vector_format_of("a.svg"), VectorFormat::svg);
  EXPECT_EQ(vector_format_of("folder.svg/a.PDF"), VectorFormat::pdf);
  for (const char* other : {"a.png", "a", "a.svg.png", "folder.svg/a", "-", "", "svg", "a.svgz"}) {
    EXPECT_FALSE(vector_format_of(other)) << other;
  }
}

// ---- The program ----------------------------------------------------------------------------------------------------

TEST(RenderVectors, NeedsNoOpenGlAndGivesTheSameBytesOnEveryRun) {
  const NoOpenGl no_opengl;
  const TemporaryFolder folder;
  for (const char* ending : {"svg", "pdf"}) {
    std::vector<std::string> files;
    for (const char* name : {"a.", "b."}) {
      ProgramCall call;
      call.words = {"render", "fig1", "--strategy", "all", "-o", folder / std::string(name).append(ending)};
      call.environment = {no_opengl.variable(), "DISPLAY=", "WAYLAND_DISPLAY="};
      const Outcome outcome = run_ghostforce(call);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(outcome.out + outcome.err, "");
      files.push_back(read_whole(call.words.back()));
    }
    EXPECT_EQ(files[0], files[1]) << ending;
  }
  EXPECT_EQ(folder.count(), 4);
}

TEST(RenderVectors, HeedsEveryOptionOfAPicture) {
  const TemporaryFolder folder;
  std::vector<std::string> pictures;
  for (std::vector<std::string> words : std::vector<std::vector<std::string>>{{"--part", "scene"},
                                                                              {"--scale", "2"},
                                                                              {"--theme", "dark"},
                                                                              {"--compare", "side-by-side"},
                                                                              {"--strategy", "full"},
                                                                              {"--at", "0.5"},
                                                                              {"--size", "640x480"}}) {
    words.insert(words.end(), {"wall45", "-o", folder / "picture.svg"});
    const Outcome outcome = render(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    pictures.push_back(read_whole(folder / "picture.svg"));
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back()) << words[0];
  }
}

TEST(RenderVectors, DescribesWhatItDrewAsJson) {
  const TemporaryFolder folder;
  ASSERT_EQ(render({"wall45", "-o", folder / "a.svg", "--json", folder / "a.json"}).exit_code, 0);
  const auto picture = nlohmann::json::parse(read_whole(folder / "a.json"));
  EXPECT_EQ(picture["camera"]["size"], nlohmann::json::parse("[1280.0, 800.0]"));
  EXPECT_EQ(picture["camera"]["corner"], nlohmann::json::parse("[0.0, 0.0]"));
  EXPECT_GT(picture["marks"].size(), 50U);
}

TEST(RenderVectors, RefusesTheWindowAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  for (const char* name : {"a.svg", "a.PDF"}) {
    const Outcome outcome = render({"wall45", "--part", "window", "-o", folder / name});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("--part"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(RenderVectors, RefusesTwoOutputsOfOneName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(".", folder / "same");
  const auto refused = [&](const std::string& picture, const std::string& json) {
    ProgramCall call;
    call.words = {"render", "wall45", "-o", picture, "--json", json};
    call.folder = folder.path();
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.out, "");
    return outcome.exit_code == 2 && outcome.err.find("--output already writes to this file") != std::string::npos;
  };
  EXPECT_TRUE(refused("x.pdf", "./x.pdf"));
  EXPECT_TRUE(refused("x.pdf", "none/../x.pdf"));
  EXPECT_TRUE(refused("same/x.pdf", folder / "x.pdf"));
  EXPECT_TRUE(refused("-", "-"));
  EXPECT_TRUE(refused("-", "/dev/stdout"));
  EXPECT_EQ(folder.count(), 1);
  write_whole(folder / "-", "");
  EXPECT_FALSE(refused("x.pdf", "./-")) << "a file of this name is not the standard output";
  EXPECT_EQ(folder.count(), 3);
}

TEST(RenderVectors, WritesJsonIntoAPipe) {
  const TemporaryFolder folder;
  const Outcome outcome = render({"wall45", "-o", folder / "x.pdf", "--json", "/dev/stdout"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(nlohmann::json::accept(outcome.out));
  EXPECT_EQ(folder.count(), 1);
}

TEST(RenderVectors, SaysThatALinkLeadsToItself) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  const Outcome outcome = render({"wall45", "-o", folder / "x.pdf", "--json", folder / "loop"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("loop cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 1);
}

TEST(RenderVectors, SaysWhereItCannotWrite) {
  const Outcome outcome = render({"wall45", "-o", "/nonexistent/folder/picture.pdf"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("/nonexistent/folder"), std::string::npos) << outcome.err;
}

TEST(RenderVectors, SaysWhichFontItMissesAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const std::string program = elsewhere / "ghostforce";
  std::filesystem::copy_file(ghostforce_program(), program);
  const auto call = [&] { return run_program(program, {"render", "wall45", "-o", folder / "a.svg"}); };
  Outcome outcome = call();
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("DejaVuSans.ttf"), std::string::npos) << outcome.err;
  std::filesystem::create_directory(elsewhere / "fonts");
  write_whole(elsewhere / "fonts/DejaVuSans.ttf", "no font");
  outcome = call();
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("DejaVuSans.ttf cannot be read"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);
}

TEST(SavePicture, WritesVectorsWhereTheNameSaysSo) {
  const TemporaryFolder folder;
  GlfwWindow window({.title = "test", .width = 1280, .height = 800, .offscreen = true, .takes_mouse = false});
  Application application(window, load_scene("wall45"), {.inputs = desktop_inputs(), .painter = cairo_file_painter()});
  application.frame(0.016);
  const auto save = [&](const char* name) {
    application.act(SavePicture{.path = folder / name});
    application.frame(0.016);
    EXPECT_FALSE(application.session().notice->is_problem) << application.session().notice->words;
    return read_whole(folder / name);
  };
  EXPECT_TRUE(save("a.pdf").ends_with("%%EOF\n"));
  const std::string naive = save("a.svg");
  EXPECT_EQ(fault_in(naive), "");
  const Vector<2> scene = application.screen().scene_size();
  const std::vector<double> box = numbers_in(after("viewBox=\"", naive));
  ASSERT_EQ(box.size(), 4U) << naive.substr(0, 300);
  EXPECT_NEAR(box[2], scene.x, 1e-6);
  EXPECT_NEAR(box[3], scene.y, 1e-6);
  // The session's own: strategy and theme.
  application.session().settings.active = StrategyId::full;
  EXPECT_NE(save("b.svg"), naive);
  application.session().appearance.theme = find_theme("dark");
  EXPECT_FALSE(paints(naive, find_theme("dark")->background));
  EXPECT_TRUE(paints(save("c.svg"), find_theme("dark")->background));
  EXPECT_TRUE(save("a.png").substr(1).starts_with("PNG"));
}

}  // namespace
}  // namespace ghostforce::vector_file_test
