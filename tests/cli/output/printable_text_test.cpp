#include "cli/output/printable_text.h"

#include "cli/output/safe_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST(PrintableText, ShowsMarksThatTurnTextAround) {
  // ALM, LRM, RLM, LRE … RLO, LRI … PDI: all twelve of Unicode's bidirectional format characters.
  EXPECT_EQ(with_visible_controls("\u061C\u200E\u200F\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069"),
            "\\u061c\\u200e\\u200f\\u202a\\u202b\\u202c\\u202d\\u202e\\u2066\\u2067\\u2068\\u2069");
  EXPECT_EQ(with_visible_controls("\u200D\u202F\u2065\u206A\u061B\u00A0"), "\u200D\u202F\u2065\u206A\u061B\u00A0");
  EXPECT_EQ(printable("a\u202Eb\x1b"), "a\uFFFDb\uFFFD");
}

TEST(PrintableText, KeepsNamesInTheirLine) { EXPECT_EQ(visible_name("a\nb\tc\x1b"), "a\\x0ab\\x09c\\x1b"); }

TEST(PrintableText, MakesValidUtf8AndChangesNothingElse) {
  EXPECT_EQ(valid_utf8("a\x1b\u202E\n\xFF\xE9t"), "a\x1b\u202E\n\uFFFD\uFFFDt");
}

TEST(PrintableText, KeepsTheContentOfJson) {
  const nlohmann::json document{{"name", "K\u00FCche \x1b \x7F \u009B31m \u202E"}};
  const std::string text = json_with_visible_controls(document.dump());
  EXPECT_EQ(text, "{\"name\":\"K\u00FCche \\u001b \\u007f \\u009b31m \\u202e\"}");
  EXPECT_EQ(nlohmann::json::parse(text), document);
}

TEST(SafeText, HasOnlyTheStylesThatAreAdded) {
  SafeText text = SafeText::styled(Style::red, "a\x1b[2J");
  text += SafeText("b\u202E\n");
  EXPECT_EQ(text.text(), "\x1b[1;31ma\\x1b[2J\x1b[0mb\\u202e\n");
}

TEST(PrintableText, LeavesTextAsItIs) {
  EXPECT_EQ(with_visible_controls("a\tb\nKüche ☕ 𝄞 \\x1b"), "a\tb\nKüche ☕ 𝄞 \\x1b");
  EXPECT_EQ(with_visible_controls(""), "");
}

}  // namespace
}  // namespace isl::cli
