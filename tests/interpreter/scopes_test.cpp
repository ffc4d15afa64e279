#include "interpreter/scopes.h"

#include <gtest/gtest.h>

namespace isl::interpreter {
namespace {

using grammar::Symbol;

constexpr Symbol kA{1000}, kB{5};

double number(const Scopes& scopes, Symbol name) { return scopes.find(name)->value.number(); }

TEST(Scopes, NothingIsDeclaredAtFirst) {
  Scopes scopes;
  EXPECT_EQ(scopes.find(kA), nullptr);
  EXPECT_FALSE(scopes.undef(kA));
  EXPECT_TRUE(scopes.declared().empty());
}

TEST(Scopes, ALocalHidesAndUncoversTheGlobal) {
  Scopes scopes;
  scopes.declare(kA).value = Value(1.0);
  scopes.enter();
  scopes.local(kA).value = Value(2.0);
  EXPECT_EQ(number(scopes, kA), 2);
  scopes.declare(kA).value = Value(3.0);
  EXPECT_EQ(number(scopes, kA), 3);
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 1);
}

TEST(Scopes, ADeclarationInsideACallIsGlobal) {
  Scopes scopes;
  scopes.enter();
  scopes.enter();
  scopes.declare(kA).value = Value(1.0);
  scopes.leave();
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 1);
}

TEST(Scopes, AParameterIsItsCallersSlot) {
  Scopes scopes;
  Slot& slot = scopes.declare(kA);
  slot.value = Value(1.0);
  scopes.enter();
  scopes.slots().retain(&slot);
  scopes.bind(kB, &slot);
  scopes.declare(kB).value = Value(2.0);
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 2);
  EXPECT_EQ(scopes.find(kB), nullptr);
}

TEST(Scopes, AParameterOutlivesTheUndefOfWhatItRefersTo) {
  Scopes scopes;
  Slot& slot = scopes.declare(kA);
  slot.value = Value(1.0);
  scopes.enter();
  scopes.slots().retain(&slot);
  scopes.bind(kB, &slot);
  EXPECT_TRUE(scopes.undef(kA));
  EXPECT_EQ(number(scopes, kB), 1);
  scopes.leave();
  EXPECT_EQ(scopes.find(kA), nullptr);
}

TEST(Scopes, UndefTakesTheInnermostBindingAndLeavingNoOther) {
  Scopes scopes;
  scopes.declare(kA).value = Value(1.0);
  scopes.enter();
  scopes.local(kA).value = Value(2.0);
  EXPECT_TRUE(scopes.undef(kA));
  EXPECT_EQ(number(scopes, kA), 1);
  scopes.local(kA).value = Value(3.0);
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 1);
}

TEST(Scopes, AGlobalCanBeMadeBelowALocal) {
  Scopes scopes;
  scopes.enter();
  scopes.local(kA).value = Value(2.0);
  scopes.global(kA).value = Value(1.0);
  EXPECT_EQ(number(scopes, kA), 2);
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 1);
}

TEST(Scopes, UndefUncoversTableByTable) {
  Scopes scopes;
  scopes.declare(kA).value = Value(1.0);
  scopes.enter();
  scopes.local(kA).value = Value(2.0);
  scopes.enter();
  scopes.local(kA).value = Value(3.0);
  EXPECT_TRUE(scopes.undef(kA));
  EXPECT_EQ(number(scopes, kA), 2);
  EXPECT_TRUE(scopes.undef(kA));
  EXPECT_EQ(number(scopes, kA), 1);
  scopes.global(kA).value = Value(4.0);
  scopes.leave();
  scopes.leave();
  EXPECT_EQ(number(scopes, kA), 4);
  EXPECT_TRUE(scopes.undef(kA));
  EXPECT_EQ(scopes.find(kA), nullptr);
}

}  // namespace
}  // namespace isl::interpreter
