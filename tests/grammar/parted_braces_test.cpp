#include "grammar/parted_braces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace isl::grammar {
namespace {

/// The text with the braces that were found in it as `<` and `>`.
std::string found_in(std::string_view text, std::size_t max_nesting = 100) {
  SymbolTable symbols;
  Arena arena;
  DiagnosticSink sink;
  constexpr std::uint32_t kBegin = 1;
  Lexer lexer(text, kBegin, symbols, arena, sink);
  std::string marked(text);
  for (const std::uint32_t at : find_parted_braces(lexer, max_nesting)) {
    char& brace = marked[at - kBegin];
    brace = brace == '{' ? '<' : '>';
  }
  return marked;
}

TEST(PartedBraces, AreThoseOfBranchesAndTheirPartners) {
  EXPECT_EQ(found_in("#if (A) merge { #else union { #end sphere { 0, 1 } }"),
            "#if (A) merge < #else union < #end sphere { 0, 1 } >");
  EXPECT_EQ(found_in("#if (A) merge { #end sphere { 0, 1 } #if (A) } #end"),
            "#if (A) merge < #end sphere { 0, 1 } #if (A) > #end");
  EXPECT_EQ(found_in("torus { 1, 0.1 #ifdef (A) scale 2 } #else } #end"),
            "torus < 1, 0.1 #ifdef (A) scale 2 > #else > #end");
  EXPECT_EQ(found_in("#ifndef (A) #if (B) merge { #else union { #end #end sphere { 0, 1 } #ifndef (A) } #end"),
            "#ifndef (A) #if (B) merge < #else union < #end #end sphere { 0, 1 } #ifndef (A) > #end");
  EXPECT_EQ(found_in("#switch (A) #case (1) merge { #break #range (2, 3) union { #break #else merge { #end }"),
            "#switch (A) #case (1) merge < #break #range (2, 3) union < #break #else merge < #end >");
  EXPECT_EQ(found_in("#if (A) union { object { #end sphere { 0, 1 } #if (A) } } #end"),
            "#if (A) union < object < #end sphere { 0, 1 } #if (A) > > #end");
}

TEST(PartedBraces, PairTheInnermostFirst) {
  EXPECT_EQ(found_in("union { #if (A) merge { #end sphere { 0, 1 } #if (A) } #end }"),
            "union { #if (A) merge < #end sphere { 0, 1 } #if (A) > #end }");
  EXPECT_EQ(found_in("#if (A) merge { #end #if (B) union { #end box { 0, 1 } #if (B) } #end #if (A) } #end"),
            "#if (A) merge < #end #if (B) union < #end box { 0, 1 } #if (B) > #end #if (A) > #end");
}

TEST(PartedBraces, LieWithinOneMacroOrLoop) {
  const std::string idiom = "#if (A) merge { #end sphere { 0, 1 } #if (A) } #end";
  const std::string parted = "#if (A) merge < #end sphere { 0, 1 } #if (A) > #end";
  EXPECT_EQ(found_in("#macro M() " + idiom + " #end"), "#macro M() " + parted + " #end");
  EXPECT_EQ(found_in("#for (I, 0, 1) " + idiom + " #end"), "#for (I, 0, 1) " + parted + " #end");
  for (const std::string text : {"#macro Begin() merge { #end #macro End() } #end Begin() sphere { 0, 1 } End()",
                                 "#if (A) merge { #end #while (B) #if (A) } #end #end"})
    EXPECT_EQ(found_in(text), text);
  EXPECT_EQ(found_in("#macro Begin() merge { #end " + idiom), "#macro Begin() merge { #end " + parted);
}

TEST(PartedBraces, AreNotFoundWhereTheyDoNotMatchEvenSo) {
  for (const std::string text : {"#if (A) merge { #end", "#if (A) } #end", "merge { #if (A) } } #end",
                                 "#if (A) merge {", "#if (A) merge { #end }  #end", "sphere { 0, 1 }", ""})
    EXPECT_EQ(found_in(text), text);
}

TEST(PartedBraces, AreThoseOfEvenDirectivesWhereOthersDoNotMatch) {
  EXPECT_EQ(found_in("#if (0) merge { #end #if (A) merge { #else union { #end sphere { 0, 1 } }"),
            "#if (0) merge { #end #if (A) merge < #else union < #end sphere { 0, 1 } >");
  EXPECT_EQ(found_in("union { #if (A) merge { #elseif (B) union { #end sphere { 0, 1 } }"),
            "union { #if (A) merge { #elseif (B) union { #end sphere { 0, 1 } }");
}

TEST(PartedBraces, AreThoseOfBlocksAlone) {
  for (const std::string text : {"#if (A) #declare B = array[2] { #else #declare B = array[2] { #end 1, 2 }",
                                 "#if (A) #default { #else #default { #end finish { ambient 1 } }",
                                 "#declare F = #if (A) function(x) { #else function(y) { #end 1 }"})
    EXPECT_EQ(found_in(text), text);
}

TEST(PartedBraces, AreNotFoundBelowTheLimitOfNesting) {
  const std::string text = "#if (A) #if (B) merge { #else union { #end #end sphere { 0, 1 } #if (A) } #end";
  EXPECT_NE(found_in(text, 2), text);
  EXPECT_EQ(found_in(text, 1), text);
}

}  // namespace
}  // namespace isl::grammar
