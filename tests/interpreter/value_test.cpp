#include "interpreter/arithmetic.h"
#include "interpreter/shared_values.h"

#include <gtest/gtest.h>

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
      for (Slot* const element : outer->elements) {
        element->value =
            Value(ValueKind::array, make_shared_value<ArrayValue>(std::vector<std::size_t>{1}, pool, account));
      }
      EXPECT_EQ(account.bytes(), bytes_of_copy(Value(ValueKind::array, outer)));
      // An array of one number takes five pieces of memory.
      EXPECT_GE(account.bytes(), 1000 * (sizeof(ArrayValue) + 2 * sizeof(Slot) + 2 * sizeof(Slot*)));
    }
    EXPECT_EQ(account.bytes(), 2000 * kSlotBytes) << "slots wait for their next use";
  }
}

TEST(Value, AnArraysCopyHasElementsOfItsOwn) {
  MemoryAccount account;
  SlotPool pool;
  const Ref<ArrayValue> a = make_shared_value<ArrayValue>(std::vector<std::size_t>{2}, pool, account);
  a->elements[0]->value = Value(1.0);
  const Value copy = copy_of_container(Value(ValueKind::array, a));
  const auto& b = copy.as<ArrayValue>();
  b.elements[0]->value = Value(2.0);
  EXPECT_EQ(a->elements[0]->value.number(), 1);
  EXPECT_EQ(b.elements[1]->value.kind(), ValueKind::none);
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
