// The evaluator's explicit stack: one frame for each list of items in progress (a block's body, a branch, a loop's
// body, a macro call, an include). It makes `next element` a pull operation, and it is the macro and include chain of
// diagnostics.
#pragma once

#include "grammar/ast.h"
#include "grammar/loader.h"
#include "interpreter/origin_table.h"

#include <cstdint>
#include <type_traits>

namespace isl::interpreter {

/// Small and plain, because every branch and every macro call makes one.
struct Frame {
  enum class Kind : std::uint8_t {
    block,  ///< the body of a `{}`, bottom of its ElementStream; counts as depth
    value,  ///< the items of a value or a file, bottom of their ElementStream
    include,
    // The kinds from here on are given up after an error inside them (ElementStream::recover).
    branch,  ///< of an #if
    macro,
    // In the kinds from here on, something follows the last item.
    while_,
    for_,
    case_,  ///< of a #switch; falls through to the next
  };
  static constexpr std::uint32_t kNoCall = 0xFFFFFFFFu;
  static constexpr OriginTable::Chain kNoChain = 0xFFFFFFFFu;

  /// Data of a macro call or an include.
  struct Call {
    const grammar::Unit* unit;
    std::uint32_t origin_name;
    OriginTable::Chain chain;  ///< made when first needed, kNoChain before
  };
  /// Data of a #for.
  struct Range {
    double end;
    double step;
  };

  Kind kind;
  std::uint32_t call;                ///< index of the innermost macro or include frame, this one included
  const grammar::Node* const* next;  ///< the first of the remaining items
  const grammar::Node* const* end;
  const grammar::Node* node;  ///< the directive or call behind the frame; null for block and value
  union {
    Call called;            ///< macro, include
    Range range;            ///< for_
    std::size_t next_case;  ///< case_
  };

  /// Continues the frame with `items`.
  void set_items(grammar::Items items) {
    next = items.data();
    end = items.data() + items.size();
  }
};
static_assert(std::is_trivially_copyable_v<Frame> && sizeof(Frame) == 48);

}  // namespace isl::interpreter
