// What the parser's rules hand to one another while trees grow: nodes with their height, and lists that are not in the
// arena yet. A header of its own because the generated parser's header needs it.
#pragma once

#include "grammar/ast.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isl::grammar {

/// A node with the number of levels from it to its furthest leaf, which is what a recursive walk will need of stack.
struct Tree {
  const Node* node = nullptr;
  std::uint32_t height = 0;
};

/// Height counts as that of the highest tree in the list.
struct TreeList {
  std::vector<const Node*> nodes;
  std::uint32_t height = 0;

  void push(Tree tree) {
    nodes.push_back(tree.node);
    height = std::max(height, tree.height);
  }
};

struct ArgumentList {
  std::vector<Argument> arguments;
  std::uint32_t height = 0;
};

struct CaseList {
  std::vector<SwitchCase> cases;
  std::uint32_t height = 0;
};

using SymbolList = std::vector<Symbol>;

/// `function (a, b)`; with a mistake in it, what stands for that.
struct FunctionHead {
  SymbolList parameters;
  Tree mistake;
};

}  // namespace isl::grammar
