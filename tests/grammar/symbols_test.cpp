#include "grammar/symbols.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isl::grammar {
namespace {

TEST(SymbolTable, KnowsReservedWordsAtTheirConstants) {
  SymbolTable symbols;
  EXPECT_EQ(symbols.intern("sphere"), word::kw_sphere);
  EXPECT_EQ(symbols.text(word::kw_true), "true");
  EXPECT_EQ(symbols.size(), static_cast<std::size_t>(newer_word::kIndexAfter));
}

TEST(SymbolTable, InternsANameOnce) {
  SymbolTable symbols;
  const Symbol tree = symbols.intern("Tree");
  for (int i = 0; i < 1000; ++i) static_cast<void>(symbols.intern(fmt::format("Name{}", i)));
  EXPECT_EQ(symbols.intern("Tree"), tree);
  EXPECT_EQ(symbols.text(tree), "Tree");
  EXPECT_FALSE(is_reserved(tree));
}

TEST(SymbolTable, ClassifiesWords) {
  SymbolTable symbols;
  EXPECT_EQ(symbols.word_class(word::kw_sphere), WordClass::keyword);
  EXPECT_EQ(symbols.word_class(word::kw_threshold), WordClass::keyword);
  EXPECT_EQ(symbols.word_class(word::kw_rgb), WordClass::colour);
  EXPECT_EQ(symbols.word_class(word::kw_vrotate), WordClass::function);
  EXPECT_EQ(symbols.word_class(word::kw_x), WordClass::constant);
  EXPECT_EQ(symbols.word_class(symbols.intern("Tree")), WordClass::identifier);
}

TEST(SymbolTable, ReservesNoWordOfOurs) {
  SymbolTable symbols;
  for (const char* const word : {"kernel", "hardness", "skeleton", "convolution", "solver", "tolerance"}) {
    EXPECT_FALSE(is_reserved(symbols.intern(word))) << word;
  }
}

}  // namespace
}  // namespace isl::grammar
