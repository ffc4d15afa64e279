// Every built-in function with every kind of argument and every number of them, in a scene and in `function {}`.
#include "grammar/symbols.h"
#include "tests/fuzz/hostile_text.h"
#include "tests/fuzz/kinds_of_values.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::test {
namespace {

using testing::IsEmpty;

std::vector<std::string_view> built_in_functions() {
  std::vector<std::string_view> names;
#define ISL_WORD(name, word_class) \
  if (grammar::WordClass::word_class == grammar::WordClass::function) names.emplace_back(#name);
#include "grammar/words.def"
#undef ISL_WORD
  return names;
}

/// Lists of `count` arguments: the value in all places, and the value in each single place with numbers in the others.
std::vector<std::string> argument_lists(std::string_view value) {
  std::vector<std::string> lists{""};
  for (int count = 1; count <= 4; ++count) {
    for (int place = 0; place <= count; ++place) {
      std::string list;
      for (int i = 0; i < count; ++i) {
        if (i > 0) list += ", ";
        list += place == count || i == place ? value : "1";
      }
      lists.push_back(std::move(list));
    }
  }
  return lists;
}

TEST(BuiltInFunctions, RefuseWhatTheyCannotTakeWithAPlace) {
  StatementBatch batch(declarations_of_every_kind());
  for (const std::string_view name : built_in_functions()) {
    for (const std::string_view value : expressions_of_every_kind()) {
      for (const std::string& list : argument_lists(value)) batch.add(fmt::format("#declare R = {}({});", name, list));
    }
  }
  batch.flush();
  EXPECT_GT(batch.count(), 60000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

TEST(BuiltInFunctions, RefuseInAFunctionWhatTheyCannotTakeWithAPlace) {
  StatementBatch batch(declarations_of_every_kind());
  for (const std::string_view name : built_in_functions()) {
    for (const std::string_view value : {"x", "1", "Number", "Vector", "Text", "Formula", "Curve", "i", "Undeclared"}) {
      for (const std::string& list : argument_lists(value))
        batch.add(fmt::format("#declare R = function {{ {}({}) }} #undef R", name, list));
    }
  }
  batch.flush();
  EXPECT_GT(batch.count(), 8000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

/// A sum of 2^height terms as a balanced tree, because a long row of them would be refused for its depth.
std::string large_sum(int height, std::string_view term) {
  if (height == 0) return std::string(term);
  const std::string half = large_sum(height - 1, term);
  return fmt::format("({} + {})", half, half);
}

TEST(Functions, ThatAreTooLargeAreRefused) {
  for (const char* const term : {"x", "x*1.5", "1*2", "(x + 1*2)", "sin(1)*x", "select(x, 1, 2)"}) {
    const Verdict verdict = evaluate_hostile(fmt::format("#declare F = function {{ {} }}", large_sum(15, term)));
    EXPECT_EQ(verdict.trouble, "") << term;
  }
  EXPECT_TRUE(evaluate_hostile(fmt::format("#declare F = function {{ {} }}", large_sum(15, "x*1.5"))).has_errors);
}

TEST(BuiltInFunctions, AskAboutObjectsOfEveryKind) {
  StatementBatch batch(declarations_of_every_kind());
  for (const std::string_view value : expressions_of_every_kind()) {
    for (const char* const call : {"trace({0}, <0, 0, -5>, z)", "trace(Ball, {0}, z)", "trace(Ball, -5*z, {0})",
                                   "trace(Ball, -5*z, z, {0})", "trace(Ball, -5*z, z, Vector, {0})", "inside({0}, 0)",
                                   "inside(Ball, {0})", "min_extent({0})", "max_extent({0})", "trace(Drop, {0}, {0})"})
      batch.add(fmt::format("#declare R = {};", fmt::format(fmt::runtime(call), value)));
  }
  batch.flush();
  EXPECT_GT(batch.count(), 600u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

}  // namespace
}  // namespace isl::test
