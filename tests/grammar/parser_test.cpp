// What the golden files cannot say: spans, heights, and the laws of the grammar. Shapes are tests/golden/parse.
#include "tests/grammar/parsed_text.h"

#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

using test::ParsedText;

TEST(Parser, SpansWholeConstructs) {
  const ParsedText parsed("A + (B * 2) sphere { 0, 1 } #if (A) B #end");
  EXPECT_EQ(parsed.text(parsed.items()[0]->span), "A + (B * 2)");
  EXPECT_EQ(parsed.text(parsed.items()[1]->span), "sphere { 0, 1 }");
  EXPECT_EQ(parsed.text(parsed.items()[2]->span), "#if (A) B #end");
}

TEST(Parser, SpansOperatorsAndBlockWords) {
  const ParsedText parsed("A + B sphere { 0, 1 }");
  EXPECT_EQ(parsed.text(as<Binary>(*parsed.items()[0]).op_span), "+");
  EXPECT_EQ(parsed.text(as<Block>(*parsed.items()[1]).word_span), "sphere");
}

TEST(Parser, SpansEachOfSeveralTextures) {
  const ParsedText parsed("#declare T = texture { A } texture { B }");
  const Items value = as<Declare>(parsed.front()).value;
  ASSERT_EQ(value.size(), 2u);
  EXPECT_EQ(parsed.text(value[1]->span), "texture { B }");
}

TEST(Parser, ContinuesAnItemThatCanGoOn) {
  EXPECT_EQ(ParsedText("A -B").tree(), ParsedText("(A - B)").tree());
  EXPECT_EQ(ParsedText("F (A)").front().kind, NodeKind::call);
  EXPECT_EQ(ParsedText("A [1]").front().kind, NodeKind::index);
  EXPECT_EQ(ParsedText("A, -B").items().size(), 3u);
}

TEST(Parser, PassesAParenthesisedVariableByValue) {
  const ParsedText parsed("F((A), A)");
  const Call& call = as<Call>(parsed.front());
  EXPECT_EQ(call.arguments[0][0]->kind, NodeKind::unary);
  EXPECT_EQ(call.arguments[1][0]->kind, NodeKind::name);
}

TEST(Parser, ReadsOnAfterAMistake) {
  const ParsedText parsed("sphere { 0, 1 + } box { 0, 1 }");
  EXPECT_EQ(parsed.error_count(), 1u);
  EXPECT_EQ(parsed.last_error(), LoadError::syntax);
  EXPECT_EQ(parsed.text(parsed.items().back()->span), "box { 0, 1 }");
}

TEST(Parser, ReportsAMistakeInsideParenthesesOnce) {
  for (const char* const text : {"F(1 = 2, (3), 4)", "#if (A B { C } (D)) E #end", "A[1 2 [3] 4]", "(1 + * (2) - 3)"}) {
    EXPECT_EQ(ParsedText(text).error_count(), 1u) << text;
  }
}

TEST(Parser, KeepsQuietAboutBracketsThatWereMended) {
  for (const char* const text :
       {"sphere { 0, (1 + }", "#if (A sphere { 0, 1 } #end", "union { A[1 }", "sphere { 1 +"}) {
    EXPECT_LE(ParsedText(text).error_count(), 2u) << text;
    EXPECT_GE(ParsedText(text).error_count(), 1u) << text;
  }
}

TEST(Parser, SetsAsideAnUnbalancedMacroUntilItIsCalled) {
  const ParsedText parsed("#macro Open() union { #end #macro Fine() A #end");
  EXPECT_EQ(parsed.error_count(), 0u);
  const Macro& macro = as<Macro>(parsed.front());
  ASSERT_EQ(macro.body.size(), 1u);
  EXPECT_EQ(macro.body[0]->kind, NodeKind::error);
  EXPECT_EQ(as<Error>(*macro.body[0]).message, "the body of macro `Open` does not close this `{`");
  EXPECT_EQ(parsed.text(macro.body[0]->span), "{");
}

TEST(Parser, ReportsAMistakeInABalancedMacroAtOnce) {
  EXPECT_EQ(ParsedText("#macro F() (1 +) #end").error_count(), 1u);
}

TEST(Parser, ReadsAnEmptyTextAsNoItems) { EXPECT_TRUE(ParsedText("").items().empty()); }

}  // namespace
}  // namespace isl::grammar
