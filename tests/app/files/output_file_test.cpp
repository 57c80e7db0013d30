#include "app/files/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/file_calls.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::output_file_test {
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

// --- Power cuts ---

std::vector<std::string> sequence(const FileCalls& calls) {
  std::vector<std::string> words;
  for (const FileCall& one : calls.all()) {
    const std::string name = std::filesystem::path(one.path).filename();
    const bool is_part = name.starts_with(".ghostforce-");
    const bool is_folder = std::filesystem::is_directory(one.path);
    words.push_back(one.call + " " + (is_folder ? "the folder" : is_part ? std::to_string(one.bytes) : name));
  }
  return words;
}

// After a power cut a name may lead to what was there before, or to all of what was written.
TEST(OutputFile, IsOnTheDiskBeforeItsNameIs) {
  const TemporaryFolder folder;
  for (int i = 0; i < 2; ++i) {  // at first nothing is there
    const FileCalls calls;
    OutputFile file(folder / "run.csv");
    file.write(std::string(100'000, 'x'));
    file.commit();
    std::vector<std::string> wanted{"fsync 100000", "renameat2 run.csv", "fsync the folder"};
    if (i == 0) wanted.insert(wanted.begin() + 2, "rename run.csv");
    EXPECT_EQ(sequence(calls), wanted);
  }
}

TEST(OutputFile, InTheFolderOfToday) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const FileCalls calls;
  {
    OutputFile file("run.csv");
    file.commit();
  }
  std::filesystem::current_path(before);
  EXPECT_EQ(calls.count("fsync", std::filesystem::canonical(folder.path()).string()), 1);
}

TEST(OutputFile, SaysThatTheDiskFailed) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  write_whole(path, "old");
  FileCalls calls;
  const auto write = [&] {
    OutputFile file(path);
    file.write("new");
    file.commit();
  };
  for (const int error : {EIO, ENOSPC}) {
    calls.fail("fsync", error);
    try {
      write();
      ADD_FAILURE() << error;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::file_trouble);
      EXPECT_EQ(failure.what(), path + " cannot be written: " + reason_of(error));
    }
    EXPECT_EQ(read_whole(path), "old");
    EXPECT_EQ(folder.count(), 1);
  }
  // Not everything can be synchronised.
  for (const int error : {EINVAL, EROFS}) {
    calls.fail("fsync", error);
    write();
    EXPECT_EQ(read_whole(path), "new");
  }
}

TEST(OutputFolder, IsOnTheDiskWithAllItsNames) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "old");
  write_whole(folder / "old/b", "old");
  for (const std::string name : {"old", "new"}) {
    const FileCalls calls;
    OutputFolder files(folder / name);
    files.write("a", "1");
    files.write("b", "22");
    files.commit();
    const std::vector<std::string> words = sequence(calls);
    EXPECT_EQ((std::vector(words.begin(), words.begin() + 2)), (std::vector<std::string>{"fsync 1", "fsync 2"}));
    EXPECT_EQ(std::ranges::count(words, "fsync the folder"), name == "old" ? 1 : 2) << "and the new folder's own name";
    EXPECT_EQ(words.back(), "fsync the folder");
  }
}

// As in `simulate -o /dev/fd/3 3>>log`: what the shell has opened is written on.
TEST(OutputFile, WritesOnWhatIsOpenAlready) {
  const TemporaryFolder folder;
  const std::string path = folder / "log";
  write_whole(path, "before ");
  const int log = open(path.c_str(), O_WRONLY | O_APPEND);  // without O_CLOEXEC, as what comes from a shell
  const int own = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  ASSERT_GE(log, 0);
  for (const std::string place : {"/dev/fd/", "/proc/self/fd/"}) {
    OutputFile file(place + std::to_string(log));
    file.write("after ");
    file.commit();
    EXPECT_THROW(OutputFile(place + std::to_string(own)), Failure) << "what the program has opened for itself";
  }
  close(own);
  close(log);
  EXPECT_EQ(read_whole(path), "before after after ");
}

// --- What others left ---

// As one leaves them that is killed: without a lock.
TEST(OutputFile, RemovesWhatTheDeadLeftAndNothingElse) {
  const TemporaryFolder folder;
  const std::string alive = folder / ".ghostforce-1-1.part";
  write_whole(alive, "x");
  const int lock = open(alive.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
  const std::string dead = folder / ".ghostforce-1-0.part";  // process 1 lives
  write_whole(dead, "half");
  const std::vector<std::string> others{".ghostforce-notes.part", ".ghostforce-1-0.part.txt", "ghostforce-1-0.part"};
  for (const std::string& name : others) write_whole(folder / name, "mine");
  std::filesystem::create_directory(folder / ".ghostforce-2-0.part");
  ASSERT_EQ(mkfifo((folder / ".ghostforce-3-0.part").c_str(), 0600), 0);
  std::filesystem::create_symlink("ghostforce-1-0.part", folder / ".ghostforce-4-0.part");
  const std::ptrdiff_t before = folder.count();
  { const OutputFile file(folder / "run.csv"); }
  EXPECT_FALSE(std::filesystem::exists(dead));
  EXPECT_EQ(folder.count(), before - 1);
  for (const std::string& name : others) EXPECT_EQ(read_whole(folder / name), "mine") << name;
  EXPECT_EQ(read_whole(alive), "x");
  close(lock);
}

TEST(OutputFile, OfAKilledProgramGoesWithTheNextStart) {
  const TemporaryFolder folder;
  // Started and stopped in the midst of it; `part` is what it writes to.
  struct Stopped {
    std::unique_ptr<RunningProgram> program;
    std::string part;
  };
  const auto words = [&](const std::string& name, const std::string& seconds) {
    return std::vector<std::string>{"simulate", "wall45", "--set", "goal.duration_s=" + seconds, "-o", folder / name};
  };
  const auto start = [&](const std::string& name) {
    ProgramCall call;
    call.words = words(name, "9000");
    Stopped stopped{std::make_unique<RunningProgram>(ghostforce_program(), call), ""};
    while (stopped.part.empty()) {  // in vain: ctest ends the test
      for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        std::error_code has_just_gone;
        if (entry.file_size(has_just_gone) > 0 && !has_just_gone) stopped.part = entry.path();
      }
    }
    stopped.program->send(SIGSTOP);
    return stopped;
  };
  const Stopped killed = start("killed.csv");
  killed.program->send(SIGKILL);
  EXPECT_EQ(killed.program->wait_for_end(), 128 + SIGKILL);
  ASSERT_TRUE(std::filesystem::exists(killed.part));
  EXPECT_EQ(run_ghostforce(words("next.csv", "3")).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(killed.part));
  std::filesystem::remove(folder / "next.csv");

  const Stopped alive = start("alive.csv");
  EXPECT_EQ(run_ghostforce(words("next.csv", "3")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(alive.part));
  EXPECT_EQ(folder.count(), 2);
}

// --- All or none ---

TEST(OutputFolder, PutsBackWhatWasThereWhenOneCannotBePutInPlace) {
  const TemporaryFolder folder;
  const std::string path = folder / "in";
  std::filesystem::create_directory(path);
  for (const char* const name : {"/a", "/b", "/z"}) write_whole(path + name, "old");
  {
    OutputFolder files(path);
    for (const char* const name : {"a", "b", "new", "taken", "z"}) files.write(name, "new");
    std::filesystem::create_directory(path + "/taken");  // after they were looked at
    EXPECT_THROW(files.commit(), Failure);
  }
  for (const char* const name : {"/a", "/b", "/z"}) EXPECT_EQ(read_whole(path + name), "old") << name;
  EXPECT_FALSE(std::filesystem::exists(path + "/new"));
  EXPECT_TRUE(std::filesystem::is_directory(path + "/taken"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path), {}), 4) << "nothing else";
}

TEST(OutputFolder, PutsBackWhatWasThereWhenTheDiskFailsInTheEnd) {
  const TemporaryFolder folder;
  write_whole(folder / "a", "old");
  FileCalls calls;
  {
    OutputFolder files(folder.path());
    files.write("a", "new");
    files.write("b", "new");
    calls.fail("rename", EIO);  // of b, which is new; a was exchanged before
    EXPECT_THROW(files.commit(), Failure);
  }
  EXPECT_EQ(read_whole(folder / "a"), "old");
  EXPECT_EQ(folder.count(), 1);
}

// While the others come in, the old file has the temporary name, and another process may clean the folder.
TEST(OutputFile, GuardsTheOldFileUntilTheNewOneIsKept) {
  const TemporaryFolder folder;
  const std::string path = folder / "run.csv";
  write_whole(path, "old");
  {
    OutputFile file(path);
    file.write("new");
    file.finish();
    file.put_in_place();
    EXPECT_EQ(run_ghostforce({"simulate", "fig1", "-o", folder / "other.csv"}).exit_code, 0);
    EXPECT_EQ(read_whole(path), "new");
  }
  EXPECT_EQ(read_whole(path), "old");
  EXPECT_EQ(folder.count(), 2);
}

// Where names cannot be exchanged the new ones come in all the same.
TEST(OutputFolder, NeedsNoExchange) {
  const TemporaryFolder folder;
  write_whole(folder / "a", "old");
  FileCalls calls;
  calls.fail("renameat2", EINVAL);
  OutputFolder files(folder.path());
  files.write("a", "new");
  files.write("b", "new");
  files.commit();
  EXPECT_EQ(read_whole(folder / "a"), "new");
  EXPECT_EQ(read_whole(folder / "b"), "new");
  EXPECT_EQ(folder.count(), 2);
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
}  // namespace ghostforce::output_file_test
