#include "grammar/symbols.h"

#include "base/check.h"

#include <array>

namespace isl::grammar {
namespace {

struct ReservedWord {
  std::string_view text;
  WordClass word_class;
};

constexpr std::array<ReservedWord, word::kReservedCount> kReservedWords{{
#define ISL_WORD(name, word_class) {#name, WordClass::word_class},
#include "grammar/words.def"
#undef ISL_WORD
}};

constexpr auto kNewerWords = std::to_array<std::string_view>({
#define ISL_NEWER_WORD(name) #name,
#include "grammar/newer_words.def"
#undef ISL_NEWER_WORD
});

}  // namespace

SymbolTable::SymbolTable() {
  for (const ReservedWord& reserved : kReservedWords) {
    const Symbol symbol = intern(reserved.text);
    ISL_CHECK(static_cast<std::size_t>(symbol) + 1 == texts_.size(), "{} stands twice in words.def", reserved.text);
  }
  for (const std::string_view newer : kNewerWords) {
    const Symbol symbol = intern(newer);
    ISL_CHECK(static_cast<std::size_t>(symbol) + 1 == texts_.size(), "{} is reserved or stands twice", newer);
  }
}

Symbol SymbolTable::intern(std::string_view text) {
  const auto found = symbols_.find(text);
  if (found != symbols_.end()) return found->second;
  const std::string_view kept = storage_.emplace_back(text);
  const Symbol symbol{static_cast<std::uint32_t>(texts_.size())};
  texts_.push_back(kept);
  symbols_.emplace(kept, symbol);
  return symbol;
}

WordClass SymbolTable::word_class(Symbol symbol) const {
  return is_reserved(symbol) ? kReservedWords[static_cast<std::uint32_t>(symbol)].word_class : WordClass::identifier;
}

}  // namespace isl::grammar
