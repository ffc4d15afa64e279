#include "grammar/readable_folders.h"

#include "tests/grammar/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

TEST(WorkingTree, IsTheNearestFolderAboveWithVersionControl) {
  const TemporaryFolder folder;
  EXPECT_EQ(working_tree_of(folder.path()), fs::path());
  for (const char* const mark : {".git", ".hg", ".svn"}) {
    const fs::path root = folder.path() / mark / "tree";
    fs::create_directories(root / mark);
    fs::create_directories(root / "a/b");
    EXPECT_EQ(working_tree_of(root), root) << mark;
    EXPECT_EQ(working_tree_of(root / "a/b"), root) << mark;
    fs::create_directories(root / "a/.git");
    EXPECT_EQ(working_tree_of(root / "a/b"), root / "a") << mark;
  }
}

TEST(WorkingTree, MayBeASubmoduleWhoseMarkIsAFile) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "tree/.git");
  folder.write("tree/module/.git", "gitdir: ../.git/modules/module");
  fs::create_directories(folder.path() / "tree/module/scenes");
  EXPECT_EQ(working_tree_of(folder.path() / "tree/module/scenes"), folder.path() / "tree/module");
}

TEST(WorkingTree, IsNeverTheHomeFolderNorWhatHoldsIt) {
  const TemporaryFolder folder;
  const fs::path home = folder.path() / "home";
  fs::create_directories(home / ".git");
  fs::create_directories(home / "scenes");
  const char* const before = std::getenv("HOME");
  const std::string kept = before == nullptr ? "" : before;
  fs::create_directory_symlink(home, folder.path() / "link_to_home");
  setenv("HOME", (folder.path() / "link_to_home").c_str(), 1);
  EXPECT_EQ(working_tree_of(home / "scenes"), fs::path());
  fs::remove(home / ".git");
  fs::create_directory(folder.path() / ".git");
  EXPECT_EQ(working_tree_of(home / "scenes"), fs::path());
  setenv("HOME", "/nowhere", 1);
  EXPECT_EQ(working_tree_of(home / "scenes"), folder.path()) << "it is the home folder that made the difference";
  setenv("HOME", kept.c_str(), 1);
}

TEST(WorkingTree, IsNeitherTheRootNorOpenToEverybody) {
  const TemporaryFolder folder;
  EXPECT_FALSE(may_be_project("/", "/home/someone"));
  EXPECT_TRUE(may_be_project(folder.path(), "/home/someone"));
  fs::permissions(folder.path(), fs::perms::all | fs::perms::sticky_bit);
  EXPECT_FALSE(may_be_project(folder.path(), "/home/someone"));
}

TEST(ReadableFolders, HoldNoVersionControl) {
  const TemporaryFolder folder;
  for (const char* const name : {".git/hooks", "sub/.git", ".hg", ".svn", ".GIT"}) {
    fs::create_directories(folder.path() / name);
    ReadableFolders readable;
    readable.add(folder.path());
    EXPECT_EQ(readable.judge(folder.path() / name / "config").folder, nullptr) << name;
    EXPECT_TRUE(readable.judge(folder.path() / name / "config").is_in_version_control) << name;
    readable.add(folder.path() / name);
    EXPECT_NE(readable.judge(folder.path() / name / "config").folder, nullptr) << name << " is named by the user";
  }
  ReadableFolders readable;
  readable.add(folder.path());
  EXPECT_NE(readable.judge(folder.path() / "a.git/.github").folder, nullptr) << "these are other names";
  EXPECT_FALSE(readable.judge("/etc/passwd").is_in_version_control);
}

}  // namespace
}  // namespace isl::grammar
