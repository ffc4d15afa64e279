#include "cli/output/printable_text.h"

#include <gtest/gtest.h>

namespace isl::cli {
namespace {

TEST(PrintableText, ShowsControlCharactersAsEscapes) {
  EXPECT_EQ(with_visible_controls("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
  EXPECT_EQ(with_visible_controls("over\rwritten\b\x7f"), "over\\x0dwritten\\x08\\x7f");
  EXPECT_EQ(with_visible_controls(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(with_visible_controls("\xC2\x9B"
                                  "31m"),
            "\\x9b31m")
      << "C1, as UTF-8";
  EXPECT_EQ(with_visible_controls("\x9B"
                                  "31m \xE9t\xE9"),
            "\\x9b31m \\xe9t\\xe9")
      << "bytes that are no UTF-8";
}

TEST(PrintableText, LeavesTextAsItIs) {
  EXPECT_EQ(with_visible_controls("a\tb\nKüche ☕ 𝄞 \\x1b"), "a\tb\nKüche ☕ 𝄞 \\x1b");
  EXPECT_EQ(with_visible_controls(""), "");
}

}  // namespace
}  // namespace isl::cli
