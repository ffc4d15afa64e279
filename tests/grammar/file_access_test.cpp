// What the attack suite (tests/limits) cannot time: changes of the file system between finding a file and opening it.
#include "grammar/file_access.h"

#include "grammar/replace_file.h"
#include "tests/grammar/temporary_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr std::size_t kPlenty = 1 << 20;

std::string content(const fs::path& file) { return read_text_file(file, kPlenty).text; }

class FileAccessTest : public testing::Test {
 protected:
  FileAccessTest() {
    folder_.write("scenes/inner/a.inc", "A");
    folder_.write("secret/a.inc", "Secret");
    access_.emplace(std::vector<fs::path>{}, std::vector<fs::path>{path("scenes")});
    access_->set_scene_folder(path("scenes"));
  }
  [[nodiscard]] fs::path path(const fs::path& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
  std::optional<FileAccess> access_;
};

TEST_F(FileAccessTest, AFileThatBecomesALinkIsNotRead) {
  const FoundFile found = access_->find("inner/a.inc", path("scenes"));
  ASSERT_EQ(found.problem.error, AccessError::none);
  fs::remove(path("scenes/inner/a.inc"));
  fs::create_symlink(path("secret/a.inc"), path("scenes/inner/a.inc"));
  EXPECT_EQ(access_->read(found, kPlenty).text, "");
  EXPECT_NE(access_->read(found, kPlenty).trouble, "");
}

TEST_F(FileAccessTest, AFolderThatBecomesALinkIsNotFollowed) {
  const Folder scenes(path("scenes"));
  const fs::path inner = path("scenes/inner");
  EXPECT_TRUE(scenes.open_folder(inner).is_open());
  fs::rename(inner, path("scenes/elsewhere"));
  fs::create_directory_symlink(path("secret"), inner);
  EXPECT_FALSE(scenes.open_folder(inner).is_open());
}

TEST_F(FileAccessTest, AnAllowedFolderStaysTheOneThatWasAllowed) {
  fs::rename(path("scenes"), path("moved"));
  fs::create_directory_symlink(path("secret"), path("scenes"));
  const FoundFile found = access_->find("a.inc", path("scenes"));
  EXPECT_NE(found.problem.error, AccessError::none);
}

TEST_F(FileAccessTest, APlaceThatBecomesALinkIsReplacedAndNotWrittenThrough) {
  const WritablePlace place = access_->find_writable("out.txt");
  ASSERT_EQ(place.problem.error, AccessError::none);
  fs::create_symlink(path("secret/a.inc"), path("scenes/out.txt"));
  EXPECT_EQ(access_->write(place, "out.txt", "written"), "");
  EXPECT_EQ(content(path("secret/a.inc")), "Secret");
  EXPECT_EQ(content(path("scenes/out.txt")), "written");
}

TEST_F(FileAccessTest, AnotherNameOfAFileOutsideIsNotWrittenThrough) {
  fs::create_hard_link(path("secret/a.inc"), path("scenes/out.txt"));
  const WritablePlace place = access_->find_writable("out.txt");
  ASSERT_EQ(place.problem.error, AccessError::none);
  EXPECT_EQ(access_->write(place, "out.txt", "written"), "");
  EXPECT_EQ(content(path("secret/a.inc")), "Secret");
}

TEST_F(FileAccessTest, AnotherNameOfAnInputIsAnInput) {
  access_->add_input(stamp_of(path("scenes/inner/a.inc")));
  fs::create_hard_link(path("scenes/inner/a.inc"), path("scenes/out.txt"));
  EXPECT_THAT(access_->find_writable("out.txt").problem.message, HasSubstr("the scene is read from it"));
}

TEST_F(FileAccessTest, AFileThatTheRunWroteMayBeReadAndWrittenAgain) {
  for (const char* const text : {"one", "two"}) {
    const WritablePlace place = access_->find_writable("out.txt");
    ASSERT_EQ(place.problem.error, AccessError::none) << place.problem.message;
    EXPECT_EQ(access_->write(place, "out.txt", text), "");
    const FoundFile found = access_->find("out.txt", path("secret"));
    EXPECT_EQ(access_->read(found, kPlenty).text, text) << "asked from anywhere";
    access_->add_input(found.stamp);
  }
}

TEST_F(FileAccessTest, RelativeNamesGoToAnAllowedFolderWhereTheScenesIsNone) {
  fs::create_directory(path("out"));
  FileAccess access({}, {path("out")});
  access.set_scene_folder(path("scenes"));
  EXPECT_EQ(access.find_writable("x.txt").canonical, path("out/x.txt"));
  EXPECT_EQ(access.find_writable("../x.txt").problem.error, AccessError::refused);
}

TEST_F(FileAccessTest, WhatIsInMemoryIsFoundByItsName) {
  const WritablePlace place = FileAccess::in_memory("x.txt");
  EXPECT_EQ(access_->write(place, "x.txt", "kept"), "");
  EXPECT_EQ(access_->read(access_->find("x.txt", path("scenes")), kPlenty).text, "kept");
  EXPECT_FALSE(fs::exists(path("scenes/x.txt")));
}

TEST(ReplaceFile, KeepsPermissionsAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  const Descriptor open_folder(::open(folder.path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  EXPECT_EQ(replace_file(open_folder.get(), "a.txt", "new"), "");
  EXPECT_EQ(content(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_directory(folder.path() / "b");
  EXPECT_NE(replace_file(open_folder.get(), "b", "new"), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
}

}  // namespace
}  // namespace isl::grammar
