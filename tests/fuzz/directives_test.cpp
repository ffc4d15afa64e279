// Every directive with every kind of operand, including operands that remove the object of the directive.
#include "tests/fuzz/hostile_text.h"
#include "tests/fuzz/kinds_of_values.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::test {
namespace {

using testing::IsEmpty;

TEST(Directives, RefuseWhatTheyCannotTakeWithAPlace) {
  StatementBatch batch(declarations_of_every_kind());
  for (const std::string_view value : expressions_of_every_kind()) {
    for (const char* const directive : {"#declare {} = 1;",
                                        "#local {} = 1;",
                                        "#declare {} = {};",
                                        "#declare Unset[{}] = 1;",
                                        "#declare Unset[0] = {};",
                                        "#declare Table[0] = {};",
                                        "#declare Numbers[0].x = {};",
                                        "#undef {}",
                                        "#undef Numbers[{}]",
                                        "#if ({}) #end",
                                        "#if ({}) 1 #else 2 #end",
                                        "#if (0) #elseif ({}) #end",
                                        "#ifdef ({}) #end",
                                        "#ifndef ({}) #end",
                                        "#while ({}) #declare Number = Number - 1; #end",
                                        "#for (I, {}, 2) #end",
                                        "#for (I, 1, {}) #end",
                                        "#for (I, 1, 2, {}) #end",
                                        "#for ({}, 1, 2) #end",
                                        "#for (I, 1, 3) #declare I = {}; #end",
                                        "#switch ({}) #case (1) #break #else #end",
                                        "#switch (1) #case ({}) #break #end",
                                        "#switch (1) #range ({}, {}) #break #end",
                                        "#macro {}() #end",
                                        "#macro M({}) #end",
                                        "#include {}",
                                        "#version {};",
                                        "#default {{ {} }}",
                                        "#debug {}",
                                        "#warning {}",
                                        "#fopen F {} read",
                                        "#fopen F {} write",
                                        "#fopen {} \"no such file\" read",
                                        "#fclose {}",
                                        "#read (F, {})",
                                        "#read ({}, A)",
                                        "#write (F, {})",
                                        "#write ({}, 1)",
                                        "#break {}",
                                        "Yield({})",
                                        "Yield({}, {})",
                                        "Yield({} {})",
                                        "Nothing({})",
                                        "{}",
                                        "{};",
                                        "{} {}"})
      batch.add(fmt::format(fmt::runtime(directive), value, value));
  }
  batch.flush();
  EXPECT_GT(batch.count(), 3000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

/// An operand may be a macro call that undeclares, redeclares or closes the object of the directive.
TEST(Directives, StandWhenTheirOperandsTakeAwayWhatTheyWorkOn) {
  const std::string prelude = declarations_of_every_kind() + R"(
#macro Lose(A) #ifdef (Numbers) #undef Numbers #end #ifdef (Table) #undef Table #end A #end
#macro Change(A) #declare Numbers = "text"; #declare Table = 1; A #end
#macro Shrink(A) #declare Numbers = array[1] { 7 } #declare Table = array[1][1] { { 7 } } A #end
#macro Refill() #declare Numbers = array[2] { 1, 2 } #declare Table = array[2][2] { { 1, 2 }, { 3, 4 } } #end
#macro Lose_itself(A) #undef Lose_itself A #end
#macro Lose_curve(A) #undef Curve A #end
#macro Lose_formula(A) #undef Formula A #end
#macro Lose_ball(A) #undef Ball A #end
#macro Lose_file(A) #fclose F A #end
#macro Lose_handle(A) #undef F A #end
)";
  for (const char* const taker : {"Lose", "Change", "Shrink"}) {
    StatementBatch batch(prelude);
    for (const char* const use :
         {"#declare R = Numbers[{}(1)];", "#declare Numbers[{}(1)] = 2;", "#declare R = Table[{}(1)][1];",
          "#declare R = Table[1][{}(1)];", "#declare Table[{}(1)][{}(1)] = 2;", "Yield(Numbers[{}(1)])",
          "#declare R = Yield(Numbers[{}(1)]) + 1;", "#undef Numbers[{}(1)]", "#ifdef (Numbers[{}(1)]) #end",
          "#declare R = dimension_size(Numbers, {}(1));", "#declare R = dimension_size(Table, {}(1));",
          "#declare R = defined(Table[{}(1)][0]);", "#declare R = Numbers[0] + {}(1);",
          "#declare R = Numbers[Numbers[{}(0)]];", "#declare R = array[2] {{ Numbers[0], {}(1) }}",
          "#for (I, 0, 1) #declare Numbers[I] = {}(I); #end", "#declare R = <Numbers[0], {}(1), Numbers[1]>;",
          "#declare R = max(Numbers[0], {}(1), Numbers[1]);", "#declare R = function {{ Numbers[{}(1)] }} #undef R"}) {
      batch.add(fmt::format("{} Refill()", fmt::format(fmt::runtime(use), taker, taker)));
    }
    batch.flush();
    EXPECT_THAT(batch.troubles(), IsEmpty());
  }
  for (const char* const use :
       {"Lose_itself(1) Lose_itself(1)",
        "#declare R = Curve(Lose_curve(1));",
        "#declare R = Formula(Lose_formula(1), 2);",
        "#declare R = trace(Ball, Lose_ball(0), z);",
        "union { Ball #undef Ball Ball }",
        "object { Ball #undef Ball }",
        "sphere { Ball #undef Ball translate x }",
        "#for (I, 1, 3) #undef I #end",
        "#for (I, 1, 3) #declare I = x; #end",
        "#for (I, 1, 3) #declare I = \"text\"; #end",
        "#while (Number > 0) #undef Number #end",
        "#macro M(A) #undef A A #end M(Number) M(Number)",
        "#macro M(A) #undef Number A #end M(Number)",
        "#macro M(A) #undef Numbers A #end M(Numbers[0])",
        "#macro M(A) #undef Numbers #declare A = 5; A #end M(Numbers[0])",
        "#macro M() #macro M() 2 #end 1 #end #declare R = M() + M();",
        "#declare Strings[0] = Strings;",
        "#declare Strings = Strings;",
        "#declare Unset[0] = Unset; #declare Unset[1] = Unset;",
        "#declare R = function { Formula(x, y) } #undef Formula #declare S = R(1, 2, 3);",
        "#fopen F \"a\" write #write (F, Lose_file(\"1, 2, 3\"), 1)",
        "#fopen F \"a\" write #write (F, \"1, 2, 3\") #fclose F #fopen F \"a\" read #read (F, Numbers[Lose_file(0)], "
        "B)",
        "#fopen F \"a\" write #write (F, \"1, 2, 3\") #fclose F #fopen F \"a\" read #read (F, F, F) #read (F, B)",
        "#fopen F \"a\" write #write (F, \"1, 2\") #fclose F #fopen F \"a\" read #read (F, A, Numbers[Lose_handle(0)], "
        "B)",
        "#fopen F \"a\" write #write (F, \"1, \\\"\") #fclose F #fopen F \"a\" read #read (F, A, B, C)"}) {
    StatementBatch batch(prelude);
    batch.add(use);
    batch.flush();
    EXPECT_THAT(batch.troubles(), IsEmpty());
  }
}

}  // namespace
}  // namespace isl::test
