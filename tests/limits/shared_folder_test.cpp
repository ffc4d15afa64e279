// What a user allows a scene to read beyond its own folder: --allow-read, the option that a refusal names, and a shared
// folder that was named once. No scene can allow itself anything.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

#include <cstdlib>

namespace isl::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class SharedFolder : public ProgramTest {
 public:
  SharedFolder() {
    setenv("XDG_STATE_HOME", (folder() / "state").c_str(), 1);
    write("project/common.inc", "#declare Common = 1;");
    write("project/other lib/more.inc", "#declare More = 1;");
    write("project/one/scene.isl", "#include \"../common.inc\"\nsphere { 0, Common }");
    write("project/two/scene.isl", "#include \"../common.inc\"\nsphere { 0, Common }");
    write("elsewhere/scene.isl", "#include \"../project/common.inc\"\nsphere { 0, Common }");
  }
  ~SharedFolder() override { unsetenv("XDG_STATE_HOME"); }

 protected:
  [[nodiscard]] ProcessResult check(const std::string& scene, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"check", scene});
    return run(options);
  }
  [[nodiscard]] bool is_read(const std::string& scene, std::vector<std::string> options = {}) const {
    return check(scene, std::move(options)).exit_code == 0;
  }
};

TEST_F(SharedFolder, ARefusalNamesTheOptionThatAllowsTheFile) {
  EXPECT_THAT(check("project/one/scene.isl").err, HasSubstr("hint: allow its folder with `-I project`"));
  EXPECT_TRUE(is_read("project/one/scene.isl", {"-I", "project"}));
  const ProcessResult inside = run({"check", "scene.isl"}, {.folder = folder() / "project/one"});
  EXPECT_THAT(inside.err, HasSubstr("hint: allow its folder with `-I ..`"));
  write("project/one/b.isl", "#include \"../other lib/more.inc\"");
  EXPECT_THAT(check("project/one/b.isl").err, HasSubstr("hint: allow its folder with `-I 'project/other lib'`"));
  write("project/one/c.isl", "#include \"/etc/passwd\"");
  EXPECT_THAT(check("project/one/c.isl").err, HasSubstr("hint: allow its folder with `-I /etc`"));
}

TEST_F(SharedFolder, AllowReadReadsWithoutSearching) {
  write("project/one/b.isl", "#include \"more.inc\"");
  const std::string lib = "project/other lib";
  EXPECT_TRUE(is_read("project/one/b.isl", {"-I", lib}));
  EXPECT_THAT(check("project/one/b.isl", {"--allow-read", lib}).err, HasSubstr("cannot find `more.inc`"));
  write("project/one/b.isl", "#include \"../other lib/more.inc\"");
  EXPECT_TRUE(is_read("project/one/b.isl", {"--allow-read", lib}));
  EXPECT_TRUE(is_read("project/one/b.isl", {"--allow-read", "project"}));
  EXPECT_FALSE(is_read("project/one/b.isl", {"--allow-read", "elsewhere"}));
  const ProcessResult missing = check("project/one/b.isl", {"--allow-read", "none"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err, HasSubstr("--allow-read: `none` is not a folder"));
}

TEST_F(SharedFolder, IsReadByItsScenesOnceItWasNamed) {
  write("project/isl.ini", "");
  EXPECT_FALSE(is_read("project/one/scene.isl")) << "the file alone, which may have come with the scene";
  EXPECT_FALSE(exists("state/isl/shared_folders"));
  const ProcessResult named = check("project/one/scene.isl", {"--allow-read", "project"});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_THAT(named.err, HasSubstr("from now on, every scene below it may read it"));
  EXPECT_EQ(read("state/isl/shared_folders"), (folder() / "project").string() + "\n");
  EXPECT_TRUE(is_read("project/one/scene.isl"));
  EXPECT_TRUE(is_read("project/two/scene.isl"));
  EXPECT_THAT(check("project/two/scene.isl", {"-I", "project"}).err, Not(HasSubstr("from now on"))) << "told once";
  EXPECT_EQ(read("state/isl/shared_folders"), (folder() / "project").string() + "\n");
}

TEST_F(SharedFolder, IsNotReadByScenesElsewhere) {
  write("project/isl.ini", "");
  EXPECT_TRUE(is_read("elsewhere/scene.isl", {"-I", "project"}));
  EXPECT_FALSE(is_read("elsewhere/scene.isl"));
  EXPECT_TRUE(is_read("project/one/scene.isl"));
  const ProcessResult piped =
      run({"check", "-"}, {.folder = folder() / "project/one", .input = "#include \"../common.inc\""});
  EXPECT_EQ(piped.exit_code, 1) << "standard input lies nowhere";
}

TEST_F(SharedFolder, NeedsItsMark) {
  EXPECT_TRUE(is_read("project/one/scene.isl", {"-I", "project"}));
  EXPECT_FALSE(exists("state/isl/shared_folders")) << "without a mark, nothing is remembered";
  write("project/isl.ini", "");
  EXPECT_TRUE(is_read("project/one/scene.isl", {"-I", "project"}));
  EXPECT_TRUE(is_read("project/one/scene.isl"));
  fs::remove(folder() / "project/isl.ini");
  EXPECT_FALSE(is_read("project/one/scene.isl"));
  fs::create_symlink("one/scene.isl", folder() / "project/isl.ini");
  EXPECT_FALSE(is_read("project/one/scene.isl")) << "a link is no mark";
}

TEST_F(SharedFolder, IsNotNamedByAnIniFileThatCameWithTheScene) {
  write("project/isl.ini", "");
  write("project/one/scene.ini", "Input_File_Name=scene.isl\nLibrary_Path=..\n");
  EXPECT_TRUE(is_read("project/one/scene.ini"));
  EXPECT_FALSE(exists("state/isl/shared_folders"));
  EXPECT_FALSE(is_read("project/one/scene.isl"));
}

TEST_F(SharedFolder, IsNotMarkedByAScene) {
  for (const char* const name : {"isl.ini", "ISL.INI", "one/../isl.ini"}) {
    write("project/scene.isl", fmt::format("#fopen F \"{}\" write #write (F, \"x\") #fclose F", name));
    const ProcessResult result = check("project/scene.isl", {"--allow-write", "project"});
    EXPECT_EQ(result.exit_code, 1) << name;
    EXPECT_THAT(result.err, HasSubstr("it decides which files other scenes may read"));
  }
  EXPECT_FALSE(exists("project/isl.ini"));
}

TEST_F(SharedFolder, IsNoFolderIntoWhichEverybodyMayWrite) {
  write("project/isl.ini", "");
  fs::permissions(folder() / "project", fs::perms::all | fs::perms::sticky_bit);
  EXPECT_TRUE(is_read("project/one/scene.isl", {"-I", "project"}));
  EXPECT_FALSE(is_read("project/one/scene.isl"));
}

TEST_F(SharedFolder, ThatCannotBeRememberedIsReadAllTheSame) {
  write("project/isl.ini", "");
  write("state", "a file where the folder would be");
  const ProcessResult result = check("project/one/scene.isl", {"-I", "project"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("cannot be remembered"));
}

}  // namespace
}  // namespace isl::test
