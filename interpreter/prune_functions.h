// Functions hold patterns and pigments, which refer to records by number. Functions are immutable and share their
// callees, so renumbering copies those that hold any; all others stay as they are.
#pragma once

#include "renderer/scene/function.h"

#include <functional>
#include <unordered_map>

namespace isl::interpreter {

/// The callbacks for a function's references to the database.
struct FunctionVisitor {
  std::function<void(const scene::Pattern&)> pattern;
  std::function<void(const scene::Pigment&)> pigment;
};

/// Calls the visitor once for each record that the function and its callees hold.
void visit_records(const scene::FunctionPointer& function, const FunctionVisitor& visitor);

/// Copies functions with their records renumbered; shared callees stay shared.
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
