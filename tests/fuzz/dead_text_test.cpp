// Text that is never executed, made of random tokens. In such text POV-Ray looks only for directives that nest, strings
// and comments, so nothing in it may be reported, and the text behind it is executed. ISL_DEAD_TEXTS sets the number of
// texts, ISL_DEAD_TEXT_SEED the first seed.
#include "grammar/symbols.h"
#include "tests/interpreter/evaluated_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {
namespace {

constexpr const char* kSmall[] = {
    "(", ")", "[", "]", "{", "}", "<", ">", ",", ";", ".", "?",  ":",  "=",  "+", "-", "*", "/", "!", "&", "|",
    "(", ")", "[", "]", "{", "}", "(", "[", "{", ",", ";", "<=", ">=", "!=", "1", "2", "A", "B", "@", "%", "'",
};
constexpr const char* kStatements[] = {
    "#declare", "#local", "#undef",  "#include", "#version", "#default", "#debug", "#warning",
    "#error",   "#fopen", "#fclose", "#read",    "#write",   "#break",   "#foo",   "# @",
};
constexpr const char* kOpeners[] = {"#if", "#ifdef", "#ifndef", "#while", "#for", "#switch", "#macro"};
constexpr const char* kDividers[] = {"#else", "#elseif", "#case", "#range"};
constexpr const char* kPhrases[] = {
    "\"text\"",
    "\"a\nb\"",
    "// it's {\n",
    "/* #end */",
    "#declare A = ",
    "#local deprecated once ",
    "A [",
    "function",
    "#declare A = (",
    "#for (I, 1, 2)",
    "#macro M(",
    "#if (1)",
    "function (",
    "array [",
    "#switch (1)",
    "#case (1)",
    "#range (1,",
    "#if (1) merge {",
    "pigment { [0",
    "texture {",
    "#read (F,",
    "#if (1) union { #else",
    "A (",
    "sin(",
    "#ifdef (A",
};

/// Every directive that needs an `#end` has one, and no `#end` or divider stands outside of one.
class DeadText {
 public:
  explicit DeadText(std::uint64_t seed) : random_(seed) {
    const grammar::SymbolTable symbols;
    for (std::uint32_t i = 0; i < grammar::word::kReservedCount; ++i)
      words_.emplace_back(symbols.text(grammar::Symbol{i}));
  }

  [[nodiscard]] std::string next() {
    text_.clear();
    open_ = 0;
    const std::size_t count = below(40);
    for (std::size_t i = 0; i < count; ++i) add();
    for (; open_ > 0; --open_) text_ += " #end";
    return text_;
  }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

  template <std::size_t count>
  std::string_view pick(const char* const (&list)[count]) {
    return list[below(count)];
  }

  void add() {
    text_ += ' ';
    const std::size_t kind = below(20);
    if (kind < 2) return open(pick(kOpeners));
    if (kind < 4) return close();
    if (kind < 5) return divide();
    if (kind < 7) return phrase(pick(kPhrases));
    if (kind < 9) text_ += pick(kStatements);
    if (kind >= 9 && kind < 12) text_ += words_[below(words_.size())];
    if (kind >= 12) text_ += pick(kSmall);
  }

  void open(std::string_view opener) {
    text_ += opener;
    ++open_;
  }
  void close() {
    if (open_ == 0) return;
    text_ += "#end";
    --open_;
  }
  void divide() {
    if (open_ > 0) text_ += pick(kDividers);
  }
  void phrase(std::string_view phrase) {
    const bool divides = phrase.starts_with("#case") || phrase.starts_with("#range");
    if (divides && open_ == 0) return;
    for (const std::string_view opener : kOpeners) open_ += phrase.starts_with(std::string(opener) + " ");
    text_ += phrase;
  }

  std::mt19937_64 random_;
  std::vector<std::string> words_;
  std::string text_;
  std::size_t open_ = 0;
};

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* const value = std::getenv(name);
  return value ? std::stoull(value) : otherwise;
}

/// Places that are never executed, and the text behind each.
constexpr std::string_view kDeadPlaces[] = {
    "#if (0)\n{}\n#end\n#debug \"on\"",
    "#if (1) #else\n{}\n#end\n#debug \"on\"",
    "#ifdef (Nothing)\n{}\n#end\n#debug \"on\"",
    "#macro Uncalled()\n{}\n#end\n#debug \"on\"",
    "#macro Called() #break\n{}\n#end Called()\n#debug \"on\"",
    "#while (0)\n{}\n#end\n#debug \"on\"",
    "#for (I, 2, 1)\n{}\n#end\n#debug \"on\"",
    "#switch (1) #case (2)\n{}\n#end\n#debug \"on\"",
    "union {{ sphere {{ 0, 1 }} #if (0)\n{}\n#end #debug \"on\" }}",
};

TEST(DeadText, IsNeverTold) {
  const std::uint64_t seed = setting("ISL_DEAD_TEXT_SEED", 1), count = setting("ISL_DEAD_TEXTS", 5000);
  for (std::uint64_t i = seed; i < seed + count; ++i) {
    const std::string_view place = kDeadPlaces[i % std::size(kDeadPlaces)];
    const std::string scene = fmt::format(fmt::runtime(place), DeadText(i).next());
    const EvaluatedText text(scene);
    ASSERT_EQ(text.messages(), "") << "seed " << i << ":\n" << scene;
    ASSERT_EQ(text.said(), "on") << "seed " << i << ":\n" << scene;
  }
}

}  // namespace
}  // namespace isl::test
