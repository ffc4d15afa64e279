// The interface through which a pattern kind reads operands that need rules of their own (renderer/scene/operands.h).
// The interpreter implements it with the items of a scene. After a mistake, which it reports itself, every function
// returns 0 or false, so that a kind need not check for mistakes.
#pragma once

#include "renderer/scene/transform.h"

#include <string>
#include <string_view>

namespace isl::scene {

class OperandReader {
 public:
  virtual ~OperandReader() = default;

  /// Reads a number. `what` names it in messages: "the number of arms".
  [[nodiscard]] virtual double number(std::string_view what) noexcept = 0;
  [[nodiscard]] virtual double number_in(std::string_view what, double low, double high) noexcept = 0;
  /// As number_in(), truncated to an integer.
  [[nodiscard]] int whole_in(std::string_view what, int low, int high) noexcept {
    return static_cast<int>(number_in(what, low, high));
  }
  [[nodiscard]] virtual Vec3 vector(std::string_view what) noexcept = 0;
  /// Reads the name of a file.
  [[nodiscard]] virtual std::string file_name(std::string_view what) noexcept = 0;

  /// Consumes the next element and returns true if it is this word (or a comma).
  [[nodiscard]] virtual bool accept_word(std::string_view word) noexcept = 0;
  virtual bool accept_comma() noexcept = 0;
  [[nodiscard]] virtual bool is_value_next() noexcept = 0;
  /// True if the operands are in a block that this word begins, and not beside the items of the pattern's host.
  [[nodiscard]] virtual bool is_in_block(std::string_view word) noexcept = 0;

  /// expected() reports that `what` is missing at the next element; fail() and warn() report at the last consumed one.
  virtual void expected(std::string_view what) noexcept = 0;
  virtual void fail(std::string message) noexcept = 0;
  virtual void warn(std::string message) noexcept = 0;
};

}  // namespace isl::scene
