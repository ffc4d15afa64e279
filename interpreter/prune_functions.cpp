#include "interpreter/prune_functions.h"

#include <unordered_set>

namespace isl::interpreter {
namespace {

using scene::Function;
using scene::FunctionPointer;

/// Calls nest at most scene::kMaxValueDepth deep, so recursion is safe. Most functions hold no pattern and call none
/// that does.
void visit(const FunctionPointer& function, const FunctionVisitor& visitor,
           std::unordered_set<const Function*>& visited) {
  if (function->pattern_depth == 0 || !visited.insert(function.get()).second) return;
  if (const auto* const pattern = std::get_if<scene::PatternFunction>(&function->body)) {
    visitor.pattern(pattern->pattern);
  } else if (const auto* const pigment = std::get_if<scene::PigmentFunction>(&function->body)) {
    visitor.pigment(pigment->pigment);
  } else if (const auto* const program = std::get_if<scene::Program>(&function->body)) {
    for (const FunctionPointer& callee : program->callees) visit(callee, visitor, visited);
  }
}

}  // namespace

void visit_records(const FunctionPointer& function, const FunctionVisitor& visitor) {
  std::unordered_set<const Function*> visited;
  visit(function, visitor, visited);
}

FunctionPointer FunctionRenumberer::renumbered(const FunctionPointer& function) {
  if (function->pattern_depth == 0) return function;
  if (const auto known = done_.find(function.get()); known != done_.end()) return known->second;
  auto copy = std::make_shared<Function>(*function);
  if (auto* const pattern = std::get_if<scene::PatternFunction>(&copy->body)) {
    change_pattern_(pattern->pattern);
  } else if (auto* const pigment = std::get_if<scene::PigmentFunction>(&copy->body)) {
    change_pigment_(pigment->pigment);
  } else if (auto* const program = std::get_if<scene::Program>(&copy->body)) {
    for (FunctionPointer& callee : program->callees) callee = renumbered(callee);
  }
  return done_.emplace(function.get(), std::move(copy)).first->second;
}

}  // namespace isl::interpreter
