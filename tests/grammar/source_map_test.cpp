#include "grammar/source_map.h"

#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

TEST(SourceMap, StartsTheFirstFileAtOffsetOne) {
  SourceMap map;
  EXPECT_EQ(map.add("a", "xy"), (SourceSpan{1, 3}));
}

TEST(SourceMap, TellsFilesApart) {
  SourceMap map;
  const SourceSpan first = map.add("a", "one\n").value();
  const SourceSpan empty = map.add("b", "").value();
  const SourceSpan last = map.add("c", "two").value();
  EXPECT_EQ(map.position(first.begin).file, "a");
  EXPECT_EQ(map.position(first.end).file, "a") << "the end of a file belongs to it";
  EXPECT_EQ(map.position(empty.begin).file, "b");
  EXPECT_EQ(map.position(last.begin).file, "c");
}

TEST(SourceMap, CountsLinesAndColumnsFromOne) {
  SourceMap map;
  const std::uint32_t begin = map.add("a", "ab\n\ncd\n").value().begin;
  const auto at = [&](std::uint32_t place) {
    const SourcePosition position = map.position(begin + place);
    return std::pair(position.line, position.column);
  };
  EXPECT_EQ(at(0), std::pair(std::size_t{1}, std::size_t{1}));
  EXPECT_EQ(at(2), std::pair(std::size_t{1}, std::size_t{3})) << "the end of a line belongs to it";
  EXPECT_EQ(at(3), std::pair(std::size_t{2}, std::size_t{1}));
  EXPECT_EQ(at(5), std::pair(std::size_t{3}, std::size_t{2}));
  EXPECT_EQ(at(7), std::pair(std::size_t{4}, std::size_t{1})) << "the end of the file";
}

TEST(SourceMap, EndsLinesWhereUnixOldMacsAndDosEndThem) {
  SourceMap map;
  const std::uint32_t begin = map.add("a", "a\rb\r\rc\r\nd\n\re\n\nf").value().begin;
  const std::string_view text = map.text({begin, begin + 15});
  const auto line_of = [&](char c) { return map.position(begin + static_cast<std::uint32_t>(text.find(c))).line; };
  EXPECT_EQ(line_of('a'), 1u);
  EXPECT_EQ(line_of('b'), 2u);
  EXPECT_EQ(line_of('c'), 4u) << "an empty line between two CR";
  EXPECT_EQ(line_of('d'), 5u) << "CR LF is one end";
  EXPECT_EQ(line_of('e'), 6u) << "and so is LF CR";
  EXPECT_EQ(line_of('f'), 8u);
  EXPECT_EQ(map.line_text(begin + static_cast<std::uint32_t>(text.find('d'))), "d");
  EXPECT_EQ(map.line_text(begin + static_cast<std::uint32_t>(text.find('b'))), "b");
}

TEST(SourceMap, CountsColumnsInCharactersOfUtf8) {
  SourceMap map;
  const std::uint32_t begin = map.add("a", "\"äö€𝄞\" x").value().begin;
  EXPECT_EQ(map.position(begin + 1 + 2 + 2 + 3 + 4 + 2).column, 8u);
}

TEST(SourceMap, KnowsNothingOfPlacesInNoFile) {
  SourceMap map;
  const SourceSpan span = map.add("a", "x").value();
  EXPECT_EQ(map.position(0).line, 0u);
  EXPECT_EQ(map.position(span.end + 1).line, 0u);
  EXPECT_EQ(map.line_text(0), "");
  EXPECT_EQ(map.text({0, 0}), "");
}

TEST(SourceMap, GivesALineWithoutItsEnd) {
  SourceMap map;
  const std::uint32_t begin = map.add("a", "one\r\ntwo").value().begin;
  EXPECT_EQ(map.line_text(begin + 1), "one");
  EXPECT_EQ(map.line_text(begin + 6), "two");
}

}  // namespace
}  // namespace isl::grammar
