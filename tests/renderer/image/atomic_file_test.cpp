// A file is written completely, or its place is left unchanged.
#include "renderer/image/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace isl::render::test {
namespace {

namespace fs = std::filesystem;

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

class AtomicFile : public testing::Test {
 public:
  ~AtomicFile() override { fs::remove_all(folder_); }

 protected:
  AtomicFile() : folder_(fs::temp_directory_path() / ("isl_atomic_file_test." + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }

  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string write(const std::string& file, const std::string& text) {
    const std::vector<unsigned char> bytes(text.begin(), text.end());
    return write_atomically(file, bytes);
  }

  fs::path folder_;
};

TEST_F(AtomicFile, holds_what_was_written) {
  EXPECT_EQ(write(path("a"), "one"), "");
  EXPECT_EQ(content(path("a")), "one");
  EXPECT_EQ(write(path("a"), "two"), "");
  EXPECT_EQ(content(path("a")), "two");
  EXPECT_EQ(files_in_folder(), 1u) << "nothing else is left";
}

TEST_F(AtomicFile, trying_a_place_leaves_nothing) {
  EXPECT_EQ(why_not_writable(path("new")), "");
  EXPECT_EQ(files_in_folder(), 0u);
  EXPECT_EQ(write(path("old"), "old"), "");
  EXPECT_EQ(why_not_writable(path("old")), "");
  EXPECT_EQ(content(path("old")), "old");
}

TEST_F(AtomicFile, says_why_a_place_is_none) {
  EXPECT_EQ(why_not_writable(path("none/a")), "cannot write " + path("none/a") + ": No such file or directory");
  EXPECT_EQ(why_not_writable(folder_.string()), "cannot write " + folder_.string() + ": it is a folder");
  EXPECT_EQ(why_not_writable("/dev/null"), "cannot write /dev/null: it is not an ordinary file");
  EXPECT_EQ(write("/dev/null", "x"), "cannot write /dev/null: it is not an ordinary file");
}

TEST_F(AtomicFile, a_failed_writing_leaves_the_old_file) {
  EXPECT_EQ(write(path("a"), "old"), "");
  const SizeLimit limit(2);
  EXPECT_NE(write(path("a"), "longer than the limit"), "");
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(files_in_folder(), 1u) << "the half-written file is gone";
}

TEST_F(AtomicFile, a_staged_file_shows_only_when_it_takes_its_place) {
  EXPECT_EQ(write(path("a"), "old"), "");
  const std::vector<unsigned char> bytes{'n', 'e', 'w'};
  {
    const StagedFile dropped(path("a"), bytes);
    EXPECT_EQ(dropped.error(), "");
    EXPECT_EQ(content(path("a")), "old");
    EXPECT_EQ(files_in_folder(), 2u);
  }
  EXPECT_EQ(files_in_folder(), 1u) << "a file that did not take its place is removed";
  StagedFile kept(path("a"), bytes);
  EXPECT_EQ(kept.take_place(), "");
  EXPECT_EQ(content(path("a")), "new");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFile, tells_when_the_place_was_taken_meanwhile) {
  const std::vector<unsigned char> bytes{'n', 'e', 'w'};
  StagedFile file(path("a"), bytes);
  fs::create_directory(path("a"));
  EXPECT_EQ(file.take_place(), "cannot replace " + path("a") + ": Is a directory");
  EXPECT_TRUE(fs::is_directory(path("a")));
}

TEST_F(AtomicFile, follows_a_link_and_keeps_it) {
  EXPECT_EQ(write(path("real"), "old"), "");
  fs::create_symlink("real", folder_ / "link");
  EXPECT_EQ(write(path("link"), "new"), "");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content(path("real")), "new");
}

TEST_F(AtomicFile, keeps_the_permissions_of_what_it_replaces) {
  EXPECT_EQ(write(path("a"), "old"), "");
  fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(write(path("a"), "new"), "");
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace
}  // namespace isl::render::test
