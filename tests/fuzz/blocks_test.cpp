// Every reserved word as a block with every kind of content, and without one, in every place where blocks are read.
#include "tests/fuzz/hostile_text.h"
#include "tests/fuzz/kinds_of_values.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

namespace isl::test {
namespace {

using testing::IsEmpty;

/// The reserved words, our own words, a declared name, an undeclared one, and no word at all.
std::vector<std::string> block_words() {
  std::vector<std::string> words{"",          "kernel", "hardness", "convolution", "skeleton", "solver",
                                 "tolerance", "Ball",   "Number",   "Undeclared",  "Yield(1)", "Nothing()"};
#define ISL_WORD(name, word_class) words.emplace_back(#name);
#include "grammar/words.def"
#undef ISL_WORD
  return words;
}

/// `{0}` is the word.
constexpr const char* kContents[] = {"{0} {{ }}",
                                     "{0} {{ 1 }}",
                                     "{0} {{ \"text\" }}",
                                     "{0} {{ {{ }} }}",
                                     "{0} {{ {0} {{ }} }}",
                                     "{0} {{ sphere {{ 0, 1 }} }}",
                                     "{0} {{ pigment {{ rgb 1 }} }}",
                                     "{0} {{ <1, 2, 3>, <1, 2, 3>, 1, <1, 2, 3> }}",
                                     "{0} {{ [0 rgb 1] }}",
                                     "{0} {{ Ball }}",
                                     "{0} {{ Pigment }}",
                                     "{0} {{ function {{ x }} }}",
                                     "{0} {{ gradient x {0} }}",
                                     "{0} {{ , }}",
                                     "{0}",
                                     "{0} 1",
                                     "{0} 1, 2",
                                     "{0} <1, 2, 3>",
                                     "{0} \"text\"",
                                     "{0} {0}",
                                     "{0} rgb 1"};

/// `{}` is the block. Each place ends its statement.
constexpr const char* kPlaces[] = {"{}",
                                   "#declare R = {}; #undef R",
                                   "sphere {{ 0, 1 {} }}",
                                   "sphere {{ {} }}",
                                   "union {{ {} }}",
                                   "intersection {{ sphere {{ 0, 1 }} {} }}",
                                   "object {{ {} }}",
                                   "blob {{ {} }}",
                                   "blob {{ kernel \"soft\" sphere {{ 0, 1 {} }} }}",
                                   "blob {{ union {{ {} }} }}",
                                   "texture {{ {} }}",
                                   "sphere {{ 0, 1 texture {{ {} }} }}",
                                   "sphere {{ 0, 1 texture {{ gradient x texture_map {{ [0 {}] }} }} }}",
                                   "sphere {{ 0, 1 pigment {{ {} }} }}",
                                   "sphere {{ 0, 1 pigment {{ gradient x {} }} }}",
                                   "sphere {{ 0, 1 pigment {{ bozo color_map {{ [0 {}] }} }} }}",
                                   "sphere {{ 0, 1 pigment {{ bozo pigment_map {{ [0 {}] }} }} }}",
                                   "sphere {{ 0, 1 pigment {{ checker {} }} }}",
                                   "sphere {{ 0, 1 normal {{ {} }} }}",
                                   "sphere {{ 0, 1 normal {{ bumps {} }} }}",
                                   "sphere {{ 0, 1 finish {{ {} }} }}",
                                   "sphere {{ 0, 1 finish {{ reflection {{ {} }} }} }}",
                                   "sphere {{ 0, 1 interior {{ {} }} }}",
                                   "sphere {{ 0, 1 material {{ {} }} }}",
                                   "sphere {{ 0, 1 clipped_by {{ {} }} }}",
                                   "camera {{ {} }}",
                                   "light_source {{ 0, rgb 1 {} }}",
                                   "light_source {{ {} }}",
                                   "light_group {{ {} }}",
                                   "sky_sphere {{ {} }}",
                                   "fog {{ {} }}",
                                   "rainbow {{ {} }}",
                                   "background {{ {} }}",
                                   "global_settings {{ {} }}",
                                   "#default {{ {} }}",
                                   "#declare R = transform {{ {} }} #undef R",
                                   "#declare R = spline {{ {} }} #undef R",
                                   "#declare R = function {{ {} }} #undef R",
                                   "#declare R = function (x) {{ {} }} #undef R",
                                   "#declare R = function {{ pattern {{ {} }} }} #undef R",
                                   "#declare R = function {{ pigment {{ {} }} }} #undef R",
                                   "sphere {{ 0, 1 pigment {{ function {{ {} }} }} }}",
                                   "sphere {{ 0, 1 pigment {{ image_map {{ {} }} }} }}",
                                   "sphere {{ 0, 1 pigment {{ bozo warp {{ {} }} }} }}",
                                   "#declare R = array[1] {{ {} }} #undef R",
                                   "#declare R = ({}); #undef R",
                                   "#declare R = <{}, 1>; #undef R",
                                   "Yield({})",
                                   "#write (F, {})",
                                   "polygon {{ 3, {} }}"};

/// The first five contents stand in every place. Of the others, which make half a million texts, only one in kOneIn is
/// tried unless ISL_FUZZ_ALL is set.
constexpr std::size_t kEveryContent = 5, kOneIn = 11;

class Blocks : public testing::TestWithParam<const char*> {};

TEST_P(Blocks, AreReadOrRefusedWithAPlace) {
  const bool all = std::getenv("ISL_FUZZ_ALL") != nullptr;
  StatementBatch batch(declarations_of_every_kind());
  std::size_t number = 0;
  for (const std::string& word : block_words()) {
    for (std::size_t i = 0; i < std::size(kContents); ++i) {
      if (!all && i >= kEveryContent && ++number % kOneIn != 0) continue;
      const std::string block = fmt::format(fmt::runtime(kContents[i]), word);
      batch.add(fmt::format(fmt::runtime(GetParam()), block));
    }
  }
  batch.flush();
  EXPECT_GT(batch.count(), 3000u);
  EXPECT_THAT(batch.troubles(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(EveryPlace, Blocks, testing::ValuesIn(kPlaces));

}  // namespace
}  // namespace isl::test
