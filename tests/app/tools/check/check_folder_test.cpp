// Screenshot regression as its users have it: the folder that `ghostforce check` is given. Goldens that are missing or
// no files, what --update writes, cases that are wrong, and how it ends.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "app/tools/check/case_folder.h"
#include "app/tools/check/golden_origin.h"
#include "app/tools/check/verdict.h"
#include "ghostforce_version.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/file_calls.h"
#include "tests/support/no_opengl.h"
#include "tests/support/places.h"

namespace ghostforce::check_folder_test {
namespace {

namespace fs = std::filesystem;

// --- Goldens ---------------------------------------------------------------------------------------------------------

TEST(Check, SaysWithWhichCommandAGoldenComesToBe) {
  const Cases cases({{"it's new", std::string(small_case)}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out, "FAIL it's new  there is no golden"));
  EXPECT_TRUE(contains(outcome.out, "1 case, 1 failed\n"));
  const std::string command = fmt::format("check {} --update 'it'\\''s new'", cases.path());
  ASSERT_TRUE(contains(outcome.err, "ghostforce " + command));
  // By a shell, as the person does it.
  EXPECT_EQ(run_program("/bin/sh", {"-c", ghostforce_program() + " " + command}).exit_code, 0);
  EXPECT_EQ(cases.check().exit_code, 0);
}

TEST(Check, ReportsAGoldenThatIsNoPictureAndGoesOn) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}});
  write_whole(cases / "a.png", "version https://git-lfs.github.com/spec/v1\n");
  cases.update("b");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(contains(outcome.out, "FAIL a"));
  EXPECT_TRUE(contains(outcome.out, "pass b\n2 cases, 1 failed\n"));
  cases.update("a");
  EXPECT_EQ(cases.check().exit_code, 0);
}

// Each of them once held the check up, or got a remedy that failed.
TEST(Check, SaysWhatAGoldenIsThatIsNoFile) {
  const Cases cases({{"folder", std::string(small_case)},
                     {"good", std::string(small_case)},
                     {"link", std::string(small_case)},
                     {"loop", std::string(small_case)},
                     {"pipe", std::string(small_case)}});
  cases.update("good");
  fs::create_directory(cases / "folder.png");
  fs::create_symlink("nothing.png", cases / "link.png");
  fs::create_symlink("loop.png", cases / "loop.png");
  ASSERT_EQ(mkfifo((cases / "pipe.png").c_str(), 0600), 0);
  const Outcome checked = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(checked.exit_code, 8);
  EXPECT_TRUE(contains(checked.out, "pass good"));
  EXPECT_TRUE(contains(checked.out, "5 cases, 4 failed"));
  EXPECT_EQ(checked.err.find("--update"), std::string::npos) << checked.err;
  const Outcome updated = cases.check({"--update", "folder", "link", "loop", "pipe"});
  EXPECT_EQ(updated.exit_code, 8);
  EXPECT_EQ(updated.out, "");
  for (const auto& [name, words] : std::map<std::string, std::string>{{"folder", "is a folder"},
                                                                      {"link", "is a broken link"},
                                                                      {"loop", "is a broken link"},
                                                                      {"pipe", "is a pipe"}}) {
    EXPECT_TRUE(contains(checked.err, fmt::format("the golden {} {}", cases / (name + ".png"), words)));
    EXPECT_TRUE(contains(updated.err, fmt::format("{} cannot be written: it {}", cases / (name + ".png"), words)));
    EXPECT_EQ(read_whole(cases / (name + ".toml")), small_case);
    fs::remove(cases / (name + ".png"));
  }
  EXPECT_EQ(cases.check({"--update", "folder", "link", "loop", "pipe"}).exit_code, 0) << "as it was advised";
}

TEST(Check, TakesALinkToAFileForTheFile) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  for (const char* name : {"wall.png", "wall.toml"}) {
    fs::rename(cases / name, cases.beside(name));
    fs::create_symlink(fs::path("..") / name, cases / name);
  }
  EXPECT_EQ(cases.check().exit_code, 0);
}

// --- --update --------------------------------------------------------------------------------------------------------

TEST(CheckUpdate, KeepsEveryByteOfTheRestOfTheCase) {
  struct Edit {
    std::string before;
    std::string after;  // {} stands for the table's three values
  };
  const std::string head = "# Ünlaut \xE2\x86\x92 comment\n  scene = \"wall45\" # why\nsize=[320,240]\n";
  for (const std::string newline : {"\n", "\r\n"}) {
    for (const Edit& edit : std::vector<Edit>{
             {head, head + "\n[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "part='scene'  # no newline",
              head + "part='scene'  # no newline\n\n[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "[golden] # mine\n mesa='1'#x\n# y\nrenderer = \"\\\"ü\\\"\"  # z\nversion =\"0\"\n\n# "
                     "end\n[tolerance]\nshare=0.5\n",
              head +
                  "[golden] # mine\n mesa=M#x\n# y\nrenderer = R  # z\nversion =V\n\n# end\n[tolerance]\nshare=0.5\n"},
             {head + "[golden]\nmesa = '1'\n[tolerance]\n# nothing",
              head + "[golden]\nrenderer = R\nversion = V\nmesa = M\n[tolerance]\n# nothing"},
             {head + "[golden]", head + "[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "golden.renderer='a'\ngolden.mesa = 'b'\ngolden.version='c'\n",
              head + "golden.renderer=R\ngolden.mesa = M\ngolden.version=V\n"}}) {
      const auto with_newlines = [&](const std::string& text) {
        return std::regex_replace(text, std::regex("\n"), newline);
      };
      const auto with_values = [](std::string text, const GoldenOrigin& origin) {
        text = std::regex_replace(text, std::regex("([=] ?)R"), "$1\"" + origin.renderer + "\"");
        text = std::regex_replace(text, std::regex("([=] ?)M"), "$1\"" + origin.mesa + "\"");
        return std::regex_replace(text, std::regex("([=] ?)V"), "$1\"" + origin.version + "\"");
      };
      const GoldenOrigin origin{"softpipe", "22.3.6", "7.7"};
      // A newline where the table had none is the one that the file uses elsewhere.
      EXPECT_EQ(with_origin(with_newlines(edit.before), origin, "f.toml"),
                with_newlines(with_values(edit.after, origin)));
    }
  }
}

TEST(CheckUpdate, WritesWhereTheGoldenCameFromAndNothingElse) {
  const std::string before = "# keep me\r\n" + std::string(small_case) + "# and me\n[tolerance] # too\nchannel = 1\n";
  const Cases cases({{"a", before}, {"b", before}});
  const Outcome outcome = cases.check({"--update", "a"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "wrote " + cases / "a.png"));
  EXPECT_TRUE(contains(outcome.out, "look at it before you commit it"));
  EXPECT_EQ(cases.files(), (std::set<std::string>{"a.toml", "a.png", "b.toml"}));
  EXPECT_EQ(read_whole(cases / "b.toml"), before);
  const std::string after = read_whole(cases / "a.toml");
  EXPECT_TRUE(after.starts_with(before));
  EXPECT_TRUE(contains(after, "renderer = \"llvmpipe"));
  EXPECT_TRUE(contains(after, "mesa = \""));
  EXPECT_TRUE(contains(after, fmt::format("version = \"{}\"", version)));
  EXPECT_FALSE(contains(after, "bits")) << "the width of the vectors changes no pixel";
}

TEST(CheckUpdate, LeavesWhatIsEqualUntouched) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const auto golden_time = fs::last_write_time(cases / "wall.png");
  const auto case_time = fs::last_write_time(cases / "wall.toml");
  const Outcome outcome = cases.check({"--update", "wall"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "stays as it is"));
  EXPECT_EQ(fs::last_write_time(cases / "wall.png"), golden_time);
  EXPECT_EQ(fs::last_write_time(cases / "wall.toml"), case_time);
}

TEST(CheckUpdate, RefusesWhatHasNoGolden) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case) + "match = \"a\"\n"}});
  const Outcome outcome = cases.check({"--update", "a", "b"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, cases / "b.toml:4:9: b has no golden"));
  EXPECT_EQ(cases.files().size(), 2U) << "nothing was written for the other either";
}

TEST(CheckUpdate, RefusesAnInlineTableThatLacksAKey) {
  const Cases cases({{"a", std::string(small_case) + "golden = { mesa = \"1\" }\n"}});
  const Outcome outcome = cases.check({"--update", "a"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "remove it"));
  EXPECT_EQ(cases.files().size(), 1U);
}

TEST(CheckUpdate, SaysWhereItCannotWrite) {
  const Cases cases({{"wall", std::string(small_case)}});
  fs::create_directory(cases / "wall.png");
  const Outcome outcome = cases.check({"--update", "wall"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(contains(outcome.err, "wall.png cannot be written"));
  EXPECT_EQ(read_whole(cases / "wall.toml"), small_case);
}

TEST(CheckUpdate, LeavesAllAsItWasWhereOneFileCannotBePutInPlace) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}});
  write_whole(cases / "a.png", "old");
  const std::vector<Case> all = read_case_folder(cases.path());
  FileCalls calls;
  calls.fail("rename", EIO);  // of b.png, which is new; a.png is exchanged before
  EXPECT_THROW(update_goldens(all, chosen_cases(all, {"a", "b"}, "--update"), std::nullopt), Failure);
  EXPECT_TRUE(read_whole(cases / "a.png") == "old");
  EXPECT_EQ(read_whole(cases / "a.toml"), small_case);
  EXPECT_EQ(cases.files().size(), 3U);
}

TEST(CheckUpdate, SaysWhereTheFolderMayOnlyBeRead) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const Cases cases({{"wall", std::string(small_case)}, {"same", std::string(small_case) + "match = \"wall\"\n"}});
  fs::permissions(cases.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome updated = cases.check({"--update", "wall"});
  const Outcome checked = cases.check({"--only", "same"});
  fs::permissions(cases.path(), fs::perms::owner_all);
  EXPECT_EQ(updated.exit_code, 8);
  EXPECT_TRUE(contains(updated.err, "wall.png cannot be written: Permission denied"));
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_EQ(cases.files().size(), 2U);
}

// --- Wrong calls -----------------------------------------------------------------------------------------------------

TEST(Check, TellsAllThatIsWrongWithAllCasesBeforeItDraws) {
  const Cases cases({
      {"a", "scene = \"wal45\"\n"},
      {"b", "scene = \"wall45\"\nstratgy = \"naive\"\n[tolerance]\nshares = 0.5\n"},
      {"c",
       "scene = 5\nat_s = \"3\"\nsize = [1280, 63]\npart = \"windw\"\nstrategy = \"naiv\"\ntheme = \"drak\"\n"
       "compare = \"overlai\"\nscale = 5\nset = [\"wall.normal_de=120\", \"wall.normal_deg=x\"]\n"},
      {"d", "scene = \"wall45\"\nmatch = \"aa\"\nmismatch = \"b\"\n[tolerance]\nchannel = 256\nshare = nan\n"},
      {"e", "scene = \"wall45\"\nmatch = \"e\"\n"},
      {"f", "scene = \"wall45\"\nsize = 5\nset = \"x\"\n[golden]\nmesa = 22\n"},
      {"g", "scene = \"wall45\"\nat_s = 20000\nset = [\"wall.normal_de=120\"]\n[tolerance]\ntheme = \"dark\"\n"},
      {"h", ""},
      {"i", "scene = \n"},
      {"j", "scene = \"wall45\"\nmatch = \"b\"\nsize = [100, 100]\n[golden]\n"},
      {"k", "scene = \"wall45\"\nat_s = 20000\nchannel = 3\nsize = [1.5, 100]\n"},
      {"l", "scene = \"broken.scene\"\n"},
      {"m", "scene = \"wall45\"\nview = \"stage\"\nmode = \"whi\"\nstrategy = \"all\"\ncompare = \"overlay\"\n"},
      {"n", "scene = \"wall45\"\nview = \"bench\"\n"},
      {"o", "scene = \"wall45\"\nview = \"workbench\"\nmode = \"why\"\n"},
  });
  write_whole(cases / "broken.scene", "format = 1\n");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  for (const std::string words :
       {"a.toml:1:9: the key scene: no scene named",
        "did you mean 'wall45'?",
        "b.toml:2:1: the key stratgy is unknown; did you mean 'strategy'?",
        "b.toml:4:1: the key tolerance.shares is unknown; did you mean 'share'?",
        "c.toml:1:9: the key scene: is a number; give a string in quotes",
        "c.toml:2:8: the key at_s: is a string; give 0 to",
        "c.toml:3:15: the key size: 63 is out of range; give a whole number, 64 to 4096",
        "c.toml:4:8: the key part: 'windw' is not one of window, scene; did you mean 'window'?",
        "c.toml:5:12: the key strategy: 'naiv' is not one of",
        "c.toml:6:9: the key theme: 'drak' is not one of",
        "c.toml:7:11: the key compare: 'overlai'",
        "c.toml:8:9: the key scale: 5 is out of range; give 0.75 to 3",
        "d.toml:2:9: the key match: there is no case 'aa'",
        "d.toml:3:12: the key mismatch: the key match is there too",
        "d.toml:5:11: the key tolerance.channel: 256 is out of range",
        "d.toml:6:9: the key tolerance.share: nan",
        "e.toml:2:9: the key match: names this case itself",
        "f.toml:2:8: the key size: is a number; give [width",
        "f.toml:3:7: the key set: is a string; give strings",
        "f.toml:5:8: the key golden.mesa: is a number",
        "g.toml:3:8: the key set: wall.normal_de=120: ",
        "did you mean 'theme'? It belongs before the first [table]",
        "h.toml:1:1: the key scene is missing",
        "i.toml:1:",
        "j.toml:4:1: the table [golden]: with the key match",
        "j.toml:2:9: the key match: this picture has 100x100 pixels, and that of 'b' has 1280x800",
        "k.toml:2:8: the key at_s: 20000 s is out of range",
        "k.toml:3:1: the key channel is unknown; did you mean "
        "'tolerance.channel'?",
        "k.toml:4:9: the key size: has a decimal point",
        "l.toml:1:9: the key scene: ",
        "m.toml:3:8: the key mode: 'whi' is not one of predict, why, landscape, round, ribbon, measure",
        "m.toml:4:12: the key strategy: the stage shows one strategy at a time",
        "m.toml:5:11: the key compare: the stage shows one strategy at a time",
        "n.toml:2:8: the key view: 'bench' is not one of stage, workbench",
        "o.toml:3:8: the key mode: belongs to the stage; give view = \"stage\" too"}) {
    EXPECT_TRUE(contains(outcome.err, words));
  }
  EXPECT_FALSE(fs::exists(cases.beside("report")));
}

TEST(Check, TellsASceneFromACase) {
  const Cases cases({{"good", std::string(small_case)},
                     {"half", "[wall]\nnormal_deg = 90\n"},
                     {"mine", read_whole(source_path("/assets/scenes/wall45.toml"))},
                     {"numbered", "format = 1\n" + std::string(small_case)},
                     {"newer", "format = 2\n" + std::string(small_case) + "hologram = true\n"}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* name : {"half", "mine"}) {
    EXPECT_TRUE(contains(outcome.err, fmt::format("{}.toml:1:1: this is a scene, not a case; put scenes into a "
                                                  "subfolder, and refer to them as in scene = \"scenes/{}.toml\"\n",
                                                  name, name)));
  }
  EXPECT_TRUE(contains(outcome.err,
                       "newer.toml:1:10: the key format: is 2, but this program only knows format 1; a "
                       "newer version may read it\n"))
      << "it names a scene: a case";
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << outcome.err;
}

TEST(Check, SaysWhatACaseIsThatIsNoFile) {
  const Cases cases({{"good", std::string(small_case)}});
  fs::create_directory(cases / "folder.toml");
  fs::create_symlink("nothing.toml", cases / "link.toml");
  ASSERT_EQ(mkfifo((cases / "pipe.toml").c_str(), 0600), 0);
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "folder.toml: is a folder, but a case must be a file; rename it, or remove it"));
  EXPECT_TRUE(contains(outcome.err, "link.toml: is a broken link"));
  EXPECT_TRUE(contains(outcome.err, "pipe.toml: is a pipe"));
}

TEST(Check, NamesASceneAsThePersonWroteIt) {
  const Cases cases({{"a", "scene = \"wall46\"\n"},
                     {"b", "scene = \"scenes/mien.toml\"\n"},
                     {"c", "scene = \"scenes/wall46.toml\"\n"},
                     {"d", "scene = \"something else\"\n"},
                     {"wall46x", std::string(small_case)}});
  fs::create_directory(cases / "scenes");
  write_whole(cases / "scenes/mine.toml", "");
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* words :
       {"a.toml:1:9: the key scene: no scene named 'wall46'; did you mean 'wall45'?\n",
        "b.toml:1:9: the key scene: there is no file 'scenes/mien.toml'; did you mean "
        "'scenes/mine.toml'?\n",
        "c.toml:1:9: the key scene: there is no file 'scenes/wall46.toml'; did you mean 'wall45'?\n",
        "d.toml:1:9: the key scene: no scene named 'something else'; give a path relative to this "
        "file, or one of arm, changing-hand, "}) {
    EXPECT_TRUE(contains(outcome.err, words));
  }
}

TEST(Check, RefusesANameThatAReportCannotAddTo) {
  const Cases cases(std::map<std::string, std::string>{{std::string(245, 'a'), std::string(small_case)}});
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "the name has 245 bytes"));
  EXPECT_FALSE(fs::exists(cases.beside("report")));
}

TEST(Check, NamesTheCaseWhoseLoopIsUnstable) {
  const Cases cases(
      {{"good", std::string(small_case)},
       {"wild", std::string(small_case) + "set = [\"rendering.k_r_N_per_m=1e6\", \"device.mass_kg=0.001\"]\n"}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "wild.toml: "));
  EXPECT_TRUE(contains(outcome.err, "unstable"));
  EXPECT_EQ(outcome.out, "");
}

TEST(Check, FindsASceneBesideItsCase) {
  const Cases cases({{"mine", replaced(std::string(small_case), "wall45", "../scenes/mine.toml")},
                     {"shipped", std::string(small_case) + "match = \"mine\"\n"}});
  fs::create_directory(cases.beside("scenes"));
  fs::copy_file(source_path("/assets/scenes/wall45.toml"), cases.beside("scenes/mine.toml"));
  EXPECT_EQ(cases.check({"--only", "shipped"}).exit_code, 0);
}

TEST(Check, RefusesFoldersAndNamesThatAreNot) {
  const Cases cases({{"wall45-naive", std::string(small_case)}});
  fs::create_directory(cases.beside("pictures"));
  const auto refusal = [](std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_TRUE(contains(refusal({cases.beside("picture")}), "did you mean '" + cases.beside("pictures") + "'?"));
  EXPECT_TRUE(contains(refusal({cases.beside("pictures")}), "there is no case in"));
  EXPECT_TRUE(contains(refusal({cases / "wall45-naive.toml"}), "is not a folder"));
  for (const char* option : {"--only", "--update"}) {
    EXPECT_TRUE(contains(refusal({cases.path(), option, "wall45-naiv"}),
                         fmt::format("{} wall45-naiv: there is no such case; did you mean 'wall45-naive'?", option)));
  }
  refusal({cases.path(), "--only"});
  refusal({cases.path(), "--only", "wall45-naive", "--update", "wall45-naive"});
  refusal({cases.path(), "--report", cases.beside("report"), "--update", "wall45-naive"});
  refusal({});
  EXPECT_EQ(cases.files().size(), 1U);
}

TEST(Check, ChecksOnlyWhatItIsAskedFor) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}, {"c", std::string(small_case)}});
  ASSERT_EQ(cases.check({"--update", "a", "c"}).exit_code, 0);
  EXPECT_EQ(cases.check({"--only", "c", "a"}).out, "pass a\npass c\n2 cases, 0 failed\n");
  write_whole(cases / ".hidden.toml", "an editor's");
  EXPECT_EQ(cases.check({"--only", "b"}).exit_code, 1);
}

TEST(Check, KeepsItsExitCodeWhenNobodyReadsOn) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 8; ++i) texts.emplace(fmt::format("case{}", i), small_case);
  const Cases cases(texts);
  ProgramCall call;
  call.words = {"check", cases.path()};
  call.close_after_first_piece = true;
  EXPECT_EQ(run_ghostforce(call).exit_code, 1);
}

// Words are lost on a reader who has gone, or on a full disk; the answer is not.
TEST(Check, KeepsItsExitCodeWhenNobodyReadsItsWords) {
  const Cases cases({{"new", std::string(small_case)}});
  const std::string check = fmt::format("{} check {}", ghostforce_program(), cases.path());
  const std::string pipe = cases.beside("pipe");
  // A pipe that nobody reads any more.
  const std::string to_nobody = fmt::format("mkfifo {0}; exec 3<>{0} 4>{0} 3<&-; {1} 2>&4", pipe, check);
  for (const std::string& words : {to_nobody, check + " 2>/dev/full", check + " 2>&-"}) {
    EXPECT_EQ(run_program("/bin/sh", {"-c", words}).exit_code, 1) << words;
  }
}

TEST(Check, LeavesNothingBehindWhenInterrupted) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 60; ++i) texts.emplace(fmt::format("case{}", i), small_case);
  const Cases cases(texts);
  const std::string report = cases.beside("report");
  fs::create_directory(report);
  ProgramCall call;
  call.words = {"check", cases.path(), "--report", report};
  call.signal_when_created_in = report;
  call.signal = SIGINT;
  EXPECT_EQ(run_ghostforce(call).exit_code, 130);
  EXPECT_EQ(Cases::files_in(report), std::set<std::string>{});
  EXPECT_EQ(cases.files().size(), 60U);
}

TEST(CheckUpdate, LeavesNothingBehindWhenInterrupted) {
  // Ten million ticks: long enough to be met in the middle.
  const std::string endless = std::string(small_case) + "set = [\"goal.duration_s=10000\"]\n";
  const Cases cases({{"a", std::string(small_case)}, {"b", endless}, {"c", endless}, {"d", endless}});
  const Outcome outcome =
      run_program("/usr/bin/timeout", {"--preserve-status", "-s", "INT", "0.3", ghostforce_program(), "check",
                                       cases.path(), "--update", "a", "b", "c", "d"});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(cases.files(), (std::set<std::string>{"a.toml", "b.toml", "c.toml", "d.toml"}));
  EXPECT_EQ(read_whole(cases / "b.toml"), endless);
}

TEST(Check, SaysWhatIsMissingWhereThereIsNoOpenGl) {
  const NoOpenGl no_opengl;
  const Cases cases({{"a", std::string(small_case)}});
  const Outcome outcome = cases.check_with({no_opengl.variable()});
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_TRUE(contains(outcome.err, "pictures cannot be drawn here"));
}

TEST(UpdateCommand, TakesNothingForAnOption) {
  EXPECT_EQ(update_command("-d", "-n"), "ghostforce check ./-d --update=-n");
}

TEST(GoldenOrigin, IsReadFromWhatOpenGlSaysOfItself) {
  const GoldenOrigin origin = present_origin("llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile) Mesa 22.3.6");
  EXPECT_EQ(origin.renderer, "llvmpipe (LLVM 15.0.6)");
  EXPECT_EQ(origin.mesa, "22.3.6");
  EXPECT_EQ(present_origin("softpipe, OpenGL 3.3 (Core Profile) Mesa 24.0.0-devel (git-1)").mesa, "24.0.0-devel");
  EXPECT_EQ(present_origin("Other GPU, 2 bits, OpenGL 4.6").renderer, "Other GPU, 2 bits");
  EXPECT_EQ(present_origin("Other GPU, OpenGL 4.6").mesa, "");
  EXPECT_EQ(other_renderer_words(origin, {"llvmpipe (LLVM 15.0.6)", "22.3.6", "9.9"}), "")
      << "another program draws alike";
  EXPECT_EQ(other_renderer_words({}, origin), "") << "nothing is known";
  EXPECT_NE(other_renderer_words(origin, {"softpipe", "22.3.6", "0.1"}), "");
}

// No machine of the tests needs to have a graphics card.
TEST(GraphicsCardTolerance, IsForGoldensOfOthersWhereTheCaseStatesNone) {
  const Cases cases({{"plain", std::string(small_case)},
                     {"own", std::string(small_case) + "[tolerance]\nchannel = 1\n"},
                     {"match", std::string(small_case) + "match = \"plain\"\n"}});
  const GoldenOrigin software{"llvmpipe (LLVM 15.0.6)", "22.3.6", "0.1"};
  const GoldenOrigin card{"Some card", "", "0.1"};
  const std::vector<Case> all = read_case_folder(cases.path());
  const auto applies = [&](const char* name, std::optional<Renderer> renderer, const GoldenOrigin& golden) {
    Case checked = *find_case(all, name);
    checked.origin = golden;
    return is_for_graphics_card(checked, renderer, card);
  };
  EXPECT_TRUE(applies("plain", Renderer::gpu, software));
  EXPECT_FALSE(applies("plain", Renderer::gpu, card));
  EXPECT_FALSE(applies("own", Renderer::gpu, software));
  EXPECT_FALSE(applies("match", Renderer::gpu, software));
  EXPECT_FALSE(applies("plain", Renderer::egl, software));
  EXPECT_FALSE(applies("plain", std::nullopt, software));
}

}  // namespace
}  // namespace ghostforce::check_folder_test
