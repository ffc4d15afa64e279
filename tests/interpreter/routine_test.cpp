// Loops and macros that run as routines do what the evaluator does. Each scene here is evaluated twice: as it stands,
// and with an #undef, which no routine has, in place of each `@`. What it prints and its messages must be the same.
#include "tests/interpreter/evaluated_text.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace isl::test {
namespace {

std::string with(std::string_view scene, std::string_view in_place) {
  std::string text = "#version 3.7;\n";
  for (const char c : scene) {
    if (c == '@') {
      text += in_place;
    } else {
      text += c;
    }
  }
  return text;
}

struct Outcome {
  std::string said, messages;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(const std::string& text, const interpreter::EvaluateOptions& options) {
  const EvaluatedText scene(text, options);
  return {scene.said(), scene.messages()};
}

/// What the scene prints, by either way.
std::string said_by_both(std::string_view scene, const interpreter::EvaluateOptions& options = {}) {
  const Outcome routine = outcome_of(with(scene, ""), options);
  const Outcome evaluator = outcome_of(with(scene, "#undef Nothing "), options);
  EXPECT_EQ(routine.said, evaluator.said) << scene;
  EXPECT_EQ(routine.messages, evaluator.messages) << scene;
  return routine.said + routine.messages;
}

constexpr std::string_view kShow = "#debug concat(str(A, 0, 6), \"\\n\")";

std::string shown(std::string_view scene) { return said_by_both(std::string(scene) + std::string(kShow)); }

TEST(Routine, ComputesEveryOperator) {
  EXPECT_EQ(shown("#declare A = 0; #for (I, 1, 5) @ #declare A = A + I * 2 - 1 / I; #end"), "27.716667\n");
  EXPECT_EQ(
      shown("#declare A = 0; #for (I, -3, 3, 0.5) @ #if (I < 0 | I > 2 & !(I = 3)) #declare A = A + -I; #end #end"),
      "8.000000\n");
  EXPECT_EQ(shown("#declare A = 0; #for (I, 0, 4) @ #declare A = A + (I >= 2 ? I : 10) + (I != 3) + (I <= 1); #end"),
            "35.000000\n");
  EXPECT_EQ(
      shown(
          "#declare A = 0; #declare B = 7; #while (B > 0) @ #declare A = 10 * A + mod(B, 3); #declare B = B - 1; #end"),
      "1021021.000000\n");
  EXPECT_EQ(
      shown("#declare A = 0; #for (I, 1, 9) @ #declare A = A + sin(I) + sqrt(I) + max(I, 4) - min(I, 4) + int(I / 2) + "
            "div(I, 2) + pow(I, 2) + atan2(I, 2) + ln(I) + floor(-I) + abs(-I); #end"),
      said_by_both("#declare A = 0; #for (I, 1, 9) #undef Nothing #declare A = A + sin(I) + sqrt(I) + max(I, 4) - "
                   "min(I, 4) + int(I / 2) + div(I, 2) + pow(I, 2) + atan2(I, 2) + ln(I) + floor(-I) + abs(-I); #end" +
                   std::string(kShow)));
}

TEST(Routine, ComparesStrings) {
  EXPECT_EQ(shown("#declare A = 0; #for (I, 0, 4) @ #declare T = chr(65 + I); #declare B = (T = \"C\"); "
                  "#if (T != \"A\" & \"D\" >= T | B) #declare A = 10 * A + I; #end #end"),
            "123.000000\n");
  EXPECT_EQ(shown("#declare A = 0; #for (I, 0, 2) @ #declare A = A + (\"a\" < \"b\"); #end"), "3.000000\n");
  said_by_both("#declare T = 1; #for (I, 0, 2) @ #declare B = (T = \"C\"); #end");
  said_by_both("#for (I, 0, 2) @ #declare B = \"a\" + \"b\"; #end");
  said_by_both("#for (I, 0, 2) @ #if (Unknown = \"b\") #declare B = 1; #end #end");
}

TEST(Routine, ReadsAndWritesElementsAndItems) {
  EXPECT_EQ(shown("#declare L = array[4]; #for (I, 0, 3) @ #declare L[I] = I * I; #end #declare A = 0;"
                  "#for (I, 0, 3) @ #declare L[I] = L[I] + L[3 - I]; #declare A = A + L[I]; #end"),
            "41.000000\n");
  EXPECT_EQ(shown("#declare V = <1, 2, 3>; #declare A = 0; #for (I, 0, 2) @ #declare A = A + V.x * V.z + V.y; #end"),
            "15.000000\n");
  EXPECT_EQ(
      shown(
          "#declare L = array[2][2] {{1, 2}, {3, 4}}; #declare A = 0; #for (I, 0, 1) @ #declare A = A + L[I][1]; #end"),
      "6.000000\n");
}

TEST(Routine, AppendsToStrings) {
  EXPECT_EQ(said_by_both("#declare T = \"\"; #declare S = \"é\"; #for (I, 0, 4) @ #declare T = concat(T, chr(97 + I)); "
                         "#declare T = concat(T, S); #declare T = concat(T, \"-\"); #declare U = T; #end "
                         "#debug concat(T, \" \", U)"),
            "aé-bé-cé-dé-eé- aé-bé-cé-dé-eé-");
  // Values that share the string keep it.
  EXPECT_EQ(said_by_both("#declare T = \"a\"; #for (I, 0, 2) @ #declare U = T; #declare T = concat(T, T); #end "
                         "#debug concat(T, \" \", U)"),
            "aaaaaaaa aaaa");
  EXPECT_EQ(said_by_both("#macro M(S) @ #for (I, 0, 2) @ #declare S = concat(S, \"x\"); #end #end #declare T = \"a\"; "
                         "M(T) #debug T"),
            "axxx");
  for (const std::string_view more : {"chr(70000)", "chr(-1)", "chr(0)", "5", "Unknown", "<1, 2>", "chr(\"a\")"})
    said_by_both("#declare T = \"a\"; #for (I, 0, 2) @ #declare T = concat(T, " + std::string(more) +
                 "); #end #debug T");
  said_by_both("#declare T = 5; #for (I, 0, 2) @ #declare T = concat(T, \"a\"); #end");
}

TEST(Routine, ArraysGrowAndHoldAnything) {
  EXPECT_EQ(shown("#declare L = array; #for (I, 0, 9) @ #declare L[I] = I; #end #declare A = dimension_size(L, 1);"),
            "10.000000\n");
  EXPECT_EQ(shown("#macro Double(X) @ #declare X = 2 * X; #end #declare L = array[3] {1, 2, 3}; Double(L[1]) "
                  "#for (I, 0, 2) @ #declare L[I] = L[I] + 1; #end #declare M = L; #declare L[1] = 0; "
                  "#declare A = 100 * M[0] + 10 * M[1] + M[2] + L[1];"),
            "254.000000\n");
  EXPECT_EQ(
      shown("#declare L = array[3]; #for (I, 0, 2) @ #if (I = 1) #declare L[I] = <I, 2>; #else #declare L[I] = I; "
            "#end #end #declare M = L; #for (I, 0, 2) @ #declare L[I] = 5; #end #declare A = M[1].y + L[1];"),
      "7.000000\n");
  for (const std::string_view index : {"-1", "-0.5", "3", "1e300", "-1e300"})
    said_by_both("#declare L = array[3] {1, 2, 3}; #for (I, 0, 0) @ #declare A = L[I + " + std::string(index) +
                 "]; #end");
}

TEST(Routine, LeavesWhatIsNoNumberToTheEvaluator) {
  EXPECT_EQ(
      shown("#declare V = 0; #for (I, 0, 2) @ #declare V = V + <I, 1, 2> * 2; #end #declare A = V.x + V.y + V.z;"),
      "24.000000\n");
  EXPECT_EQ(said_by_both("#declare T = \"\"; #for (I, 0, 4) @ #declare T = concat(T, chr(65 + I)); "
                         "#if (T = \"AB\") #declare T = \"x\"; #end #end #debug T"),
            "xCDE");
  EXPECT_EQ(shown("#declare R = seed(3); #declare A = 0; #for (I, 0, 9) @ #declare A = A + rand(R); #end"),
            said_by_both(
                "#declare R = seed(3); #declare A = 0; #for (I, 0, 9) #undef Nothing #declare A = A + rand(R); #end" +
                std::string(kShow)));
  // A name changes its kind while the loop runs.
  EXPECT_EQ(
      shown(
          "#declare B = 1; #for (I, 0, 2) @ #if (I = 1) #declare B = <1, 2>; #end #declare A = 0; #declare C = B * 2; "
          "#end #declare A = C.y;"),
      "4.000000\n");
}

TEST(Routine, EndsAtBreak) {
  EXPECT_EQ(shown("#declare A = 0; #while (1) @ #declare A = A + 1; #if (A > 6) #break #end #end"), "7.000000\n");
  EXPECT_EQ(
      shown("#declare A = 0; #for (I, 1, 9) @ #for (J, 1, 9) @ #if (J > I) #break #end #declare A = A + 1; #end #end"),
      "45.000000\n");
  EXPECT_EQ(
      shown("#macro M(X) @ #if (X > 3) #break #end #declare A = A + X; #end #declare A = 0; #for (I, 1, 6) M(I) #end"),
      "6.000000\n");
}

TEST(Routine, KeepsScopes) {
  EXPECT_EQ(shown("#macro M(X) @ #local A = X; #for (I, 1, 3) @ #local A = A + I; #end #declare B = A; #end "
                  "#declare B = 0; #declare A = 5; M(10) #declare A = A + B;"),
            "21.000000\n");
  EXPECT_EQ(shown("#macro M(X, Y) @ #declare X = X + Y; #declare New = Y; #end #declare A = 1; M(A, 2) M(A, A) "
                  "#declare A = A + New;"),
            "12.000000\n");
  EXPECT_EQ(shown("#macro Set(L, I) @ #declare L[I] = I + 1; #end #declare B = array[3]; Set(B, 2) #declare A = B[2];"),
            "3.000000\n");
}

TEST(Routine, YieldsTheValueOfAMacro) {
  EXPECT_EQ(shown("#macro F(N) @ #if (N < 2) N #else F(N - 1) + F(N - 2) #end #end #declare A = F(12);"),
            "144.000000\n");
  EXPECT_EQ(shown("#macro V(X) @ #local Y = X * 2; <Y, X, 1> #end #declare B = V(3) + V(4); #declare A = B.x * B.y;"),
            "98.000000\n");
  EXPECT_EQ(said_by_both("#macro T(X) @ concat(X, X) #end #debug T(\"ab\") #debug concat(T(\"c\"), \"d\")"), "ababccd");
  // The macro is declared anew by itself.
  EXPECT_EQ(shown("#macro M(X) @ #local Y = N(X); Y + X #end #macro N(X) @ X + 1 #end #declare A = M(2);"),
            "5.000000\n");
}

TEST(Routine, TellsMistakesAsTheEvaluatorDoes) {
  for (const std::string_view scene :
       {"#declare A = 0; #for (I, 0, 3) @ #declare A = A + Unknown; #end",
        "#declare A = 0; #for (I, -1, 1) @ #declare A = 1 / I; #end",
        "#declare L = array[2]; #for (I, 0, 3) @ #declare L[I] = I; #end",
        "#declare L = array[2]; #declare A = 0; #for (I, 0, 1) @ #declare A = A + L[I]; #end",
        "#for (I, 0, 1, 0) @ #declare A = 1; #end", "#for (I, 0, 3) @ #declare I = \"text\"; #end",
        "#while (\"text\") @ #declare A = 1; #end", "#while (<1, 2>) @ #declare A = 1; #end",
        "#macro M(X) @ #if (X) 1 #end #end #declare A = M(1) + M(0);", "#macro M(X) @ Unknown #end #declare A = M(1);",
        "#macro M(X) @ X #end #declare A = M(1, 2);", "#macro M(X) @ #local Y = X; #end #declare A = M(1);",
        "#declare A = 0; #for (I, 0, 2) @ #declare A = sqrt(-1 - I) + acos(2); #end",
        "#declare F = function(x) { x }; #for (I, 0, 2) @ #declare F = I; #end",
        "#declare deprecated \"use B\" A = 1; #for (I, 0, 2) @ #declare A = A + 1; #end",
        "#declare A = 0; #for (I, 0, 2) @ #ifdef (B) #declare A = A + 1; #else #declare B = 1; #end #end"}) {
    said_by_both(scene);
  }
  EXPECT_NE(said_by_both("#for (I, 0, 3) @ #declare A = Unknown; #end").find("undeclared identifier `Unknown`"),
            std::string::npos);
}

TEST(Routine, KeepsTheLimits) {
  interpreter::EvaluateOptions options;
  options.limits.max_turns = 1000;
  EXPECT_NE(said_by_both("#while (1) @ #declare A = 1; #end", options).find("more than 1000 turns"), std::string::npos);
  EXPECT_NE(said_by_both("#for (I, 0, 1e9) @ #end", options).find("more than 1000 turns"), std::string::npos);
  options.limits.max_turns = 1e9;
  options.limits.max_depth = 50;
  EXPECT_NE(
      said_by_both("#macro M(N) @ #local X = N; M(N + 1) + X #end #declare A = M(1);", options).find("50 macro calls"),
      std::string::npos);
}

}  // namespace
}  // namespace isl::test
