// Outputs clash with inputs and with each other, by identity; inputs do not.
#include "base/files/file_register.h"

#include <gtest/gtest.h>

namespace isl {
namespace {

const FileIdentity kOld{"/f/old", 1, 7};
const FileIdentity kOldAgain{"/f/hard", 1, 7};
const FileIdentity kNew{"/f/new", 0, 0};

TEST(FileRegister, AnInputMayHaveManyNamesAndReaders) {
  FileRegister files;
  EXPECT_EQ(files.add_input(kOld, "the scene"), nullptr);
  EXPECT_EQ(files.add_input(kOld, "an input"), nullptr);
  EXPECT_EQ(files.add_input(kOldAgain, "an input"), nullptr);
}

TEST(FileRegister, AnOutputClashesWithEveryOtherUse) {
  FileRegister files;
  ASSERT_EQ(files.add_input(kOld, "the scene"), nullptr);
  ASSERT_NE(files.add_output(kOldAgain, "-o hard"), nullptr);
  EXPECT_EQ(files.add_output(kOldAgain, "-o hard")->role, "the scene");
  EXPECT_EQ(files.add_output(kNew, "-o new"), nullptr);
  ASSERT_NE(files.add_output(kNew, "--stats new"), nullptr);
  EXPECT_EQ(files.add_output(kNew, "--stats new")->role, "-o new");
  ASSERT_NE(files.add_input({"/f/new", 1, 9}, "an input"), nullptr) << "it has come into being meanwhile";
  EXPECT_TRUE(files.add_input(kNew, "an input")->is_output());
}

TEST(FileRegister, FilesOfOneInodeOnTwoDevicesDiffer) {
  FileRegister files;
  ASSERT_EQ(files.add_input(kOld, "the scene"), nullptr);
  EXPECT_EQ(files.add_output({"/g/old", 2, 7}, "-o old"), nullptr);
}

TEST(FileRegister, StreamsWithoutANameAreKnownByTheirInode) {
  FileRegister files;
  ASSERT_EQ(files.add_output({{}, 1, 7}, "-o png:-"), nullptr);
  EXPECT_NE(files.add_output(kOld, "-o old"), nullptr);
  EXPECT_EQ(files.add_output({{}, 1, 8}, "another"), nullptr);
}

}  // namespace
}  // namespace isl
