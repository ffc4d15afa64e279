// The questions of a kind whose operands have rules of their own (renderer/scene/operands.h). The interpreter answers
// from what a scene writes. After a mistake, which it tells by itself, every answer is 0 or no, so that a kind need not
// look for mistakes.
#pragma once

#include "renderer/scene/transform.h"

#include <string>
#include <string_view>

namespace isl::scene {

class OperandReader {
 public:
  virtual ~OperandReader() = default;

  /// `what` names the number in messages: "the number of arms".
  [[nodiscard]] virtual double number(std::string_view what) noexcept = 0;
  [[nodiscard]] virtual double number_in(std::string_view what, double low, double high) noexcept = 0;
  /// The same without its fraction.
  [[nodiscard]] int whole_in(std::string_view what, int low, int high) noexcept {
    return static_cast<int>(number_in(what, low, high));
  }
  [[nodiscard]] virtual Vec3 vector(std::string_view what) noexcept = 0;
  /// The name of a file that is to be read.
  [[nodiscard]] virtual std::string file_name(std::string_view what) noexcept = 0;

  /// Takes the next thing if it is this one, and tells whether it is.
  [[nodiscard]] virtual bool accept_word(std::string_view word) noexcept = 0;
  virtual bool accept_comma() noexcept = 0;
  [[nodiscard]] virtual bool is_value_next() noexcept = 0;

  /// Mistakes: that `what` is missing here; and one at what was taken last.
  virtual void expected(std::string_view what) noexcept = 0;
  virtual void fail(std::string message) noexcept = 0;
  virtual void warn(std::string message) noexcept = 0;
};

}  // namespace isl::scene
