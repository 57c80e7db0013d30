// The one strict reader of TOML: what it tells, where, and what a program gets to know of it.
#include "app/files/toml_document.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/cli/command.h"

namespace ghostforce::toml_document_test {
namespace {

struct Shelf {
  double height = 2.0;
  int boards = 3;
  bool is_oak = false;
};

// Every problem; `shelf` has what is right.
std::vector<ReadProblem> problems_of(std::string_view text, Shelf& shelf) {
  const std::vector<TomlKey> keys{
      {"", "height_m", number_into(shelf.height, {0.5, 3.0, "m"}), "measure it"},
      {"", "boards", number_into(shelf.boards, {.least = 1.0, .greatest = 9.0, .whole = true})},
      {"wood", "oak", yes_or_no_into(shelf.is_oak)},
  };
  TomlReader reader("shelf.toml");
  if (reader.parse(text)) reader.read(keys);
  return reader.problems();
}

std::string words_about(std::string_view text) {
  Shelf shelf;
  const std::vector<ReadProblem> problems = problems_of(text, shelf);
  return problems.empty() ? "" : ReadError(ReadError::Kind::wrong, problems).what();
}

TEST(TomlReader, PutsEachValueInItsPlace) {
  Shelf shelf;
  EXPECT_TRUE(problems_of("height_m = 1\n[wood]\noak = true\n", shelf).empty());
  EXPECT_EQ(shelf.height, 1.0);
  EXPECT_EQ(shelf.boards, 3) << "nothing was said about them";
  EXPECT_TRUE(shelf.is_oak);
}

TEST(TomlReader, GivesPlaceFaultAndRemedySeparately) {
  Shelf shelf;
  const std::vector<ReadProblem> problems = problems_of("height_m = 1.0\nboards = 12\n", shelf);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].file, "shelf.toml");
  EXPECT_EQ(problems[0].line, 2U);
  EXPECT_EQ(problems[0].column, 10U);
  EXPECT_EQ(problems[0].what, "the key boards: 12 is out of range");
  EXPECT_EQ(problems[0].remedy, "give a whole number, 1 to 9");
}

TEST(TomlReader, TellsAllOfItInTheOrderOfTheFile) {
  EXPECT_EQ(words_about("hieght_m = 1\nboards = 1e9\n[woods]\n[[wood]]\n"),
            "shelf.toml:1:1: the key hieght_m is unknown; did you mean 'height_m'?\n"
            "shelf.toml:1:1: the key height_m is missing; measure it\n"
            "shelf.toml:2:10: the key boards: has a decimal point or an exponent; give a whole number, 1 to 9\n"
            "shelf.toml:3:2: the table [woods] is unknown; did you mean 'wood'?\n"
            "shelf.toml:4:3: wood is an array, but must be a table; write [wood] on a line of its own");
  EXPECT_EQ(words_about("height_m = 1\n[banana]\n"),
            "shelf.toml:2:2: the table [banana] is unknown; the tables are wood");
  EXPECT_EQ(
      words_about("height_m = 1\n[wood]\noak = 1\nboards = 2\n"),
      "shelf.toml:3:7: the key wood.oak: is a number; give true or false\n"
      "shelf.toml:4:1: the key wood.boards is unknown; did you mean 'boards'? It belongs before the first [table]");
}

// No double is exactly this number, which is one all the same.
TEST(TomlReader, TakesAnIntegerForANumberHoweverLongItIs) {
  EXPECT_EQ(words_about("height_m = 9223372036854775807\n"),
            "shelf.toml:1:12: the key height_m: 9.223372036854776e+18 is out of range; give 0.5 to 3 m");
}

// Rooms that somebody names, each with a list of shelves.
std::string words_about_house(std::string_view text, std::string* read = nullptr) {
  TomlReader reader("house.toml");
  double height = 0.0;
  const std::vector<TomlKey> shelf{{"", "height_m", number_into(height, {0.5, 3.0, "m"}), "measure it"}};
  const std::vector<TomlKey> room{{"", "shelf", [&](const TomlValue& shelves) {
                                     const std::size_t count = shelves.count("write [[ROOM.shelf]]").value_or(0);
                                     for (std::size_t i = 0; i < count; ++i) {
                                       if (shelves[i].read_table(shelf) && read) *read += std::to_string(height) + " ";
                                     }
                                   }}};
  const std::vector<TomlKey> house{{"", "floors", {}, "count them"}};
  if (reader.parse(text)) {
    reader.whole().read_table(house, [&](std::string_view name, const TomlValue& value) {
      if (read) read->append(name) += ": ";
      return value.is_table() && value.read_table(room);
    });
  }
  return reader.problems().empty() ? "" : ReadError(ReadError::Kind::wrong, reader.problems()).what();
}

TEST(TomlReader, ReadsTablesWithinTablesWhoeverNamesThem) {
  std::string read;
  EXPECT_EQ(words_about_house("floors = 2\n[[hall.shelf]]\nheight_m = 1\n[[hall.shelf]]\nheight_m = 2\n[attic]\n"
                              "shelf = [{ height_m = 0.5 }]\n",
                              &read),
            "");
  EXPECT_EQ(read, "attic: 0.500000 hall: 1.000000 2.000000 ");
}

TEST(TomlReader, TellsWhereInTablesWithinTablesSomethingIsWrong) {
  EXPECT_EQ(words_about_house("[[hall.shelf]]\nheight_m = 9\n\n[[hall.shelf]]\nhieght_m = 2\n[\"at\\u0007tic\"]\n"
                              "shelf = 2\n[cellar]\nshelf = [3]\nbox = 1\n"),
            "house.toml:1:1: the key floors is missing; count them\n"
            "house.toml:2:12: the key hall.shelf.height_m: 9 is out of range; give 0.5 to 3 m\n"
            "house.toml:4:1: the key hall.shelf.height_m is missing; measure it\n"
            "house.toml:5:1: the key hall.shelf.hieght_m is unknown; did you mean 'height_m'?\n"
            "house.toml:7:9: the key at\\x07tic.shelf: is a number; write [[ROOM.shelf]]\n"
            "house.toml:9:10: the key cellar.shelf: is a number; write a table with the keys height_m\n"
            "house.toml:10:1: the key cellar.box is unknown; the keys here are shelf");
  EXPECT_EQ(words_about_house("floors = 2\nhall = 3\n"),
            "house.toml:2:1: the key hall is unknown; the keys here are floors");
}

TEST(ReadError, HasOneExitCodeForEachOfItsKinds) {
  EXPECT_EQ(exit_code_of(ReadError::Kind::wrong), ExitCode::wrong_call);
  EXPECT_EQ(exit_code_of(ReadError::Kind::unreadable), ExitCode::file_trouble);
}

TEST(ReadError, NamesNoLineOfAFileAsAWhole) {
  EXPECT_EQ(words_of({.file = "a.toml", .what = "is a folder", .remedy = "name a file in it"}),
            "a.toml: is a folder; name a file in it");
  EXPECT_EQ(words_of({.file = "a.toml", .what = "cannot be read", .joint = " "}), "a.toml cannot be read");
  EXPECT_EQ(words_of({.what = "… and 3 more"}), "… and 3 more");
}

}  // namespace
}  // namespace ghostforce::toml_document_test
