// The files of a run are written completely and take their places together, or their places are left unchanged.
#include "base/files/output_set.h"

#include "base/files/temporary_file.h"
#include "tests/grammar/temporary_folder.h"
#include "tests/support/environment.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>

namespace isl {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// While this object lives, no file of this process may grow beyond `bytes`, as on a full disk.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

class OutputSetTest : public testing::Test {
 protected:
  OutputSetTest() { fs::create_directory(path("out")); }

  [[nodiscard]] fs::path path(const fs::path& name) const { return folder_.path() / name; }
  static std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] std::size_t files_in(const char* name) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path(name)), fs::directory_iterator()));
  }
  static std::string stage(OutputSet& outputs, const fs::path& file, std::string_view text) {
    return outputs.stage(file, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  }
  static std::string write(const fs::path& file, std::string_view text) {
    OutputSet outputs;
    std::string problem = stage(outputs, file, text);
    for (const std::string& failure : outputs.commit()) problem += failure;
    return problem;
  }

  test::TemporaryFolder folder_;
  const test::EnvironmentVariable cache_{"XDG_CACHE_HOME", path("cache")};
  const test::EnvironmentVariable temporary_{"TMPDIR", path("tmp")};
  const test::EnvironmentVariable home_{"HOME", path("home")};
};

TEST_F(OutputSetTest, FilesHoldWhatWasWritten) {
  for (const char* const text : {"one", "two"}) {
    EXPECT_EQ(write(path("out/a"), text), "");
    EXPECT_EQ(content(path("out/a")), text);
  }
  EXPECT_EQ(files_in("out"), 1u) << "nothing else is left";
}

TEST_F(OutputSetTest, AllFilesTakeTheirPlacesTogether) {
  ASSERT_EQ(write(path("out/a"), "old"), "");
  fs::create_directory(path("other"));
  OutputSet outputs;
  EXPECT_EQ(stage(outputs, path("out/a"), "new"), "");
  EXPECT_EQ(stage(outputs, path("other/b"), "new"), "");
  EXPECT_EQ(content(path("out/a")), "old");
  EXPECT_FALSE(fs::exists(path("other/b")));
  EXPECT_THAT(outputs.commit(), IsEmpty());
  EXPECT_EQ(content(path("out/a")), "new");
  EXPECT_EQ(content(path("other/b")), "new");
  EXPECT_EQ(files_in("out") + files_in("other"), 2u);
}

TEST_F(OutputSetTest, WhatIsNotCommittedLeavesNothing) {
  ASSERT_EQ(write(path("out/a"), "old"), "");
  {
    OutputSet outputs;
    EXPECT_EQ(stage(outputs, path("out/a"), "new"), "");
    EXPECT_EQ(files_in("out"), 2u);
  }
  EXPECT_EQ(content(path("out/a")), "old");
  EXPECT_EQ(files_in("out"), 1u);
}

TEST_F(OutputSetTest, TryingAPlaceLeavesNothing) {
  OutputSet outputs;
  EXPECT_EQ(outputs.why_not_writable(path("out/new")), "");
  EXPECT_EQ(files_in("out"), 0u);
  const std::string none = path("none/a"), folder = path("out");
  EXPECT_EQ(outputs.why_not_writable(none), "cannot write " + none + ": there is no folder " + path("none").string());
  EXPECT_EQ(outputs.why_not_writable(folder), "cannot write " + folder + ": it is a folder");
  EXPECT_EQ(outputs.why_not_writable("/dev/null"), "cannot write /dev/null: it is not an ordinary file");
}

TEST_F(OutputSetTest, AFailedWritingLeavesTheOldFile) {
  ASSERT_EQ(write(path("out/a"), "old"), "");
  const SizeLimit limit(2);
  EXPECT_EQ(write(path("out/a"), "longer than the limit"),
            "cannot write " + path("out/a").string() + ": File too large; it could not be kept anywhere else");
  EXPECT_EQ(content(path("out/a")), "old");
  EXPECT_EQ(files_in("out"), 1u) << "the half-written file is gone";
  EXPECT_FALSE(fs::exists(path("cache"))) << "nor is anything left where it could not be kept";
}

TEST_F(OutputSetTest, AResultWhoseFolderIsGoneIsKeptElsewhere) {
  for (const char* const kept : {"cache/isl/a.png", "cache/isl/a-2.png"}) {
    const std::string problem = write(path("gone/a.png"), kept);
    EXPECT_THAT(problem,
                HasSubstr("there is no folder " + path("gone").string() + "; it is kept as " + path(kept).string()));
    EXPECT_EQ(content(path(kept)), kept);
    EXPECT_EQ(fs::status(path(kept)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  }
  folder_.write("file", "no folder");
  cache_.set(path("file"));
  fs::create_directory(path("tmp"));
  EXPECT_THAT(write(path("gone/a.png"), "x"), HasSubstr("it is kept as " + path("tmp/a.png").string()));
  temporary_.set(path("file"));
  fs::create_directory(path("home"));
  EXPECT_THAT(write(path("gone/a.png"), "x"), HasSubstr("it is kept as " + path("home/a.png").string()));
}

TEST_F(OutputSetTest, AResultWhosePlaceWasTakenMeanwhileIsKeptElsewhere) {
  OutputSet outputs;
  ASSERT_EQ(stage(outputs, path("out/a"), "new"), "");
  ASSERT_EQ(stage(outputs, path("out/b"), "new"), "");
  fs::create_directory(path("out/a"));
  EXPECT_THAT(outputs.commit(), ElementsAre("cannot replace " + path("out/a").string() +
                                            ": Is a directory; it is kept as " + path("cache/isl/a").string()));
  EXPECT_TRUE(fs::is_directory(path("out/a")));
  EXPECT_EQ(content(path("cache/isl/a")), "new");
  EXPECT_EQ(content(path("out/b")), "new") << "the others take their places all the same";
  EXPECT_EQ(files_in("out"), 2u);
}

TEST_F(OutputSetTest, ALinkIsFollowedAndKept) {
  ASSERT_EQ(write(path("out/real"), "old"), "");
  fs::create_symlink("real", path("out/link"));
  fs::create_symlink("new", path("out/dangling"));
  EXPECT_EQ(write(path("out/link"), "new"), "");
  EXPECT_EQ(write(path("out/dangling"), "first"), "");
  EXPECT_TRUE(fs::is_symlink(path("out/link")));
  EXPECT_TRUE(fs::is_symlink(path("out/dangling")));
  EXPECT_EQ(content(path("out/real")), "new");
  EXPECT_EQ(content(path("out/new")), "first");
}

TEST_F(OutputSetTest, ThePermissionsOfWhatIsReplacedStay) {
  ASSERT_EQ(write(path("out/a"), "old"), "");
  fs::permissions(path("out/a"), fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_EQ(write(path("out/a"), "new"), "");
  EXPECT_EQ(fs::status(path("out/a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputSetTest, ANameOfTheGreatestLengthCanBeWritten) {
  const std::string name = "out/" + std::string(255, 'n');
  EXPECT_EQ(write(path(name), "x"), "");
  EXPECT_EQ(content(path(name)), "x");
}

TEST_F(OutputSetTest, ManyFilesOfAFolderNeedOneDescriptor) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit few{64, before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);
  OutputSet outputs;
  const Descriptor open_folder(::open(path("out").c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  const auto folder = outputs.folder(open_folder, path("out"));
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(stage(outputs, path("out/a" + std::to_string(i)), "x"), "");
    ASSERT_EQ(outputs.stage_at(folder, "b" + std::to_string(i), {}), "");
  }
  EXPECT_FALSE(outputs.sync());
  EXPECT_THAT(outputs.commit(), IsEmpty());
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(files_in("out"), 400u);
}

TEST_F(OutputSetTest, WhatAKilledProcessLeftIsRemovedByTheNext) {
  const pid_t pid = fork();
  if (pid == 0) {
    // The child must not take over the parent's identity, which this_process() keeps: another program would have its
    // own.
    folder_.write("out/" + temporary_name({this_process().host, this_process().boot, this_process().pid_space,
                                           static_cast<std::uint64_t>(getpid()), 0},
                                          0),
                  "half");
    kill(getpid(), SIGKILL);
  }
  waitpid(pid, nullptr, 0);
  ASSERT_EQ(files_in("out"), 1u);
  EXPECT_EQ(write(path("out/a"), "new"), "");
  EXPECT_EQ(files_in("out"), 1u);
}

}  // namespace
}  // namespace isl
