#include "grammar/text_file.h"

#include "tests/grammar/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace isl::grammar {
namespace {

using test::TemporaryFolder;

constexpr std::size_t kPlenty = 1 << 20;

TEST(TextFile, IsReadWhole) {
  const TemporaryFolder folder;
  const std::string text = std::string(200'000, 'a') + "\n";
  EXPECT_EQ(read_text_file(folder.write("a.isl", text), kPlenty).text, text);
}

TEST(TextFile, OfNoLengthIsEmptyAndFine) {
  const TemporaryFolder folder;
  const TextFile file = read_text_file(folder.write("a.isl", ""), kPlenty);
  EXPECT_TRUE(file.trouble.empty());
  EXPECT_TRUE(file.text.empty());
}

TEST(TextFile, ThatIsMissingSaysSo) {
  const TemporaryFolder folder;
  const TextFile file = read_text_file(folder.path() / "none.isl", kPlenty);
  EXPECT_FALSE(file.exists);
  EXPECT_FALSE(file.trouble.empty());
}

TEST(TextFile, IsNoFolderPipeOrDevice) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.isl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_text_file(pipe, kPlenty).trouble, "it is not a regular file") << "without waiting for a writer";
  EXPECT_EQ(read_text_file("/dev/zero", kPlenty).trouble, "it is not a regular file");
  EXPECT_EQ(read_text_file(folder.path(), kPlenty).trouble, "it is a folder");
}

TEST(TextFile, IsRefusedAboveItsLimit) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a.isl", std::string(1001, 'a'));
  EXPECT_FALSE(read_text_file(file, 1000).trouble.empty());
  EXPECT_TRUE(read_text_file(file, 1001).trouble.empty());
}

TEST(TextFile, IsNoBinary) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_text_file(folder.write("a", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)), kPlenty).trouble,
            "not a text file");
}

TEST(TextFile, InAWideEncodingIsNamedWithTheRemedy) {
  const TemporaryFolder folder;
  const auto trouble = [&](std::string_view bytes) {
    const TextFile file = read_text_file(folder.write("a", bytes), kPlenty);
    EXPECT_EQ(file.hint.empty(), file.trouble.empty());
    return file.trouble;
  };
  using namespace std::string_view_literals;
  EXPECT_EQ(trouble("\xFF\xFEs\0p\0h\0"sv), "it is UTF-16 text");
  EXPECT_EQ(trouble("\xFE\xFF\0s\0p\0h"sv), "it is UTF-16 text");
  EXPECT_EQ(trouble("\xFF\xFE\x2E\x73\x12\x61\x4B\x52"sv), "it is UTF-16 text") << "with only one byte below 32";
  EXPECT_EQ(trouble("s\0p\0h\0e\0r\0e\0"sv), "it is UTF-16 text") << "without a byte order mark";
  EXPECT_EQ(trouble("\0s\0p\0h\0e\0r\0e"sv), "it is UTF-16 text") << "without a byte order mark";
  EXPECT_EQ(trouble("\xFF\xFE\0\0s\0\0\0"sv), "it is UTF-32 text");
  EXPECT_EQ(trouble("\xEF\xBB\xBFsphere"sv), "") << "UTF-8 with a mark is read";
}

TEST(TextFile, MayBeOfAnyCodePageAndHaveAStrayByte) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_text_file(folder.write("a", "// \xCF\xF0\xE8\xE2\xE5\xF2 \xEC\xE8\xF0"), kPlenty).trouble.empty());
  EXPECT_TRUE(read_text_file(folder.write("b", std::string(100, 'a') + '\0'), kPlenty).trouble.empty());
}

}  // namespace
}  // namespace isl::grammar
