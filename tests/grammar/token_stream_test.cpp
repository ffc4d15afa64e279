#include "grammar/token_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace isl::grammar {
namespace {

using testing::HasSubstr;

/// All tokens that the parser would see, as their kinds' names.
class Stream {
 public:
  explicit Stream(std::string_view text)
      : lexer_(text, 1, symbols_, arena_, sink_), tokens_(lexer_, symbols_, arena_, sink_, 100) {}

  std::string kinds() {
    std::string result;
    while (true) {
      const Token token = tokens_.next();
      if (token.kind == Parser::token::TOK_END_OF_FILE) return result;
      if (!result.empty()) result += ' ';
      result += Parser::symbol_name(static_cast<Parser::symbol_kind_type>(token.kind));
    }
  }
  [[nodiscard]] const DiagnosticSink& sink() const { return sink_; }

 private:
  SymbolTable symbols_;
  Arena arena_;
  DiagnosticSink sink_;
  Lexer lexer_;
  TokenStream tokens_;
};

TEST(TokenStream, PassesOnWhatMatches) {
  Stream stream("{ ( [ ] ) #if ( ) #else #end }");
  EXPECT_EQ(stream.kinds(), "{ ( [ ] ) #if ( ) #else #end }");
  EXPECT_FALSE(stream.sink().has_errors());
}

TEST(TokenStream, ClosesWhatIsOpenBeforeAnOuterCloser) {
  Stream stream("{ ( [ }");
  EXPECT_EQ(stream.kinds(), "{ ( [ ] ) }");
  ASSERT_EQ(stream.sink().error_count(), 1u);
  EXPECT_EQ(stream.sink().diagnostics()[0].message, "expected `]` before `}`");
  EXPECT_EQ(stream.sink().diagnostics()[0].notes.size(), 2u);
}

TEST(TokenStream, ClosesWhatIsOpenAtTheEnd) {
  Stream stream("#while ( ) { (");
  EXPECT_EQ(stream.kinds(), "#while ( ) { ( ) } #end");
  EXPECT_EQ(stream.sink().error_count(), 1u);
}

TEST(TokenStream, LeavesOutClosersOfNothing) {
  Stream stream("} #end { ) } #else");
  EXPECT_EQ(stream.kinds(), "{ }");
  EXPECT_EQ(stream.sink().error_count(), 4u);
}

TEST(TokenStream, DoesNotLetABracketCloseAcrossADirective) {
  Stream stream("{ #if ( ) } #end }");
  EXPECT_EQ(stream.kinds(), "{ #if ( ) #end }");
  EXPECT_EQ(stream.sink().error_count(), 1u);
}

TEST(TokenStream, AllowsABlockThatBothBranchesOpen) {
  Stream stream("#if ( ) { #else { #end }");
  EXPECT_EQ(stream.kinds(), "#if ( ) { #else { #end }");
  EXPECT_FALSE(stream.sink().has_errors());
}

TEST(TokenStream, GivesOperatorsOfAFunctionTheirOwnKinds) {
  Stream stream("function ( x ) { ( 1 < 2 ) | pigment { 1 < 2 } } 1 < 2");
  EXPECT_EQ(
      stream.kinds(),
      "function literal ( constant ) { ( number < in a function number ) | in a function word { number < number } } "
      "number < number");
}

TEST(TokenStream, SetsAsideOnlyTheBodyOfAnUnbalancedMacro) {
  Stream stream("#macro A ( B ) { #if ( ) } #end #end C");
  EXPECT_EQ(stream.kinds(), "#macro identifier ( identifier ) unbalanced macro body #end identifier");
  EXPECT_FALSE(stream.sink().has_errors());
}

TEST(TokenStream, PassesOverDeprecationMarks) {
  Stream stream("#declare deprecated once \"use B\" A = 1");
  EXPECT_EQ(stream.kinds(), "#declare identifier = number");
}

TEST(TokenStream, LimitsNesting) {
  Stream stream(std::string(101, '{'));
  EXPECT_EQ(stream.kinds().size(), 100 * 2 + 100 * 2 - 1u);
  ASSERT_EQ(stream.sink().error_count(), 1u);
  EXPECT_THAT(stream.sink().diagnostics()[0].message, HasSubstr("100"));
}

}  // namespace
}  // namespace isl::grammar
