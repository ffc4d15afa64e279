// Tokens and syntax trees as text: `isl dump --stage tokens|ast` prints it and golden tests compare it. The form is
// stable: the same text gives the same lines, without places, so that an added comment changes nothing.
#pragma once

#include "grammar/ast.h"
#include "grammar/source_map.h"
#include "grammar/symbols.h"

#include <string>

namespace isl::grammar {

/// One token a line, `line:column kind text`, as the scanner finds them in a span that was read before. Mistakes were
/// reported at that first reading.
[[nodiscard]] std::string dump_tokens(const SourceMap& map, SourceSpan span, SymbolTable& symbols);

/// One node a line, children indented by two more spaces, the lists of a node under a label if it has several.
[[nodiscard]] std::string dump_tree(Items items, const SymbolTable& symbols);

}  // namespace isl::grammar
