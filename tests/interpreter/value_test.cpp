#include "interpreter/arithmetic.h"
#include "interpreter/shared_values.h"

#include <gtest/gtest.h>

#include <limits>

#include <utility>

namespace isl::interpreter {
namespace {

TEST(Value, CopiesShareAndTheLastOneFrees) {
  MemoryAccount account;
  {
    Value a(ValueKind::string, make_shared_value<StringValue>("text", account));
    const Value b = a;
    EXPECT_EQ(&a.as<StringValue>(), &b.as<StringValue>());
    a = Value(1.0);
    EXPECT_EQ(b.as<StringValue>().text, "text");
    EXPECT_GT(account.bytes(), 0u);
  }
  EXPECT_EQ(account.bytes(), 0u);
}

TEST(Value, AssigningToItselfAndMovingKeepTheContents) {
  MemoryAccount account;
  Value a(ValueKind::string, make_shared_value<StringValue>("text", account));
  const Value& same = a;
  a = same;
  Value b = std::move(a);
  b = Value(2.0);
  b = Value(3, {1, 2, 3});
  EXPECT_EQ(b.term_count(), 3);
  EXPECT_EQ(account.bytes(), 0u);
}

TEST(Value, ArraysCountWhatTheyTake) {
  MemoryAccount account;
  {
    SlotPool pool(&account);
    {
      const Ref<ArrayValue> outer = make_shared_value<ArrayValue>(std::vector<std::size_t>{1000}, pool, account);
      for (std::size_t i = 0; i < 1000; ++i) {
        outer->elements.set(
            i, Value(ValueKind::array, make_shared_value<ArrayValue>(std::vector<std::size_t>{1}, pool, account)));
      }
      EXPECT_EQ(account.bytes(), bytes_of_copy(Value(ValueKind::array, outer)));
      EXPECT_GE(account.bytes(), 1000 * (sizeof(ArrayValue) + sizeof(Slot) + sizeof(Slot*) + 2 * sizeof(double)));
    }
    EXPECT_EQ(account.bytes(), 1000 * kSlotBytes) << "slots wait for their next use";
  }
}

TEST(Value, AnArraysCopyHasElementsOfItsOwn) {
  MemoryAccount account;
  SlotPool pool;
  const Ref<ArrayValue> a = make_shared_value<ArrayValue>(std::vector<std::size_t>{2}, pool, account);
  a->elements.set(0, Value(1.0));
  const Value copy = copy_of_container(Value(ValueKind::array, a));
  auto& b = copy.as<ArrayValue>();
  b.elements.set(0, Value(2.0));
  EXPECT_EQ(*a->elements.number(0), 1);
  EXPECT_EQ(b.elements.number(1), nullptr);
  EXPECT_EQ(b.elements.slot(1).value.kind(), ValueKind::none);
}

TEST(Value, NumbersOfAnArrayTakeSlotsOnlyWhereTheirPlacesAreAskedFor) {
  MemoryAccount account;
  SlotPool pool(&account);
  ArrayElements elements(pool, account);
  elements.grow(1000);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_TRUE(elements.set_number(i, static_cast<double>(i)));
  EXPECT_EQ(account.bytes(), 1000 * sizeof(double));
  Slot& place = elements.slot(7);
  EXPECT_EQ(place.value.number(), 7);
  EXPECT_EQ(account.bytes(), elements.bytes() + kSlotBytes);
  EXPECT_EQ(elements.bytes(), 1000 * (sizeof(double) + sizeof(Slot*)));
  // What is written by either way is read by both.
  EXPECT_TRUE(elements.set_number(7, 70));
  EXPECT_EQ(place.value.number(), 70);
  place.value = Value(3, {1, 2, 3});
  EXPECT_EQ(elements.number(7), nullptr);
  elements.set(7, Value(700.0));
  EXPECT_EQ(*elements.number(7), 700);
  EXPECT_EQ(*elements.number(8), 8);
  // A number that is none is set.
  EXPECT_TRUE(elements.set_number(9, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_NE(elements.number(9), nullptr);
  elements.grow(1001);
  EXPECT_EQ(elements.number(1000), nullptr);
}

TEST(Arithmetic, ANumberFillsAndAVectorIsPadded) {
  const double one[] = {1}, three[] = {1, 2, 3, 0, 0}, two[] = {1, 2, 0, 0, 0}, five[] = {0, 0, 1, 0, 1};
  const Value sum = arithmetic(grammar::BinaryOp::add, {one, 1}, {three, 3});
  EXPECT_EQ(sum.terms(), (Value::Terms{2, 3, 4, 0, 0}));
  const Value padded = arithmetic(grammar::BinaryOp::add, {two, 2}, {five, 5});
  EXPECT_EQ(padded.term_count(), 5);
  EXPECT_EQ(padded.terms(), (Value::Terms{1, 2, 1, 0, 1}));
}

}  // namespace
}  // namespace isl::interpreter
