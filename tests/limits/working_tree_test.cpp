// A scene in a working tree of version control may read that tree: an attack on each of its borders.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>

namespace isl::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class WorkingTree : public AttackTest {
 public:
  WorkingTree() {
    write("secret/key.inc", "#declare Key = \"opensesame\";");
    write("tree/.git/config", "#declare Key = \"opensesame\";");
    write("tree/common.inc", "#declare Common = \"common\";");
    write("tree/maps/paper.png", "a picture");
    fs::create_directories(folder() / "tree/scenes/inner");
  }
  ~WorkingTree() override { set_home(home_); }

 protected:
  static void set_home(const std::optional<std::string>& home) {
    if (home) {
      setenv("HOME", home->c_str(), 1);
    } else {
      unsetenv("HOME");
    }
  }

  /// The messages of a scene in tree/scenes/ that reads the file in every possible way, which must fail.
  std::string try_reading(const std::string& name) {
    std::string said;
    for (const std::string use :
         {"#include {}", "#fopen F {} read #read (F, A)", "pigment {{ image_map {{ png {} }} }}"}) {
      write("tree/scenes/scene.isl",
            fmt::format(fmt::runtime(use.starts_with("#") ? use : "#declare P = " + use), '"' + name + '"') +
                "\n#ifdef (Key) #debug concat(\"leaked \", Key) #end");
      const ProcessResult result = check_file("tree/scenes/scene.isl");
      EXPECT_EQ(result.exit_code, 1) << name << "\n" << result.err;
      EXPECT_THAT(result.err, Not(HasSubstr("opensesame"))) << name;
      said += result.err;
    }
    return said;
  }

 private:
  std::optional<std::string> home_ =
      std::getenv("HOME") ? std::optional<std::string>(std::getenv("HOME")) : std::nullopt;
};

TEST_F(WorkingTree, IsReadByIncludesAndPictures) {
  write(
      "tree/scenes/scene.isl",
      "#include \"../common.inc\" #debug Common\nsphere { 0, 1 pigment { image_map { png \"../maps/paper.png\" } } }");
  const ProcessResult result = check_file("tree/scenes/scene.isl", {"--without", "images"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("common"));
}

TEST_F(WorkingTree, IsReadNoFurther) {
  fs::create_symlink("../secret/key.inc", folder() / "tree/link.inc");
  fs::create_symlink("link.inc", folder() / "tree/link_to_link.inc");
  fs::create_directory_symlink("../secret", folder() / "tree/linked");
  fs::create_directory_symlink("../..", folder() / "tree/scenes/up");
  for (const std::string& name :
       {std::string("../../secret/key.inc"), std::string("../link.inc"), std::string("../link_to_link.inc"),
        std::string("../linked/key.inc"), std::string("inner/../../../secret/key.inc"),
        std::string("up/secret/key.inc"), std::string("../scenes/../../secret/key.inc"),
        (folder() / "secret/key.inc").string()}) {
    EXPECT_THAT(try_reading(name), HasSubstr("is outside the folders that the scene may read")) << name;
  }
}

TEST_F(WorkingTree, KeepsVersionControlToItself) {
  fs::create_symlink("../.git/config", folder() / "tree/scenes/link.inc");
  fs::create_directory_symlink("../.git", folder() / "tree/scenes/linked");
  write("tree/module/.git/config", "#declare Key = \"opensesame\";");
  write("tree/scenes/inner/.hg/hgrc", "#declare Key = \"opensesame\";");
  for (const char* const name : {"../.git/config", "link.inc", "linked/config", "../scenes/../.git/config",
                                 "../module/.git/config", "inner/.hg/hgrc"}) {
    EXPECT_THAT(try_reading(name), HasSubstr("belongs to version control")) << name;
  }
}

TEST_F(WorkingTree, KeepsVersionControlFromBeingWritten) {
  write("tree/scenes/scene.isl", "#fopen F \"../.git/config\" write #write (F, \"[core] fsmonitor = x\") #fclose F");
  const ProcessResult result = check_file("tree/scenes/scene.isl", {"--allow-write", "tree"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("belongs to version control"));
  EXPECT_EQ(read("tree/.git/config"), "#declare Key = \"opensesame\";");
}

TEST_F(WorkingTree, OfASubmoduleIsNotThatOfItsOwner) {
  write("tree/scenes/.git", "gitdir: ../.git/modules/scenes");
  write("tree/key.inc", "#declare Key = \"opensesame\";");
  EXPECT_THAT(try_reading("../key.inc"), HasSubstr("is outside the folders"));
  EXPECT_THAT(try_reading(".git"), HasSubstr("belongs to version control"));
}

TEST_F(WorkingTree, IsNeverTheHomeFolder) {
  write("tree/key.inc", "#declare Key = \"opensesame\";");
  set_home((folder() / "tree").string());
  EXPECT_THAT(try_reading("../key.inc"), HasSubstr("is outside the folders"));
  set_home((folder() / "tree/scenes").string());
  EXPECT_THAT(try_reading("../key.inc"), HasSubstr("is outside the folders"))
      << "nor is a folder that holds the home folder";
}

TEST_F(WorkingTree, IsNoFolderIntoWhichEverybodyMayWrite) {
  write("tree/key.inc", "#declare Key = \"opensesame\";");
  fs::permissions(folder() / "tree", fs::perms::all | fs::perms::sticky_bit);
  EXPECT_THAT(try_reading("../key.inc"), HasSubstr("is outside the folders"));
}

TEST_F(WorkingTree, DoesNotReachAboveTheNearest) {
  fs::create_directory(folder() / ".git");
  EXPECT_THAT(try_reading("../../secret/key.inc"), HasSubstr("is outside the folders"));
}

TEST_F(WorkingTree, IsNotThatOfTheFolderWhereStandardInputIsRead) {
  const ProcessResult result =
      run({"check", "-"}, {.folder = folder() / "tree/scenes", .input = "#include \"../common.inc\""});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("is outside the folders"));
}

}  // namespace
}  // namespace isl::test
