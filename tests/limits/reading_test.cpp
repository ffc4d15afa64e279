// A scene may not read files outside its folder and the search path, or anything that is not a regular file.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace isl::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Reading : public AttackTest {
 protected:
  Reading() {
    write("secret/key.inc", "#declare Key = \"opensesame\";");
    write("scenes/near.inc", "#declare Near = 1;");
    fs::create_symlink("../secret/key.inc", folder() / "scenes/link.inc");
    fs::create_symlink("link.inc", folder() / "scenes/link_to_link.inc");
    fs::create_directory_symlink("../secret", folder() / "scenes/linked");
    fs::create_symlink("/dev/zero", folder() / "scenes/zero.inc");
    fs::create_symlink("loop.inc", folder() / "scenes/loop.inc");
    fs::create_directory(folder() / "scenes/inner");
  }

  /// The messages of a scene in scenes/ that tries to use a file in every possible way.
  std::string try_reading(const std::string& name, const std::vector<std::string>& options = {}) {
    std::string said;
    for (const std::string use : {"#include {}", "#fopen F {} read #read (F, A)", "#declare N = {}; #include N"}) {
      write("scenes/scene.isl",
            fmt::format(fmt::runtime(use), '"' + name + '"') + "\n#ifdef (Key) #debug concat(\"leaked \", Key) #end");
      const ProcessResult result = check_file("scenes/scene.isl", options);
      EXPECT_EQ(result.exit_code, 1) << name << "\n" << result.err;
      EXPECT_THAT(result.err, Not(HasSubstr("opensesame"))) << name;
      said += result.err;
    }
    return said;
  }
};

TEST_F(Reading, NothingOutsideByAnyPath) {
  for (const std::string& name :
       {std::string("../secret/key.inc"), (folder() / "secret/key.inc").string(), std::string("link.inc"),
        std::string("link_to_link.inc"), std::string("linked/key.inc"), std::string("inner/../../secret/key.inc"),
        std::string("./.././secret//key.inc"), std::string("linked/../secret/key.inc"), std::string("/etc/passwd"),
        std::string("/proc/self/environ"), std::string("/proc/self/cwd/secret/key.inc"), std::string("/dev/zero"),
        std::string("zero.inc"), std::string("..")}) {
    const std::string said = try_reading(name);
    EXPECT_THAT(said, HasSubstr("is outside the folders that the scene may read")) << name;
    EXPECT_THAT(said, HasSubstr("allow its folder with `-I ")) << name;
  }
}

TEST_F(Reading, NotTheStandardInputByAnotherName) {
  for (const char* const name : {"/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"}) {
    EXPECT_THAT(try_reading(name), AnyOf(HasSubstr("is outside the folders"), HasSubstr("cannot find"))) << name;
  }
}

TEST_F(Reading, NoFolderPipeSocketOrLoop) {
  ASSERT_EQ(mkfifo((folder() / "scenes/pipe.inc").c_str(), 0600), 0);
  const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = (folder() / "scenes/socket.inc").string();
  ASSERT_LT(path.size(), sizeof address.sun_path);
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  ASSERT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT(try_reading("pipe.inc"), HasSubstr("it is not a regular file"));
  EXPECT_THAT(try_reading("socket.inc"), HasSubstr("it is not a regular file"));
  EXPECT_THAT(try_reading("inner"), HasSubstr("it is a folder"));
  EXPECT_THAT(try_reading("."), HasSubstr("it is a folder"));
  EXPECT_THAT(try_reading("loop.inc"), HasSubstr("cannot read"));
  EXPECT_THAT(try_reading(""), HasSubstr("the file name is empty"));
  close(descriptor);
}

TEST_F(Reading, NothingThroughAnIncludeThatLiesInALibrary) {
  write("library/lib.inc", "#include \"../secret/key.inc\"");
  write("scenes/scene.isl", "#include \"lib.inc\"");
  const ProcessResult result = check_file("scenes/scene.isl", {"-I", "library"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("is outside the folders"));
  EXPECT_THAT(result.err, HasSubstr("library/lib.inc:1:"));
}

TEST_F(Reading, WhetherAFileOutsideExistsIsNotTold) {
  write("scenes/scene.isl",
        "#debug concat(str(file_exists(\"near.inc\"), 0, 0), str(file_exists(\"../secret/key.inc\"), 0, 0), "
        "str(file_exists(\"link.inc\"), 0, 0), str(file_exists(\"/etc/passwd\"), 0, 0), \"\\n\")");
  EXPECT_THAT(check_file("scenes/scene.isl").err, HasSubstr("1000\n"));
}

TEST_F(Reading, WhatTheUserAllowsIsRead) {
  write("scenes/scene.isl", "#include \"key.inc\" #debug Key");
  EXPECT_THAT(check_file("scenes/scene.isl", {"-I", "secret"}).err, HasSubstr("opensesame"));
  setenv("ISL_PATH", (folder() / "secret").c_str(), 1);
  const ProcessResult by_environment = check_file("scenes/scene.isl");
  unsetenv("ISL_PATH");
  EXPECT_THAT(by_environment.err, HasSubstr("opensesame"));
  EXPECT_EQ(check_file("scenes/scene.isl").exit_code, 1);
}

TEST_F(Reading, AFileThatIsNoTextOrTooLargeIsRefused) {
  write("scenes/picture.inc", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  EXPECT_THAT(try_reading("picture.inc"), HasSubstr("not a text file"));
  write("scenes/large.inc", "");
  fs::resize_file(folder() / "scenes/large.inc", std::uintmax_t{400} << 30);  // a sparse file
  EXPECT_THAT(try_reading("large.inc"), HasSubstr("larger than"));
}

}  // namespace
}  // namespace isl::test
