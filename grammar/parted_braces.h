// Blocks whose braces stand in different branches, as POV-Ray's users write them:
//
//   #if (Cut) difference { #end                  #if (Both) merge { #else union { #end
//     sphere { 0, 1 }                              sphere { 0, 1 }
//   #if (Cut) box { 0, 2 } } #end                  sphere { x, 1 } }
//
// Which of them belong together is known only when the branches are executed. So they are no brackets for the parser,
// but items that begin and end a block (`BlockBegin`), and the evaluator pairs them. This file finds them: a second
// pass over the tokens of a text in which the first met a brace without its partner.
#pragma once

#include "grammar/lexer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isl::grammar {

/// The places of the braces that stand in branches (`#if`, `#ifdef`, `#ifndef`, `#switch`) without their partners, and
/// of those that are these partners, in the order of the text. Branches of one directive count as doing the same, as
/// far as they open or close anything; that they do is checked in execution. Where braces do not match even so, only
/// directives count whose branches all do the same. Loops and macros must match in themselves. Empty if braces of the
/// whole text do not match, if one of these braces is not a block's, or if more than `max_nesting` directives are open.
/// Throws ScannerFailure.
[[nodiscard]] std::vector<std::uint32_t> find_parted_braces(Lexer& lexer, std::size_t max_nesting);

}  // namespace isl::grammar
