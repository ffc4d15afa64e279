// Answers what a kind of pattern asks for (renderer/scene/operand_reader.h) from the elements of a stream. No exception
// passes through the kind: a mistake is kept until the kind is done.
#pragma once

#include "interpreter/element_stream.h"
#include "renderer/scene/operand_reader.h"

#include <exception>

namespace isl::interpreter {

class OperandStream final : public scene::OperandReader {
 public:
  explicit OperandStream(ElementStream& stream) : stream_(stream), taken_(stream.span()) {}

  [[nodiscard]] double number(std::string_view what) noexcept override;
  [[nodiscard]] double number_in(std::string_view what, double low, double high) noexcept override;
  [[nodiscard]] scene::Vec3 vector(std::string_view what) noexcept override;
  [[nodiscard]] std::string file_name(std::string_view what) noexcept override;
  [[nodiscard]] bool accept_word(std::string_view word) noexcept override;
  bool accept_comma() noexcept override;
  [[nodiscard]] bool is_value_next() noexcept override;
  [[nodiscard]] bool is_in_block(std::string_view word) noexcept override;
  void expected(std::string_view what) noexcept override;
  void fail(std::string message) noexcept override;
  void warn(std::string message) noexcept override;

  /// Throws what the first mistake threw, if there was one.
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// The answer of `ask`, which may throw; after a mistake, nothing.
  template <class Ask>
  auto answer(Ask ask) noexcept -> decltype(ask());

  ElementStream& stream_;
  SourceSpan taken_;  ///< the last value or word, at first all that is read
  std::exception_ptr failure_;
};

}  // namespace isl::interpreter
