// Functions hold patterns and pigments, which refer to records by number. Functions are immutable and share their
// callees, so renumbering makes new ones of those that hold any; all others stay as they are.
#pragma once

#include "renderer/scene/function.h"

#include <functional>
#include <unordered_map>

namespace isl::interpreter {

/// What a function refers to in the database.
struct FunctionVisitor {
  std::function<void(const scene::Pattern&)> pattern;
  std::function<void(const scene::Pigment&)> pigment;
};

/// Calls the visitor for what the function and all it calls hold, each once.
void visit_records(const scene::FunctionPointer& function, const FunctionVisitor& visitor);

/// Copies functions with their records changed; what was shared stays shared.
class FunctionRenumberer {
 public:
  FunctionRenumberer(std::function<void(scene::Pattern&)> change_pattern,
                     std::function<void(scene::Pigment&)> change_pigment)
      : change_pattern_(std::move(change_pattern)), change_pigment_(std::move(change_pigment)) {}

  [[nodiscard]] scene::FunctionPointer renumbered(const scene::FunctionPointer& function);

 private:
  std::function<void(scene::Pattern&)> change_pattern_;
  std::function<void(scene::Pigment&)> change_pigment_;
  std::unordered_map<const scene::Function*, scene::FunctionPointer> done_;
};

}  // namespace isl::interpreter
