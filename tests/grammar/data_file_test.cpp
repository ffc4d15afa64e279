#include "grammar/data_file.h"

#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

/// All values of a text, one after another as text, up to the end or a mistake.
std::string read_all(std::string_view text) {
  SymbolTable symbols;
  Arena arena;
  DiagnosticSink sink;
  DataFile file(text, 1, symbols, arena, sink);
  std::string result;
  while (true) {
    const Datum datum = file.next();
    switch (datum.kind) {
      case Datum::Kind::end: return result;
      case Datum::Kind::mistake: return result + "! " + datum.text + " at " + std::to_string(datum.span.begin);
      case Datum::Kind::string: result += datum.text; break;
      case Datum::Kind::number:
      case Datum::Kind::vector:
        for (int i = 0; i < datum.count; ++i) result += std::to_string(datum.terms[i]).substr(0, 4) + " ";
    }
    result += file.is_at_end() ? "|end" : "|";
  }
}

TEST(DataFile, GivesNumbersVectorsAndStrings) {
  EXPECT_EQ(read_all("1, - 2.5 , +3e1\n,<1,-2>, <1 2 3>, <1,2,3,4,5>, \"a\\\"b\", \"two\nlines\""),
            "1.00 |-2.5 |30.0 |1.00 -2.0 |1.00 2.00 3.00 |1.00 2.00 3.00 4.00 5.00 |a\"b|two\nlines|end");
}

TEST(DataFile, PassesOverCommentsAndTakesSemicolons) {
  EXPECT_EQ(read_all("1, // one\n 2 /* two, */; 3"), "1.00 |2.00 |3.00 |end");
}

TEST(DataFile, MayBeEmptyOrEndWithAComma) {
  EXPECT_EQ(read_all(""), "");
  EXPECT_EQ(read_all(" \n"), "");
  EXPECT_EQ(read_all("1,\n"), "1.00 |");
}

TEST(DataFile, SaysWhatItWanted) {
  EXPECT_EQ(read_all("1 2"), "! expected `,` between the values of a file at 3");
  EXPECT_EQ(read_all("1, hello"), "1.00 |! expected a number, a vector or a string in quotes at 4");
  EXPECT_EQ(read_all("--1"), "! expected a number, a vector or a string in quotes at 2");
  EXPECT_EQ(read_all("<1>"), "! expected a number or `>` of a vector of 2 to 5 numbers at 3");
  EXPECT_EQ(read_all("<1,2"), "! expected a number or `>` of a vector of 2 to 5 numbers at 5");
  EXPECT_EQ(read_all("<1,2,3,4,5,6>"), "! expected `>`: a vector has at most 5 numbers at 12");
}

}  // namespace
}  // namespace isl::grammar
