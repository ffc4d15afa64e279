// Temporary files of dead owners are removed, all others stay.
#include "base/files/temporary_file.h"

#include "tests/grammar/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <string>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// The id of a process that has just ended.
std::uint64_t dead_process() {
  const pid_t pid = fork();
  if (pid == 0) _exit(0);
  waitpid(pid, nullptr, 0);
  return static_cast<std::uint64_t>(pid);
}

double now() { return static_cast<double>(std::time(nullptr)); }

Owner dead_owner() {
  Owner owner = this_process();
  owner.pid = dead_process();
  return owner;
}

TEST(TemporaryFile, ANameTellsItsOwner) {
  const std::string name = temporary_name(this_process(), 12);
  EXPECT_LT(name.size(), 171u) << "file systems allow 255 bytes, some 143";
  ASSERT_TRUE(owner_of(name));
  EXPECT_EQ(*owner_of(name), this_process());
  for (const char* const other :
       {"", ".isl.", ".isl..tmp", ".isl.tmp", "a.png", ".isl.h.b.1.2.3.4.png", ".isl.h.b.1.x.3.4.tmp",
        ".isl.h.b.1.0.3.4.tmp", ".isl.h.b.1.-1.3.4.tmp", ".isl.h.b.1.99999999999.3.4.tmp"}) {
    EXPECT_FALSE(owner_of(other)) << other;
  }
}

TEST(TemporaryFile, ThisProcessLivesAndAnEndedOneDoesNot) {
  EXPECT_FALSE(is_dead(this_process(), now()));
  EXPECT_TRUE(is_dead(dead_owner(), now()));
  Owner first = this_process();
  first.pid = 1;  // it lives as long as the system; we may not send it signals
  first.start = this_process().start;
  EXPECT_TRUE(is_dead(first, now())) << "it began at another time: the id was used again";
}

TEST(TemporaryFile, AProcessThatCannotBeJudgedFromHereLives) {
  Owner elsewhere = dead_owner();
  elsewhere.host = "other-0123456789abcdef";
  EXPECT_FALSE(is_dead(elsewhere, now()));
  Owner container = dead_owner();
  container.pid_space += 1;
  EXPECT_FALSE(is_dead(container, now()));
}

TEST(TemporaryFile, AnotherBootsFilesAreLeftoversIfTheyAreOlderThanThisBoot) {
  Owner before = this_process();
  before.boot = "00000000-0000-0000-0000-000000000000";
  EXPECT_TRUE(is_dead(before, 1e9));
  EXPECT_FALSE(is_dead(before, now())) << "another machine of the same name and id is writing it";
}

TEST(TemporaryFile, OnlyFilesOfDeadOwnersAreRemoved) {
  const test::TemporaryFolder folder;
  Owner elsewhere = dead_owner();
  elsewhere.host = "other-0123456789abcdef";
  const std::string dead = temporary_name(dead_owner(), 0), living = temporary_name(this_process(), 0),
                    foreign = temporary_name(elsewhere, 0);
  for (const std::string& name : {dead, living, foreign, std::string("a.tmp")}) folder.write(name, "x");
  fs::create_directory(folder.path() / temporary_name(dead_owner(), 1));
  const int open_folder = open(folder.path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  remove_leftovers(open_folder);
  close(open_folder);
  EXPECT_FALSE(fs::exists(folder.path() / dead));
  EXPECT_TRUE(fs::exists(folder.path() / living));
  EXPECT_TRUE(fs::exists(folder.path() / foreign));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 4);
}

}  // namespace
}  // namespace isl
