// The routines of a scene: those of the loops that it has started and of the macros that it has called.
#pragma once

#include "grammar/ast.h"

#include <memory>
#include <unordered_map>

namespace isl::interpreter {

struct Routine;

/// By the loop's or macro's place in the tree; null for one that cannot be a routine. They stay to the end, because a
/// macro may be declared anew while it runs.
using RoutineTable = std::unordered_map<const grammar::Node*, std::shared_ptr<const Routine>>;

}  // namespace isl::interpreter
