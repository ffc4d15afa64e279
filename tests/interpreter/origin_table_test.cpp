#include "interpreter/origin_table.h"

#include <gtest/gtest.h>

namespace isl::interpreter {
namespace {

TEST(OriginTable, UnknownOriginIsNowhere) {
  const Origin origin = OriginTable().resolve(OriginId{});
  EXPECT_TRUE(origin.span.empty());
  EXPECT_TRUE(origin.chain.empty());
}

TEST(OriginTable, ChainIsToldFromTheInnermostCallOut) {
  OriginTable table;
  const auto outer = table.extend(0, ExpansionFrame::Kind::include, table.keep_name("a.inc"), {1, 2});
  const auto inner = table.extend(outer, ExpansionFrame::Kind::macro, table.keep_name("Tree"), {3, 4});
  const Origin origin = table.resolve(table.add({5, 6}, inner));
  EXPECT_EQ(origin.span, (SourceSpan{5, 6}));
  ASSERT_EQ(origin.chain.size(), 2u);
  EXPECT_EQ(origin.chain[0].name, "Tree");
  EXPECT_EQ(origin.chain[0].call, (SourceSpan{3, 4}));
  EXPECT_EQ(origin.chain[1].name, "a.inc");
  EXPECT_EQ(origin.chain[1].kind, ExpansionFrame::Kind::include);
}

TEST(OriginTable, ChainsShareTheirTails) {
  OriginTable table;
  const auto name = table.keep_name("M");
  const auto tail = table.extend(0, ExpansionFrame::Kind::macro, name, {1, 2});
  const OriginId a = table.add({}, table.extend(tail, ExpansionFrame::Kind::macro, name, {3, 4}));
  const OriginId b = table.add({}, table.extend(tail, ExpansionFrame::Kind::macro, name, {5, 6}));
  EXPECT_EQ(table.resolve(a).chain[1].call, table.resolve(b).chain[1].call);
  EXPECT_NE(table.resolve(a).chain[0].call, table.resolve(b).chain[0].call);
}

}  // namespace
}  // namespace isl::interpreter
