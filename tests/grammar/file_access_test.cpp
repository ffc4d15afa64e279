// Attacks that the attack suite (tests/limits) cannot time: changes of the file system between finding a file and
// opening it.
#include "grammar/file_access.h"

#include "tests/grammar/temporary_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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
    access_.emplace(AllowedFolders{.write = {path("scenes")}}, outputs_);
    access_->set_scene_folder(path("scenes"));
  }
  [[nodiscard]] fs::path path(const fs::path& name) const { return folder_.path() / name; }

  /// Ends a run that wrote one file.
  void write(const WritablePlace& place, std::string_view name, std::string text) {
    access_->write(place, name, std::move(text), {});
    EXPECT_TRUE(access_->stage_written().empty());
    EXPECT_TRUE(outputs_->commit().empty());
  }

  TemporaryFolder folder_;
  std::shared_ptr<OutputSet> outputs_ = std::make_shared<OutputSet>();
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
  write(place, "out.txt", "written");
  EXPECT_EQ(content(path("secret/a.inc")), "Secret");
  EXPECT_EQ(content(path("scenes/out.txt")), "written");
}

TEST_F(FileAccessTest, AnotherNameOfAFileOutsideIsNotWrittenThrough) {
  fs::create_hard_link(path("secret/a.inc"), path("scenes/out.txt"));
  const WritablePlace place = access_->find_writable("out.txt");
  ASSERT_EQ(place.problem.error, AccessError::none);
  write(place, "out.txt", "written");
  EXPECT_EQ(content(path("secret/a.inc")), "Secret");
}

TEST_F(FileAccessTest, AnotherNameOfAnInputIsAnInput) {
  EXPECT_EQ(access_->add_input(identity_of(path("scenes/inner/a.inc")), "a.inc").error, AccessError::none);
  fs::create_hard_link(path("scenes/inner/a.inc"), path("scenes/out.txt"));
  EXPECT_THAT(access_->find_writable("out.txt").problem.message, HasSubstr("it is an input of the scene"));
}

TEST_F(FileAccessTest, AnOutputOfTheRunMayNotBeWritten) {
  ASSERT_EQ(outputs_->files().add_output(identity_of(path("scenes/out.txt")), "-o out.txt"), nullptr);
  EXPECT_THAT(access_->find_writable("inner/../out.txt").problem.message, HasSubstr("-o out.txt writes it, too"));
}

TEST_F(FileAccessTest, AFileThatTheRunWroteMayBeReadAndWrittenAgain) {
  folder_.write("scenes/out.txt", "old");
  fs::create_symlink("out.txt", path("scenes/link.txt"));
  for (const char* const text : {"one", "two"}) {
    const WritablePlace place = access_->find_writable("out.txt");
    ASSERT_EQ(place.problem.error, AccessError::none) << place.problem.message;
    access_->write(place, "out.txt", text, {});
    for (const char* const name : {"out.txt", "./out.txt", "inner/../out.txt", "link.txt"}) {
      const FoundFile found = access_->find(name, path("scenes"));
      EXPECT_EQ(access_->read(found, kPlenty).text, text) << name;
      EXPECT_TRUE(found.is_in_memory) << name;
    }
    EXPECT_EQ(access_->read_existing(place, kPlenty).text, text) << "for `append`";
    const FoundFile found = access_->find("out.txt", path("secret"));
    EXPECT_EQ(access_->read(found, kPlenty).text, text) << "whichever folder the request comes from";
    EXPECT_EQ(content(path("scenes/out.txt")), "old") << "the scene has not been read yet";
  }
  EXPECT_TRUE(access_->stage_written().empty());
  EXPECT_EQ(content(path("scenes/out.txt")), "old");
  EXPECT_TRUE(outputs_->commit().empty());
  EXPECT_EQ(content(path("scenes/out.txt")), "two");
}

TEST_F(FileAccessTest, PlacesAreCountedOnce) {
  for (const char* const name : {"a", "./a", "inner/../a", "b"}) {
    EXPECT_EQ(access_->find_writable(name).problem.error, AccessError::none);
  }
  EXPECT_EQ(access_->places_count(), 2u);
}

TEST_F(FileAccessTest, RelativeNamesGoToAnAllowedFolderWhereTheScenesIsNone) {
  fs::create_directory(path("out"));
  FileAccess access({.write = {path("out")}});
  access.set_scene_folder(path("scenes"));
  EXPECT_EQ(access.find_writable("x.txt").canonical, path("out/x.txt"));
  EXPECT_EQ(access.find_writable("../x.txt").problem.error, AccessError::refused);
}

TEST_F(FileAccessTest, WhatIsInMemoryIsFoundByItsName) {
  write(access_->in_memory("x.txt"), "x.txt", "kept");
  EXPECT_EQ(access_->read(access_->find("x.txt", path("scenes")), kPlenty).text, "kept");
  EXPECT_FALSE(fs::exists(path("scenes/x.txt")));
}

TEST_F(FileAccessTest, AFolderOfTheWorkingTreeThatBecomesALinkIsNotFollowed) {
  fs::create_directories(path("tree/.git"));
  fs::create_directories(path("tree/scenes"));
  folder_.write("tree/lib/a.inc", "A");
  FileAccess access({});
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
  FileAccess access({.search_path = {path("library")}});
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
  access.write(access.in_memory("x.txt"), "x.txt", "kept", {});
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
  EXPECT_EQ(hint("Maps/Wod.png"), "did you mean `Maps/Wood.png`?");
  folder_.write("secret/other.inc", "Secret");
  EXPECT_THAT(hint("../Secret/OTHER.inc"), testing::Not(HasSubstr("other.inc")))
      << "names outside the folders are not shown";
  EXPECT_THAT(hint("../secret/othr.inc"), testing::Not(HasSubstr("other.inc")));
}

TEST_F(FileAccessTest, AFileBesideTheSceneIsNamedWhereAPathLeadsElsewhere) {
  folder_.write("scenes/wood.png", "W");
  for (const char* const name : {"C:\\my pictures\\Wood.png", "/home/someone/wood.png", "pictures/wood.png"}) {
    EXPECT_THAT(access_->find(name, path("scenes")).problem.hint, HasSubstr("there is `wood.png` in")) << name;
  }
}

}  // namespace
}  // namespace isl::grammar
