#include "grammar/token_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace isl::grammar {
namespace {

using testing::HasSubstr;

/// All tokens that the parser would see, as their kinds' names.
class Stream {
 public:
  explicit Stream(std::string_view text, std::span<const std::uint32_t> parted = {})
      : lexer_(text, 1, symbols_, arena_, scanned_), tokens_(lexer_, scanned_, symbols_, complaints_, 100, parted) {}

  std::string kinds() {
    std::string result;
    while (true) {
      const Token token = tokens_.next();
      if (token.kind == Parser::token::TOK_END_OF_FILE) return result;
      if (!result.empty()) result += ' ';
      result += Parser::symbol_name(static_cast<Parser::symbol_kind_type>(token.kind));
    }
  }
  [[nodiscard]] bool has_unmatched_brace() const { return tokens_.has_unmatched_brace(); }
  /// All complaints until now.
  [[nodiscard]] const std::deque<Complaint>& said() const { return said_; }

 private:
  SymbolTable symbols_;
  Arena arena_;
  std::deque<Complaint> said_;
  Complaints complaints_{said_, arena_};
  DiagnosticSink scanned_;
  Lexer lexer_;
  TokenStream tokens_;
};

TEST(TokenStream, PassesOnWhatMatches) {
  Stream stream("{ ( [ ] ) #if ( ) #else #end }");
  EXPECT_EQ(stream.kinds(), "{ ( [ ] ) #if ( ) #else #end }");
  EXPECT_TRUE(stream.said().empty());
}

TEST(TokenStream, ClosesWhatIsOpenBeforeAnOuterCloser) {
  Stream stream("{ ( [ }");
  EXPECT_EQ(stream.kinds(), "{ ( [ unclosed bracket ] ) }");
  ASSERT_EQ(stream.said().size(), 1u);
  EXPECT_EQ(stream.said()[0].diagnostic.message, "expected `]` before `}`");
  EXPECT_EQ(stream.said()[0].diagnostic.notes.size(), 2u);
}

TEST(TokenStream, ClosesWhatIsOpenAtTheEnd) {
  Stream stream("#while ( ) { (");
  EXPECT_EQ(stream.kinds(), "#while ( ) { ( unclosed bracket ) } #end");
  EXPECT_EQ(stream.said().size(), 1u);
}

TEST(TokenStream, LeavesOutClosersOfNothing) {
  Stream stream("} #end { ) } #else");
  EXPECT_EQ(stream.kinds(), "{ }");
  EXPECT_EQ(stream.said().size(), 4u);
}

TEST(TokenStream, DoesNotLetABracketCloseAcrossADirective) {
  Stream stream("{ #if ( ) } #end }");
  EXPECT_EQ(stream.kinds(), "{ #if ( ) #end }");
  EXPECT_EQ(stream.said().size(), 1u);
}

TEST(TokenStream, TakesPartedBracesForNoBrackets) {
  const std::string text = "#if ( ) union { #else merge { #end { } }";
  const std::vector<std::uint32_t> parted = {15, 29, 40};
  Stream stream(text, parted);
  EXPECT_EQ(stream.kinds(), "#if ( ) word { of a branch #else word { of a branch #end { } } of a branch");
  EXPECT_TRUE(stream.said().empty());
}

TEST(TokenStream, TellsOfBracesWithoutPartners) {
  for (const auto& [text, is_told] : std::vector<std::pair<std::string, bool>>{{"{ } #if ( ) { } #end", false},
                                                                               {"#if ( ) { #end", true},
                                                                               {"{ #if ( ) } #end", true},
                                                                               {"#if ( ) ( #end", false},
                                                                               {"#if ( ) ) #end", false}}) {
    Stream stream(text);
    static_cast<void>(stream.kinds());
    EXPECT_EQ(stream.has_unmatched_brace(), is_told) << text;
  }
}

TEST(TokenStream, GivesOperatorsOfAFunctionTheirOwnKinds) {
  Stream stream("function ( x ) { ( 1 < 2 ) | pigment { 1 < 2 } } 1 < 2");
  EXPECT_EQ(
      stream.kinds(),
      "function literal ( constant ) { ( number < in a function number ) | in a function word { number < number } } "
      "number < number");
}

TEST(TokenStream, MendsAMacrosBodyWithinIt) {
  Stream stream("#macro A ( B ) { #if ( ) } #end #end C");
  EXPECT_EQ(stream.kinds(), "#macro identifier ( identifier ) { #if ( ) #end unclosed bracket } #end identifier");
  ASSERT_EQ(stream.said().size(), 2u);
  EXPECT_EQ(stream.said()[1].diagnostic.message, "the body of macro `A` does not close this `{`");
}

TEST(TokenStream, ClosesAMacrosParametersWithinIt) {
  Stream stream("#macro A ( #end C");
  EXPECT_EQ(stream.kinds(), "#macro identifier ( unclosed bracket ) #end identifier");
  ASSERT_EQ(stream.said().size(), 1u);
  EXPECT_EQ(stream.said()[0].diagnostic.message, "expected `)` before `#end`");
}

TEST(TokenStream, LetsOneBranchAloneOpenABlock) {
  Stream stream("#if ( ) union { #else C #end D");
  EXPECT_EQ(stream.kinds(), "#if ( ) word { unclosed bracket } #else identifier #end identifier");
  ASSERT_EQ(stream.said().size(), 1u);
  EXPECT_EQ(stream.said()[0].diagnostic.message, "expected `}` before `#else`");
}

TEST(TokenStream, TakesAMisspeltDirectiveForTheNearestOutsideOfDirectivesOnly) {
  Stream outside("#whlie ( ) #end");
  EXPECT_EQ(outside.kinds(), "#while ( ) #end");
  EXPECT_EQ(outside.said().size(), 1u);
  Stream inside("#if ( ) #whlie ( ) #end #end");
  EXPECT_EQ(inside.kinds(), "#if ( ) ( ) #end");
  ASSERT_EQ(inside.said().size(), 2u);
  ASSERT_EQ(inside.said()[1].diagnostic.notes.size(), 1u);
  EXPECT_EQ(inside.said()[1].diagnostic.notes[0].message, "this is not a directive; did you mean `#while`?");
}

TEST(TokenStream, KnowsDeprecationMarksInDeclarationsOnly) {
  EXPECT_EQ(Stream("#declare deprecated once \"use B\" A = 1").kinds(),
            "#declare deprecated once string identifier = number");
  EXPECT_EQ(Stream("deprecated once #local A = once").kinds(), "word word #local identifier = word");
}

TEST(TokenStream, LimitsNesting) {
  Stream stream(std::string(101, '{'));
  EXPECT_EQ(stream.kinds().size(), 100 * 2 + 100 * 2 - 1 + std::string_view(" unclosed bracket").size());
  ASSERT_EQ(stream.said().size(), 1u);
  EXPECT_THAT(stream.said()[0].diagnostic.message, HasSubstr("100"));
}

TEST(TokenStream, LeavesOutBracketsThatAreTooDeepWithinADirective) {
  Stream stream("#if ( ) " + std::string(200, '{') + " #end C");
  EXPECT_THAT(stream.kinds(), testing::EndsWith("} #end identifier"));
}

}  // namespace
}  // namespace isl::grammar
