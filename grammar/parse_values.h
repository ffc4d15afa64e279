// The semantic values of the parser's rules while trees grow: nodes with their height, and lists that are not in the
// arena yet. They have their own header because the generated parser's header needs it.
#pragma once

#include "grammar/ast.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isl::grammar {

/// A node with its number of levels down to the furthest leaf, which bounds the stack of a recursive walk.
struct Tree {
  const Node* node = nullptr;
  std::uint32_t height = 0;
};

/// The height of a list is that of its highest tree.
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

/// The parts of a chain `condition ? yes : condition ? yes : …`.
struct Choice {
  std::uint32_t begin;  ///< offset of the condition
  Tree condition, yes;
};
using ChoiceList = std::vector<Choice>;

using SymbolList = std::vector<Symbol>;
using ParameterList = std::vector<Parameter>;

struct TupleFieldTree {
  TupleField field;
  std::uint32_t height = 0;
};
/// If it has a mistake, the node that represents it.
struct TupleFieldList {
  std::vector<TupleField> fields;
  std::uint32_t height = 0;
  Tree mistake;

  void push(TupleFieldTree tree) {
    fields.push_back(tree.field);
    height = std::max(height, tree.height);
  }
};

/// `function (a, b)`; if it has a mistake, the node that represents it.
struct FunctionHead {
  SymbolList parameters;
  Tree mistake;
};

}  // namespace isl::grammar
