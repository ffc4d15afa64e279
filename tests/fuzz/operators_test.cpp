// Every operator between all pairs of kinds of values, and every way to use one value.
#include "tests/fuzz/hostile_text.h"
#include "tests/fuzz/kinds_of_values.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::test {
namespace {

using testing::IsEmpty;

TEST(Operators, RefuseWhatTheyCannotTakeWithAPlace) {
  StatementBatch batch(declarations_of_every_kind());
  for (const char* const op : {"+", "-", "*", "/", "<", ">", "=", "<=", ">=", "!=", "&", "|"}) {
    for (const std::string_view left : expressions_of_every_kind()) {
      for (const std::string_view right : expressions_of_every_kind())
        batch.add(fmt::format("#declare R = ({} {} {});", left, op, right));
    }
  }
  batch.flush();
  EXPECT_GT(batch.count(), 40000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

TEST(Operators, OfOneValueRefuseWhatTheyCannotTakeWithAPlace) {
  StatementBatch batch(declarations_of_every_kind());
  for (const char* const use : {"-{}",
                                "+{}",
                                "!{}",
                                "({})",
                                "{}.x",
                                "{}.gray",
                                "{}.red.x",
                                "{}.sphere",
                                "{}[0]",
                                "{}[0][0]",
                                "{}[-1]",
                                "{}[\"a\"]",
                                "{}[0/0]",
                                "{}(1)",
                                "{}()",
                                "{}(1, 2)",
                                "{}(x, y)",
                                "({} ? 1 : 2)",
                                "(1 ? {} : 2)",
                                "(0 ? 1 : {})",
                                "<{}, 1>",
                                "<{}>",
                                "rgb {}",
                                "rgbft {}",
                                "srgb {}",
                                "color red {}",
                                "{} red 1",
                                "{} transmit 1",
                                "array[{}]",
                                "array[1] {{ {} }}",
                                "array[2] {{ {} }}",
                                "array[1][1] {{ {} }}",
                                "function {{ {} }}",
                                "function {{ x + {} }}",
                                "function (A) {{ A*{} }}",
                                "function {{ sin({}) }}",
                                "function {{ {}.x }}",
                                "function {{ {}(x, y) }}",
                                "function {{ {}(x, y, z).x }}",
                                "function {{ sum(i, 1, {}, i) }}",
                                "function {{ select({}, 1, 2) }}",
                                "function {{ internal({}) }}",
                                "spline {{ {} }}",
                                "spline {{ 0, {} }}",
                                "{} {}",
                                "{}, {}",
                                "{} ;"}) {
    for (const std::string_view value : expressions_of_every_kind())
      batch.add(fmt::format("#declare R = {}; #undef R", fmt::format(fmt::runtime(use), value, value)));
  }
  batch.flush();
  EXPECT_GT(batch.count(), 3000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

}  // namespace
}  // namespace isl::test
