// The evaluator's explicit stack: one frame for each list of items in progress (a block's body, a branch, a loop's
// body, a macro call, an include). It is what makes `next element` a pull operation, and it is the macro and include
// chain of diagnostics.
#pragma once

#include "grammar/ast.h"
#include "grammar/loader.h"
#include "interpreter/origin_table.h"

#include <cstdint>
#include <optional>

namespace isl::interpreter {

struct Frame {
  enum class Kind : std::uint8_t {
    block,     ///< the body of a `{}`, bottom of its ElementStream; counts as depth
    value,     ///< the items of a value or a file, bottom of their ElementStream
    branch,    ///< of an #if
    if_block,  ///< a prelude of grammar::IfBlock, after which comes the block itself
    while_,
    for_,
    case_,  ///< of a #switch; falls through to the next
    macro,
    include,
  };
  static constexpr std::uint32_t kNoCall = 0xFFFFFFFFu;

  Kind kind = Kind::block;
  bool condition = false;  ///< if_block: which branch was taken
  grammar::Items items;
  std::size_t position = 0;
  const grammar::Node* node = nullptr;  ///< the directive or call behind the frame
  std::uint32_t call = kNoCall;         ///< index of the innermost macro or include frame, this one included

  // macro and include
  const grammar::Unit* unit = nullptr;
  std::uint32_t origin_name = 0;
  std::optional<OriginTable::Chain> chain = {};  ///< made when first asked for

  // for_
  double end = 0;
  double step = 1;

  // case_
  std::size_t next_case = 0;
};

}  // namespace isl::interpreter
