#include "renderer/scene/json_function.h"

#include "renderer/scene/json_pattern.h"
#include "renderer/scene/json_texture.h"
#include "renderer/scene/json_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_map>

namespace isl::scene {
namespace {

/// In the order of Opcode.
constexpr std::string_view kOpcodes[] = {
    "copy", "+",     "-",     "*",     "/",       "<",       ">",      "=",      "<=",   ">=",    "!=",   "&",
    "|",    "min",   "max",   "pow",   "mod",     "div",     "atan2",  "negate", "abs",  "floor", "ceil", "int",
    "sqrt", "exp",   "ln",    "log",   "sin",     "cos",     "tan",    "asin",   "acos", "atan",  "sinh", "cosh",
    "tanh", "asinh", "acosh", "atanh", "degrees", "radians", "select", "gray",   "hf",   "call",  "loop", "repeat"};
static_assert(std::size(kOpcodes) == static_cast<std::size_t>(Opcode::repeat) + 1);

constexpr std::string_view kSplineKinds[] = {"linear", "quadratic", "cubic", "natural"};

/// A register `r3`, or a constant `c0`.
std::string operand(std::uint16_t i) {
  return i < Instruction::kConstants ? fmt::format("r{}", i) : fmt::format("c{}", i - Instruction::kConstants);
}

class FunctionWriter {
 public:
  explicit FunctionWriter(const std::vector<FunctionPointer>& functions) : functions_(functions) {
    for (std::size_t i = 0; i < functions.size(); ++i) numbers_.emplace(functions[i].get(), i);
  }

  Json write() {
    Json json = Json::array();
    // Writing a function appends those that it calls to the list.
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      const FunctionPointer function = functions_[i];
      json.push_back(std::visit(*this, function->body));
      if (function->parameter_count != 3) json.back()["parameters"] = function->parameter_count;
    }
    return json;
  }

  Json operator()(const Program& program) {
    Json code = Json::array();
    for (const Instruction& in : program.code) {
      const std::string_view name = name_of(in.operation);
      if (in.operation == Opcode::call) {
        code.push_back(fmt::format("{} {} {}", name, operand(in.a), number_of(program.callees[in.b])));
      } else {
        code.push_back(fmt::format("{} {} {} {}", name, in.to, operand(in.a), operand(in.b)));
      }
    }
    Json json = {{"code", std::move(code)}};
    if (!program.constants.empty()) json["constants"] = program.constants;
    return json;
  }
  Json operator()(const InternalFunction& function) const { return {{"internal", function.number}}; }
  Json operator()(const TransformFunction& function) const { return {{"transform", transform(function.transform)}}; }
  Json operator()(const SplineFunction& function) const {
    Json points = Json::array();
    for (const SplinePoint& point : function.spline->points) points.push_back({point.parameter, point.value});
    return {{"spline", name(kSplineKinds, function.spline->kind)}, {"points", std::move(points)}};
  }
  Json operator()(const PatternFunction& function) const { return pattern_json(function.pattern); }
  Json operator()(const PigmentFunction& function) const {
    return {{"colour_of", pigment_reference(function.pigment)}};
  }

 private:
  static std::string_view name_of(Opcode operation) { return name(kOpcodes, operation); }

  std::size_t number_of(const FunctionPointer& function) {
    const auto [place, is_new] = numbers_.emplace(function.get(), functions_.size());
    if (is_new) functions_.push_back(function);
    return place->second;
  }

  std::vector<FunctionPointer> functions_;
  std::unordered_map<const Function*, std::size_t> numbers_;
};

}  // namespace

nlohmann::ordered_json functions_json(const std::vector<FunctionPointer>& functions) {
  return FunctionWriter(functions).write();
}

}  // namespace isl::scene
