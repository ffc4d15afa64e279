// Interned names. Reserved words come first and in the order of words.def, so that each is a compile-time constant
// (`word::kw_sphere`) and comparing words is comparing integers. The words of POV-Ray 3.8 follow in the same way.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isl::grammar {

/// The number of an interned name; valid for the SymbolTable that made it.
enum class Symbol : std::uint32_t {};
inline constexpr Symbol kNoSymbol{0xFFFFFFFFu};

/// The grammar's treatment of a reserved word. `identifier` is every name that is not reserved.
enum class WordClass : std::uint8_t {
  identifier,
  keyword,
  colour,
  texture,
  function,
  constant,
  array,
  function_literal
};

namespace word {
enum Index : std::uint32_t {
#define ISL_WORD(name, word_class) kIndex_##name,
#include "grammar/words.def"
#undef ISL_WORD
  kReservedCount
};
#define ISL_WORD(name, word_class) inline constexpr Symbol kw_##name{kIndex_##name};
#include "grammar/words.def"
#undef ISL_WORD
}  // namespace word

/// The words of newer_words.def: identifiers whose symbols are constants, too.
namespace newer_word {
enum Index : std::uint32_t {
  kIndexBefore = static_cast<std::uint32_t>(word::kReservedCount) - 1,
#define ISL_NEWER_WORD(name) kIndex_##name,
#include "grammar/newer_words.def"
#undef ISL_NEWER_WORD
  kIndexAfter
};
#define ISL_NEWER_WORD(name) inline constexpr Symbol kw_##name{kIndex_##name};
#include "grammar/newer_words.def"
#undef ISL_NEWER_WORD
}  // namespace newer_word

/// Texts by symbol and symbols by text. Not thread-safe; one a scene.
class SymbolTable {
 public:
  SymbolTable();
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  [[nodiscard]] Symbol intern(std::string_view text);
  /// Empty for kNoSymbol, because callers also ask for the name of a block without a word.
  [[nodiscard]] std::string_view text(Symbol symbol) const {
    return symbol == kNoSymbol ? std::string_view() : texts_[static_cast<std::uint32_t>(symbol)];
  }
  [[nodiscard]] WordClass word_class(Symbol symbol) const;
  [[nodiscard]] std::size_t size() const { return texts_.size(); }

 private:
  std::deque<std::string> storage_;
  std::vector<std::string_view> texts_;
  std::unordered_map<std::string_view, Symbol> symbols_;
};

[[nodiscard]] constexpr bool is_reserved(Symbol symbol) {
  return static_cast<std::uint32_t>(symbol) < word::kReservedCount;
}

[[nodiscard]] constexpr bool is_newer_word(Symbol symbol) {
  const auto index = static_cast<std::uint32_t>(symbol);
  return index > newer_word::kIndexBefore && index < newer_word::kIndexAfter;
}

}  // namespace isl::grammar
