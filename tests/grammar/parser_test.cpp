// Tests that golden files cannot express: spans, heights, and the laws of the grammar. Shapes are tested in
// tests/golden/parse.
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

TEST(Parser, KeepsAMistakeInABodyWhereItStands) {
  const ParsedText parsed("#macro Open() union { #end #macro Wrong() A (1 +) B #end #macro Fine() A #end");
  EXPECT_EQ(parsed.error_count(), 0u);
  EXPECT_EQ(parsed.last_error(), LoadError::none);
  const Items open = as<Macro>(*parsed.items()[0]).body;
  ASSERT_EQ(open.size(), 1u);
  const Items in_union = as<Block>(*open[0]).items;
  ASSERT_EQ(in_union.size(), 1u);
  const Error& unclosed = as<Error>(*in_union[0]);
  ASSERT_NE(unclosed.complaint, nullptr);
  EXPECT_EQ(unclosed.complaint->diagnostic.message, "the body of macro `Open` does not close this `{`");
  EXPECT_EQ(parsed.text(unclosed.complaint->diagnostic.span), "{");
  EXPECT_TRUE(unclosed.gives_up);
  EXPECT_EQ(ParsedText("#macro Fine() A #end").tree(), "macro Fine ()\n  name A\n");
}

TEST(Parser, PutsWhatTheScannerComplainsOfBeforeItsItem) {
  const ParsedText parsed("#if (A) B, C $ + D #else E #end");
  EXPECT_EQ(parsed.error_count(), 0u);
  const Items then = as<If>(parsed.front()).then;
  ASSERT_EQ(then.size(), 4u);
  EXPECT_EQ(then[2]->kind, NodeKind::error);
  EXPECT_FALSE(as<Error>(*then[2]).gives_up);
  EXPECT_EQ(as<If>(parsed.front()).otherwise.size(), 1u);
}

TEST(Parser, TellsOfWhatIsWrongOutsideOfBodiesAtOnce) {
  for (const char* const text :
       {"A $ B", "#if ($ A) B #end", "#if (A #end", "{", "#macro F( #end", "#if (A) B #end }"}) {
    EXPECT_EQ(ParsedText(text).error_count(), 1u) << text;
    EXPECT_EQ(ParsedText(text).last_error(), LoadError::syntax) << text;
  }
}

TEST(Parser, AMistakeInOneBranchLeavesTheNextAlone) {
  const ParsedText parsed("#if (A) 1 + #else * #end B");
  EXPECT_EQ(parsed.error_count(), 0u);
  const Items otherwise = as<If>(parsed.front()).otherwise;
  ASSERT_FALSE(otherwise.empty());
  ASSERT_EQ(otherwise[0]->kind, NodeKind::error);
  ASSERT_NE(as<Error>(*otherwise[0]).complaint, nullptr);
  EXPECT_EQ(parsed.items().size(), 2u);
}

TEST(Parser, LinksTheMistakesOfOneBody) {
  const ParsedText parsed("#macro A() 1 + ; 2 * ; #end");
  const Items body = as<Macro>(parsed.front()).body;
  const Complaint* const first = as<Error>(*body[0]).complaint;
  ASSERT_NE(first, nullptr);
  ASSERT_NE(first->next, nullptr);
  EXPECT_EQ(parsed.text(first->next->diagnostic.span), ";");
  EXPECT_EQ(first->next->next, nullptr);
}

TEST(Parser, ReadsAnEmptyTextAsNoItems) { EXPECT_TRUE(ParsedText("").items().empty()); }

}  // namespace
}  // namespace isl::grammar
