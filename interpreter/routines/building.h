// Builds the operations of a routine from the tree. Statements are in routine_builder.cpp, numbers in
// routine_numbers.cpp.
#pragma once

#include "interpreter/routines/operations.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace isl::interpreter {

/// The place of an operand: the name, register or constant that holds the number.
struct NumberPlace {
  Source source;
  std::uint32_t index;
};

class RoutineBuilder {
 public:
  RoutineBuilder(Context& context, bool is_macro) : context_(context), is_macro_(is_macro) {}

  /// Each is false if the routine cannot have such an item.
  [[nodiscard]] bool add_items(grammar::Items items, bool is_last);
  [[nodiscard]] bool add_loop(const grammar::Node& loop);
  [[nodiscard]] Routine finish();

 private:
  using Index = std::size_t;

  /// The evaluator's way of a statement whose operations lie in [begin, end), or of the one at `end` alone. It goes on
  /// at `end`.
  struct Detour {
    Index begin, end;
    Operation operation;
  };

  /// The operation of the binary operator that was added last.
  struct LastOperator {
    Index at;
    grammar::BinaryOp op;
    Source left, right;
  };

  // ---- Statements ---------------------------------------------------------------------------------------------------

  [[nodiscard]] bool add_declaration(const grammar::Declare& node);
  /// `#declare Name = concat(Name, …)` with a string at hand or a character.
  [[nodiscard]] bool add_append(const grammar::Declare& node, const grammar::Node& only);
  void add_name_declaration(const grammar::Declare& node, const NumberPlace& value, Index begin);
  [[nodiscard]] bool add_element_declaration(const grammar::Declare& node, const NumberPlace& value);
  [[nodiscard]] bool add_branches(Index otherwise_jump, grammar::Items then, grammar::Items otherwise, bool is_last);
  [[nodiscard]] bool add_if(const grammar::If& node, bool is_last);
  [[nodiscard]] bool add_ifdef(const grammar::Ifdef& node, bool is_last);
  [[nodiscard]] bool add_while(const grammar::While& node);
  [[nodiscard]] bool add_for(const grammar::For& node);
  [[nodiscard]] bool add_break();
  void add_yield(const grammar::Node& node);

  // ---- Numbers ------------------------------------------------------------------------------------------------------

  /// Adds the operations for a number and tells where it is; none if the evaluator must do it. New registers begin at
  /// the present number.
  [[nodiscard]] std::optional<NumberPlace> number(const grammar::Node& node);
  [[nodiscard]] std::optional<NumberPlace> number_of_binary(const grammar::Binary& node);
  [[nodiscard]] std::optional<NumberPlace> number_of_conditional(const grammar::Conditional& node);
  [[nodiscard]] std::optional<NumberPlace> number_of_call(const grammar::FunctionCall& node);
  [[nodiscard]] std::optional<NumberPlace> number_of_constant(const grammar::Constant& node);
  /// The same in the register `to`.
  [[nodiscard]] bool number_in(const grammar::Node& node, std::uint32_t to);
  /// The number in the register `to`, by the evaluator if need be.
  void add_number_in(const grammar::Node& node, std::uint32_t to);
  [[nodiscard]] NumberPlace constant(double value);
  /// The name of a one-dimensional array and its subscript, or null.
  [[nodiscard]] static const grammar::Name* name_of_list(const grammar::Node& target);

  // ---- The list -----------------------------------------------------------------------------------------------------

  [[nodiscard]] Index here() const { return routine_.operations.size(); }
  Index add(Perform perform, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t to = 0);
  Index add(Perform perform, const grammar::Node& node, std::uint32_t to = 0);
  void set_other(Index at, Index target);
  /// The operation `at` goes to here.
  void land(Index at) { set_other(at, here()); }
  [[nodiscard]] std::uint32_t symbol(grammar::Symbol name);
  /// The next register, or none if there are no more.
  [[nodiscard]] bool has_register() const { return registers_ < Machine::kRegisters; }
  /// Takes back what was added since `begin`: the evaluator does it.
  void take_back(Index begin) { routine_.operations.resize(begin); }

  Context& context_;
  const bool is_macro_;
  Routine routine_;
  std::vector<Detour> detours_;
  LastOperator last_operator_{};
  std::uint32_t registers_ = 0;             ///< in use
  std::vector<std::vector<Index>> breaks_;  ///< of each loop around: the jumps out of it
  std::vector<Index> returns_;              ///< #break outside loops
};

}  // namespace isl::interpreter
