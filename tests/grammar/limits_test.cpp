// Hostile texts: deep, long, broken. None may crash, hang or cause more errors than the limit allows.
#include "tests/grammar/parsed_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace isl::grammar {
namespace {

using test::ParsedText;

std::string repeat(std::string_view text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

TEST(Limits, AcceptsNestingUpToTheLimitAndNoFurther) {
  const auto nested = [](std::size_t depth) { return repeat("{", depth) + repeat("}", depth); };
  EXPECT_EQ(ParsedText(nested(1000)).error_count(), 0u);
  EXPECT_EQ(ParsedText(nested(1001)).error_count(), 1u);
}

TEST(Limits, RefusesAMillionOfEachOpeningWithOneError) {
  for (const char* const opening : {"(", "[", "{", "#if (1) ", "#macro A() ", "F(", "A[", "sphere {", "function {"}) {
    EXPECT_EQ(ParsedText(repeat(opening, 1'000'000)).error_count(), 1u) << opening;
  }
}

TEST(Limits, RefusesTreesThatAreHighWithoutBrackets) {
  for (const char* const link : {"1 + ", "-", "<", "!", "A ? B : "}) {
    EXPECT_GE(ParsedText(fmt::format("#if ({}1) #end", repeat(link, 100'000))).error_count(), 1u) << link;
  }
  EXPECT_THAT(ParsedText(fmt::format("#if (1) {} #end", repeat("#elseif (1) ", 100'000))).tree(),
              testing::HasSubstr("nested operations and brackets"));
  EXPECT_GE(ParsedText(fmt::format("A{}", repeat(".x", 100'000))).error_count(), 1u);
}

TEST(Limits, AcceptsLongSumsAndLongLists) {
  EXPECT_EQ(ParsedText(fmt::format("#declare A = {}1;", repeat("1 + ", 3000))).error_count(), 0u);
  EXPECT_EQ(ParsedText(repeat("sphere { 0, 1 } ", 10'000)).items().size(), 10'000u);
}

TEST(Limits, StopsAtTheCapOfErrors) {
  EXPECT_EQ(ParsedText(repeat("$", 100'000)).error_count(), DiagnosticSink::kMaxErrors);
  EXPECT_EQ(ParsedText(repeat("} ", 100'000)).error_count(), DiagnosticSink::kMaxErrors);
}

RC_GTEST_PROP(Limits, AnyRowOfTokensIsParsed, ()) {
  const auto token = rc::gen::element<std::string>(
      "{", "}", "(", ")", "[", "]", "<", ">", ",", ";", ".", "=", "+", "-", "*", "!", "?", ":", "&", "|", "1", "A", "x",
      "sphere", "texture", "rgb", "sin", "array", "function", "\"s\"", "#if", "#else", "#elseif", "#end", "#while",
      "#for", "#switch", "#case", "#range", "#break", "#macro", "#declare", "#local", "#ifdef", "#include", "#read",
      "#write", "#fopen", "#undef", "#default", "#version", "#debug", "$", "/*", "*/", "\"");
  const auto row = *rc::gen::container<std::vector<std::string>>(token);
  std::string text;
  for (const std::string& word : row) text += word + " ";
  const ParsedText parsed(text);
  RC_ASSERT(parsed.error_count() <= DiagnosticSink::kMaxErrors);
  // If a node stands for a mistake that is reported elsewhere, it must have been reported.
  const std::string tree = parsed.tree();
  RC_ASSERT(parsed.error_count() > 0 || tree.find("error\n") == std::string::npos ||
            tree.find("error \"") != std::string::npos);
}

RC_GTEST_PROP(Limits, AnyBytesAreParsed, ()) {
  const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
  RC_ASSERT(ParsedText(bytes).error_count() <= DiagnosticSink::kMaxErrors);
}

}  // namespace
}  // namespace isl::grammar
