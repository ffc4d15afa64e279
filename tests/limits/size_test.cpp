// Texts that are deep, long or have many parts: a million of every construct that may stand within another, and a
// hundred thousand of every construct that may stand beside another.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr std::size_t kMillion = 1'000'000;
constexpr std::size_t kMany = 100'000;

class Size : public AttackTest {};

TEST_F(Size, AMillionBracketsAndDirectivesWithinOneAnother) {
  for (const auto& [opening, middle, closing] :
       std::vector<std::array<std::string, 3>>{{"(", "1", ")"},
                                               {"B[", "1", "]"},
                                               {"{", "", "}"},
                                               {"union { ", "", "}"},
                                               {"sin(", "1", ")"},
                                               {"#if (1) ", "", "#end "},
                                               {"#if (0) ", "", "#end "},
                                               {"#while (0) ", "", "#end "},
                                               {"#switch (1) #case (1) ", "", "#end "},
                                               {"#macro A() ", "", "#end "},
                                               {"array[1] {", "1", "}"}}) {
    const std::string text = repeated(opening, kMillion) + middle + repeated(closing, kMillion);
    EXPECT_THAT(refusal("#declare A = " + text), HasSubstr("more than 1000 brackets and directives are open"))
        << opening;
    EXPECT_THAT(refusal(text), HasSubstr("more than 1000 brackets and directives are open")) << opening;
  }
}

TEST_F(Size, AMillionOperatorsInARow) {
  for (const std::string_view link : {"-", "!", "1 + ", "2 * ", "1 ? 1 : ", "1 < "}) {
    EXPECT_THAT(refusal(fmt::format("#declare A = ({}1);", repeated(link, kMillion))),
                HasSubstr("nested operations and brackets"))
        << link;
  }
  EXPECT_THAT(refusal(fmt::format("#declare A = x{};", repeated(".x", kMillion))),
              HasSubstr("nested operations and brackets"));
  EXPECT_EQ(check(fmt::format("#declare A = {}1{};", repeated("<", kMillion), repeated(", 1>", kMillion))).exit_code,
            1);
  EXPECT_EQ(check(fmt::format("#if (0) {} #end", repeated("#elseif (0) ", kMillion))).exit_code, 1);
}

TEST_F(Size, AMillionCommentsWithinOneAnother) {
  EXPECT_EQ(check(repeated("/*", kMillion) + repeated("*/", kMillion)).exit_code, 0);
  EXPECT_THAT(refusal(repeated("/*", kMillion)), HasSubstr("this comment is not closed"));
}

TEST_F(Size, LongLinesNamesNumbersAndStrings) {
  EXPECT_EQ(check(repeated("sphere { 0, 1 } ", kMany)).exit_code, 0) << "one line";
  EXPECT_EQ(
      check(repeated("sphere { 0, 1 } ", kMany) + "sphere { 0, }" + repeated("sphere { 0, 1 } ", kMany)).exit_code, 1);
  const std::string name(kMillion, 'A');
  EXPECT_THAT(refusal(fmt::format("#declare {0} = 1; #declare B = {0}C;", name)),
              HasSubstr("undeclared identifier `AAAA"));
  EXPECT_THAT(refusal(fmt::format("#{} 1", name)), HasSubstr("unknown directive"));
  EXPECT_THAT(refusal(fmt::format("#declare A = {};", std::string(kMillion, '1'))), HasSubstr("is too large"));
  EXPECT_THAT(refusal(fmt::format("#declare A = 1e{};", std::string(kMillion, '9'))), HasSubstr("is too large"));
  EXPECT_EQ(check(fmt::format("#declare A = .{};", std::string(kMillion, '1'))).exit_code, 0);
  EXPECT_EQ(check(fmt::format("#declare A = \"{}\";", std::string(10 * kMillion, 'a'))).exit_code, 0);
  EXPECT_THAT(refusal("\"" + std::string(10 * kMillion, 'a')), HasSubstr("this string is not closed"));
  EXPECT_THAT(refusal(fmt::format("#include \"{}\"", std::string(kMillion, 'a'))), HasSubstr("cannot find"));
}

TEST_F(Size, AHundredThousandOfEverything) {
  std::string parameters, ones, cases, declarations;
  for (std::size_t i = 0; i < kMany; ++i) {
    parameters += fmt::format("{}A{}", i > 0 ? ", " : "", i);
    ones += i > 0 ? ", 1" : "1";
    cases += fmt::format("#case ({}) ", i);
    declarations += fmt::format("#declare A{} = 1;\n", i);
  }
  EXPECT_EQ(check(fmt::format("#macro F({}) #end F({})", parameters, ones)).exit_code, 0);
  EXPECT_EQ(check(fmt::format("#switch (-1) {} #end", cases)).exit_code, 0);
  EXPECT_EQ(check(declarations).exit_code, 0);
  EXPECT_THAT(refusal(fmt::format("#macro F(A) #end F({})", ones)), HasSubstr("takes 1 argument, found 100000"));
  EXPECT_THAT(refusal(fmt::format("#declare A = <{}>;", ones)), HasSubstr("at most 5 coordinates"));
  EXPECT_THAT(refusal(fmt::format("#declare A = array{};", repeated("[1]", kMany))), HasSubstr("at most 5 dimensions"));
}

TEST_F(Size, ATextLargerThanTheMemoryAllowed) {
  EXPECT_THAT(refusal(repeated("sphere { 0, 1 } ", kMany), {"--max-memory", "4M"}),
              HasSubstr("`--max-memory` raises the limit"));
  write("large.inc", repeated("sphere { 0, 1 } ", kMany));
  EXPECT_THAT(refusal("#include \"large.inc\"", {"--max-memory", "4M"}), HasSubstr("`--max-memory` raises the limit"));
}

}  // namespace
}  // namespace isl::test
