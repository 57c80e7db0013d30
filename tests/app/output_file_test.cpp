#include "app/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/failure.h"
#include "app/output_folder.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

TEST(OutputFile, IsThereOnlyAfterCommit) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  {
    OutputFile file(path);
    file.write("a,");
    file.write("b\n");
    EXPECT_FALSE(std::filesystem::exists(path));
    file.commit();
    EXPECT_EQ(read_whole(path), "a,b\n");
  }
  EXPECT_EQ(folder.count(), 1) << "nothing else stays";
  const mode_t umask_now = umask(0);
  umask(umask_now);
  EXPECT_EQ(mode_of(path), 0666 & ~umask_now) << "as any program would have made it";
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { OutputFile(folder / "run.csv").write(std::string(1'000'000, 'x')); }
  EXPECT_EQ(folder.count(), 0);
}

TEST(OutputFile, KeepsTheOldFileUntilCommit) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  write_whole(path, "old");
  chmod(path.c_str(), 0640);
  { OutputFile(path).write("new"); }
  EXPECT_EQ(read_whole(path), "old");
  OutputFile file(path);
  file.write("new");
  EXPECT_EQ(read_whole(path), "old");
  file.commit();
  EXPECT_EQ(read_whole(path), "new");
  EXPECT_EQ(mode_of(path), 0640U) << "its permissions stay";
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, WritesWhereALinkPoints) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "far");
  std::filesystem::create_symlink("far/real.csv", folder / "link.csv");
  for (const std::string text : {"first", "second"}) {  // at first there is nothing at its end
    OutputFile file(folder / "link.csv");
    file.write(text);
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
    EXPECT_EQ(read_whole(folder / "far/real.csv"), text);
  }
}

TEST(OutputFile, TakesAnyAmount) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  std::string all;
  OutputFile file(path);
  for (int i = 0; i < 300; ++i) {
    const std::string piece(static_cast<std::size_t>(i * i), static_cast<char>('a' + i % 26));
    file.write(piece);
    all += piece;
  }
  file.commit();
  EXPECT_EQ(read_whole(path), all);
}

TEST(OutputFile, TakesTheLongestName) {
  const TemporaryFolder folder;
  OutputFile file(folder / std::string(255, 'n'));
  file.write("x");
  file.commit();
  EXPECT_EQ(read_whole(folder / std::string(255, 'n')), "x");
}

TEST(OutputFile, WritesIntoPipesAndLeavesThemInTheirPlace) {
  const TemporaryFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  OutputFile file(path);
  file.write("x");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_fifo(path));
  char c = 0;
  EXPECT_EQ(read(reader, &c, 1), 1);
  EXPECT_EQ(c, 'x');
  close(reader);
}

TEST(OutputFile, SaysAtOnceWhatCanNeverBe) {
  const TemporaryFolder folder;
  write_whole(folder / "file", "");
  const auto expect = [](const std::string& path, std::string_view words) {
    try {
      const OutputFile file(path);
      ADD_FAILURE() << path;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::file_trouble);
      EXPECT_EQ(failure.what(), path + " cannot be written: " + std::string(words));
    }
  };
  expect(folder / "none/run.csv", "No such file or directory; create the folder, or name another");
  expect(folder.path(), "Is a directory; name a file in it");
  expect(folder / "none/", "Is a directory; name a file in it");
  expect(folder / "file/run.csv", "Not a directory; name another");
  expect(folder / std::string(256, 'n'), "File name too long; choose a shorter one");
  expect("", "No such file or directory; create the folder, or name another");
  EXPECT_EQ(folder.count(), 1) << "nothing was left behind";
}

TEST(OutputFile, LeavesNothingWhenThereIsNoMoreRoom) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  try {
    const SmallFiles small(1000);
    OutputFile file(path);
    file.write(std::string(2000, 'x'));
    file.commit();
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::file_trouble);
    EXPECT_EQ(failure.what(), path + " cannot be written: File too large; name another");
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(OutputFolder, ReplacesNothingWhenThereIsNoMoreRoom) {
  const TemporaryFolder folder;
  for (const char* const name : {"a", "b", "c"}) write_whole(folder / name, "old");
  {
    const SmallFiles small(1000);
    OutputFolder files(folder.path());
    files.write("a", "new");
    files.write("b", std::string(2000, 'x'));
    files.write("c", "new");
    files.write("d", "new");
    EXPECT_THROW(files.commit(), Failure);
  }
  EXPECT_EQ(folder.count(), 3);
  for (const char* const name : {"a", "b", "c"}) EXPECT_EQ(read_whole(folder / name), "old") << name;
}

}  // namespace
}  // namespace ghostforce
