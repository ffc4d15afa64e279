// The lexer, through dump_tokens: one token a line, with its place.
#include "tests/grammar/parsed_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

using test::ParsedText;
using testing::HasSubstr;

TEST(Lexer, GivesEachTokenItsPlace) {
  ParsedText parsed("sphere {\n  Red 1.5\n}");
  EXPECT_EQ(parsed.tokens(), "1:1 word sphere\n1:8 {\n2:3 identifier Red\n2:7 number 1.5\n3:1 }\n");
}

TEST(Lexer, TakesADotForPartOfANumberOnlyBeforeADigit) {
  EXPECT_EQ(ParsedText("A.x").tokens(), "1:1 identifier A\n1:2 .\n1:3 constant x\n");
  EXPECT_EQ(ParsedText("A .5").tokens(), "1:1 identifier A\n1:3 number .5\n");
}

TEST(Lexer, PassesOverControlCharactersOfOldEditors) {
  EXPECT_EQ(ParsedText(std::string("A\r\f\v\0 B\x1a", 8)).tokens(), "1:1 identifier A\n2:5 identifier B\n");
}

TEST(Lexer, ReadsTokensOfAnyLength) {
  const std::string long_name(100'000, 'n');
  ParsedText parsed("/*" + std::string(1'000'000, ' ') + "*/ \"" + std::string(3'000'000, 'a') + "\" " + long_name);
  EXPECT_EQ(parsed.error_count(), 0u);
  EXPECT_EQ(as<String>(parsed.front()).text.size(), 3'000'000u);
  EXPECT_EQ(parsed.name(as<Name>(*parsed.items()[1]).name), long_name);
}

TEST(Lexer, KeepsBothReadingsOfAString) {
  const ParsedText parsed(R"("a\n\"\u00e9\\")");
  EXPECT_EQ(as<String>(parsed.front()).text, "a\n\"é\\");
  EXPECT_EQ(as<String>(parsed.front()).raw, R"(a\n\"\u00e9\\)");
}

TEST(Lexer, TakesEveryEndOfALineInAStringForALineFeed) {
  // The note about the lines precedes the string.
  const auto text = [](const std::string& string) {
    const ParsedText parsed(string);
    return std::string(as<String>(*parsed.items().back()).text);
  };
  for (const std::string end : {"\n", "\r", "\r\n", "\n\r"}) EXPECT_EQ(text("\"a" + end + "b\""), "a\nb");
  EXPECT_EQ(text("\"a\r\rb\""), "a\n\nb");
}

TEST(Lexer, EndsACommentWithItsLine) {
  for (const std::string end : {"\n", "\r", "\r\n", "\n\r"})
    EXPECT_EQ(ParsedText("// A" + end + "B").tokens(), "2:1 identifier B\n");
}

TEST(Lexer, FindsTheWordOfADirectiveInTheNextLine) {
  EXPECT_EQ(ParsedText("#\ndeclare A = 1;").error_count(), 0u);
  EXPECT_EQ(ParsedText("#\rdeclare A = 1;").error_count(), 0u);
}

TEST(Lexer, NamesABadCharacterWhole) {
  EXPECT_THAT(ParsedText("€").diagnostics().at(0).message, HasSubstr("`€`"));
  EXPECT_THAT(ParsedText("\xFF").diagnostics().at(0).message, HasSubstr("0xFF"));
}

TEST(Lexer, PointsToTheOpeningOfWhatIsNotClosed) {
  const ParsedText comment("A /* B");
  EXPECT_EQ(comment.text(comment.diagnostics().at(0).span), "/*");
  const ParsedText string("A \"B");
  EXPECT_EQ(string.text(string.diagnostics().at(0).span), "\"");
}

TEST(Lexer, TakesANumberTooSmallForZero) {
  const ParsedText parsed("1e-999");
  EXPECT_EQ(parsed.error_count(), 0u);
  EXPECT_EQ(as<Number>(parsed.front()).value, 0);
}

}  // namespace
}  // namespace isl::grammar
