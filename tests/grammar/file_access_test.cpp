// Attacks that the attack suite (tests/limits) cannot time: changes of the file system between finding a file and
// opening it.
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
  EXPECT_THAT(access_->find_writable("out.txt").problem.message, HasSubstr("it is an input of the scene"));
}

TEST_F(FileAccessTest, AFileThatTheRunWroteMayBeReadAndWrittenAgain) {
  for (const char* const text : {"one", "two"}) {
    const WritablePlace place = access_->find_writable("out.txt");
    ASSERT_EQ(place.problem.error, AccessError::none) << place.problem.message;
    EXPECT_EQ(access_->write(place, "out.txt", text), "");
    const FoundFile found = access_->find("out.txt", path("secret"));
    EXPECT_EQ(access_->read(found, kPlenty).text, text) << "whichever folder the request comes from";
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

TEST_F(FileAccessTest, AFolderOfTheWorkingTreeThatBecomesALinkIsNotFollowed) {
  fs::create_directories(path("tree/.git"));
  fs::create_directories(path("tree/scenes"));
  folder_.write("tree/lib/a.inc", "A");
  FileAccess access({}, {});
  access.set_scene_folder(path("tree/scenes"));
  const FoundFile found = access.find("../lib/a.inc", path("tree/scenes"));
  ASSERT_EQ(found.problem.error, AccessError::none) << found.problem.message;
  EXPECT_EQ(access.read(found, kPlenty).text, "A");
  fs::rename(path("tree/lib"), path("tree/elsewhere"));
  fs::create_directory_symlink(path("secret"), path("tree/lib"));
  EXPECT_EQ(access.find("../lib/a.inc", path("tree/scenes")).problem.error, AccessError::refused);
  fs::rename(path("tree"), path("old"));
  fs::create_directory_symlink(path("secret"), path("tree"));
  fs::create_directory(path("secret/scenes"));
  EXPECT_NE(access.find("../a.inc", path("tree/scenes")).problem.error, AccessError::none) << "it is another tree now";
}

TEST_F(FileAccessTest, NamesAreTheSameOnEveryMachine) {
  fs::create_directories(path("tree/.git"));
  folder_.write("tree/common.inc", "C");
  folder_.write("tree/scenes/inc/a.inc", "A");
  folder_.write("library/sub/b.inc", "B");
  FileAccess access({path("library")}, {});
  access.set_scene_folder(path("tree/scenes"));
  const auto name = [&](const fs::path& asked) {
    const FoundFile found = access.find(asked.string(), path("tree/scenes/inc"));
    EXPECT_EQ(found.problem.error, AccessError::none) << found.problem.message;
    return access.portable_name(found);
  };
  EXPECT_EQ(name("a.inc"), "inc/a.inc");
  EXPECT_EQ(name("inc/a.inc"), "inc/a.inc") << "the scene's folder is searched too";
  EXPECT_EQ(name(path("tree/scenes/inc/a.inc")), "inc/a.inc");
  EXPECT_EQ(name("sub/b.inc"), "sub/b.inc");
  EXPECT_EQ(name("../../common.inc"), "../common.inc");
  EXPECT_EQ(access.write(FileAccess::in_memory("x.txt"), "x.txt", "kept"), "");
  EXPECT_EQ(name("x.txt"), "") << "a run's own file is no input";
}

TEST_F(FileAccessTest, TheFileThatIsMeantIsNamed) {
  folder_.write("scenes/Maps/Wood.png", "W");
  const auto hint = [&](const char* name) { return access_->find(name, path("scenes")).problem.hint; };
  EXPECT_THAT(hint("Inner/A.INC"), HasSubstr("there is `inner/a.inc` in"));
  EXPECT_THAT(hint("Inner/A.INC"), HasSubstr("file names distinguish capitals"));
  EXPECT_THAT(hint("maps\\wood.png"), HasSubstr("there is `Maps/Wood.png` in"));
  EXPECT_THAT(hint("inner\\a.inc"), HasSubstr("folders are separated by `/`"));
  EXPECT_THAT(hint("C:\\my pictures\\inner\\a.inc"), HasSubstr("separate folders by `/`"));
  EXPECT_THAT(hint("nothing.inc"), HasSubstr("looked for it in"));
  folder_.write("secret/other.inc", "Secret");
  EXPECT_THAT(hint("../Secret/OTHER.inc"), testing::Not(HasSubstr("other.inc")))
      << "names outside the folders are not shown";
}

TEST_F(FileAccessTest, AFileBesideTheSceneIsNamedWhereAPathLeadsElsewhere) {
  folder_.write("scenes/wood.png", "W");
  for (const char* const name : {"C:\\my pictures\\Wood.png", "/home/someone/wood.png", "pictures/wood.png"}) {
    EXPECT_THAT(access_->find(name, path("scenes")).problem.hint, HasSubstr("there is `wood.png` in")) << name;
  }
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
