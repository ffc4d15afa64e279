// Endless scripts: each must end with its limit's own message, naming the option that raises it.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

using testing::HasSubstr;

class Runaway : public AttackTest {};

TEST_F(Runaway, LoopsEndAtTheTurnsAllowed) {
  for (const std::string_view loop : {"#while (1) #end", "#for (I, 1, 1e18) #end", "#while (1) #while (1) #end #end",
                                      "#while (1) #for (I, 1, 10) #end #end", "sphere { 0, 1 #while (1) #end }",
                                      "#declare A = <1, #while (1) #end 2, 3>;"}) {
    EXPECT_THAT(refusal(loop, {"--max-turns", "1e6"}), HasSubstr("`--max-turns` raises the limit")) << loop;
  }
}

TEST_F(Runaway, ABillionTurnsEndByThemselves) {
  time_bound_ *= 3;  // ten seconds of a processor, for each command
  EXPECT_THAT(refusal("#while (1) #end"), HasSubstr("more than 1e+09 turns"));
}

TEST_F(Runaway, RecursionEndsAtTheDepthAllowed) {
  for (const std::string_view bomb :
       {"#macro F() F() #end F()", "#macro F() G() #end #macro G() F() #end F()", "#macro F(A) F(F(A)) #end F(1)",
        "#macro F(A) (1 + F(A)) #end #declare B = F(1);", "#macro F() F() F() #end F()",
        "#macro F() #include \"again.inc\" #end F()", "#macro F() #if (F()) #end 1 #end F()",
        "#macro F() union { F() } #end F()", "#macro F(A) <F(A), 1, 2> #end #declare B = F(1);",
        "#macro F(A) sin(F(A)) #end #declare B = F(1);", "#macro F() array[1] { F() } #end #declare A = F();",
        "#macro F() #while (F()) #end #end F()", "#macro F() #declare X = F(); #end F()",
        "#macro F() #for (I, F(), 1) #end #end F()", "#macro F() transform { F() } #end sphere { 0, 1 F() }"}) {
    write("again.inc", "F()");
    const std::string said = refusal(bomb);
    EXPECT_THAT(said, testing::AnyOf(HasSubstr("`--max-depth` raises the limit"),
                                     HasSubstr("`--max-include-depth` raises the limit")))
        << bomb;
    EXPECT_THAT(said, HasSubstr("in macro `F`, called at")) << bomb;
  }
}

TEST_F(Runaway, RecursionThatOnlyBranchesEndsAtTheTurnsAllowed) {
  EXPECT_THAT(refusal("#macro F(N) #if (N > 0) F(N - 1) F(N - 1) #end #end F(60)", {"--max-turns", "1e6"}),
              HasSubstr("`--max-turns` raises the limit"));
}

TEST_F(Runaway, FilesThatIncludeThemselvesEndAtTheIncludeDepth) {
  write("a.inc", "#include \"b.inc\"");
  write("b.inc", "#include \"a.inc\"");
  for (const std::string_view text : {"#include \"scene.isl\"", "#include \"a.inc\""}) {
    EXPECT_THAT(refusal(text), HasSubstr("`--max-include-depth` raises the limit")) << text;
  }
  EXPECT_THAT(refusal("#include \"a.inc\"", {"--max-include-depth", "1000"}), HasSubstr("more than 1000 files"));
}

TEST_F(Runaway, PrimitivesEndAtTheirNumber) {
  for (const std::string_view body :
       {"#while (1) sphere { 0, 1 } #end", "blob { #while (1) sphere { 0, 1, 1 } #end }",
        "#declare S = sphere { 0, 1 } #while (1) S #end", "#while (1) light_source { 0, 1 } #end"}) {
    EXPECT_THAT(refusal(body, {"--max-primitives", "1e4"}), HasSubstr("`--max-primitives` raises the limit")) << body;
    EXPECT_THAT(refusal(body, {"--max-memory", "4M"}), HasSubstr("`--max-memory` raises the limit")) << body;
  }
}

TEST_F(Runaway, ObjectsThatDoubleEnd) {
  const ProcessResult result =
      check("#declare S = sphere { 0, 1 } #for (I, 1, 100) #declare S = union { object { S } object { S } } #end S");
  EXPECT_LE(result.exit_code, 1);
}

TEST_F(Runaway, StringsThatDoubleEndAtTheMemoryAllowed) {
  for (const std::string_view twice : {"concat(S, S)", "concat(S, \"\", S)", "concat(strupr(S), strlwr(S))"}) {
    EXPECT_THAT(refusal(fmt::format("#declare S = \"x\"; #for (I, 1, 100) #declare S = {}; #end", twice)),
                HasSubstr("`--max-memory` raises the limit"))
        << twice;
  }
}

TEST_F(Runaway, ArraysThatAreTooLargeEndAtTheMemoryAllowed) {
  for (const std::string_view text :
       {"#declare A = array[1e9]", "#declare A = array[1e5][1e5]", "#declare A = array[1e4][1e4][1e4][1e4][1e4]",
        "#declare A = array[1000] #for (I, 0, 999) #declare A[I] = array[1e6] #end",
        "#declare A = array[1] {1} #for (I, 1, 31) #declare B = array[2] {A, A} #declare A = B; #end"}) {
    EXPECT_THAT(refusal(text), HasSubstr("`--max-memory` raises the limit")) << text;
  }
  EXPECT_THAT(refusal("#declare A = array[1e300]"), HasSubstr("too large"));
}

TEST_F(Runaway, WarningsAndErrorsEnd) {
  EXPECT_EQ(check("#for (I, 1, 1e5) #warning str(I, 0, 0) #end").exit_code, 0);
  EXPECT_EQ(check(repeated("# ", 1'000'000)).exit_code, 0);
  EXPECT_EQ(check(repeated("sphere { 0, Missing } ", 100'000)).exit_code, 1);
}

TEST_F(Runaway, EachLimitIsInTheHelp) {
  const std::string help = run({"check", "--help"}).out;
  for (const char* const option : {"--max-depth", "--max-turns", "--max-primitives", "--max-memory",
                                   "--max-include-depth", "--allow-write", "--frame", "--clock"}) {
    EXPECT_THAT(help, HasSubstr(option));
  }
}

}  // namespace
}  // namespace isl::test
