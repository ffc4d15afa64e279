// All names of a file have one identity, whether the file exists or not.
#include "base/files/file_identity.h"

#include "tests/grammar/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace isl {
namespace {

namespace fs = std::filesystem;

class FileIdentityTest : public testing::Test {
 protected:
  FileIdentityTest() {
    folder_.write("sub/a", "a");
    fs::create_directory_symlink("sub", path("link"));
    fs::create_symlink("a", path("sub/soft"));
    fs::create_hard_link(path("sub/a"), path("hard"));
    fs::create_symlink("../new", path("sub/dangling"));
    fs::create_symlink("circle", path("circle"));
  }
  [[nodiscard]] fs::path path(const fs::path& name) const { return folder_.path() / name; }

  test::TemporaryFolder folder_;
};

TEST_F(FileIdentityTest, IsThatOfTheFileUnderAllItsNames) {
  const FileIdentity identity = identity_of(path("sub/a"));
  ASSERT_TRUE(identity.exists());
  for (const char* const name : {"sub/./a", "sub/../sub/a", "link/a", "sub/soft", "link/../sub/soft", "hard"}) {
    const FileIdentity other = identity_of(path(name));
    EXPECT_EQ(other.device, identity.device) << name;
    EXPECT_EQ(other.inode, identity.inode) << name;
  }
  EXPECT_EQ(identity_of(path("link/soft")).path, path("sub/a"));
}

TEST_F(FileIdentityTest, IsThePathOfAFileThatIsNotThereYet) {
  for (const char* const name : {"new", "./new", "sub/../new", "link/../new", "sub/dangling", "link/dangling"}) {
    const FileIdentity identity = identity_of(path(name));
    EXPECT_FALSE(identity.exists()) << name;
    EXPECT_EQ(identity.path, path("new")) << name;
  }
  EXPECT_EQ(identity_of(path("none/../none/a")).path, path("none/a"));
}

TEST_F(FileIdentityTest, RelativeNamesCountFromTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(path("sub"));
  EXPECT_EQ(identity_of("a").path, path("sub/a"));
  EXPECT_EQ(identity_of("../new").path, path("new"));
  fs::current_path(before);
}

TEST_F(FileIdentityTest, ACircleOfLinksEnds) { EXPECT_FALSE(identity_of(path("circle")).exists()); }

TEST_F(FileIdentityTest, OfAStreamIsThatOfItsFile) {
  const int file = open(path("hard").c_str(), O_RDONLY | O_CLOEXEC);
  const int device = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const auto identity = identity_of_stream(file);
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->inode, identity_of(path("sub/a")).inode);
  EXPECT_FALSE(identity_of_stream(device)) << "many outputs may go to a device";
  close(file);
  close(device);
  EXPECT_FALSE(identity_of_stream(file));
}

}  // namespace
}  // namespace isl
