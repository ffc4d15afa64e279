#include "interpreter/readers/patterns/operand_stream.h"

#include "interpreter/readers/patterns/image.h"
#include "interpreter/readers/words/arguments.h"

namespace isl::interpreter {

template <class Ask>
auto OperandStream::answer(Ask ask) noexcept -> decltype(ask()) {
  using Answer = decltype(ask());
  if (failure_) return Answer();
  try {
    return ask();
  } catch (...) {
    failure_ = std::current_exception();
    return Answer();
  }
}

double OperandStream::number(std::string_view what) noexcept {
  return answer([&] {
    taken_ = stream_.peek().span;
    return read_number(stream_, what);
  });
}

double OperandStream::number_in(std::string_view what, double low, double high) noexcept {
  return answer([&] {
    taken_ = stream_.peek().span;
    return read_number_in(stream_, what, low, high);
  });
}

scene::Vec3 OperandStream::vector(std::string_view what) noexcept {
  return answer([&] {
    taken_ = stream_.peek().span;
    return read_vector(stream_, what);
  });
}

std::string OperandStream::file_name(std::string_view what) noexcept {
  return answer([&] { return read_file(stream_, what).name; });
}

bool OperandStream::accept_word(std::string_view word) noexcept {
  return answer([&] {
    const Element& next = stream_.peek();
    if (!next.is(ElementKind::word) || stream_.context().text(next.word) != word) return false;
    taken_ = next.span;
    stream_.drop();
    return true;
  });
}

bool OperandStream::accept_comma() noexcept {
  return answer([&] { return stream_.accept_comma(); });
}

bool OperandStream::is_value_next() noexcept {
  return answer([&] { return stream_.peek().is(ElementKind::value); });
}

bool OperandStream::is_in_block(std::string_view word) noexcept {
  return stream_.context().text(stream_.word()) == word;
}

void OperandStream::expected(std::string_view what) noexcept {
  answer([&] { fail_expected(stream_, what); });
}

void OperandStream::fail(std::string message) noexcept {
  answer([&] { stream_.context().fail(taken_, std::move(message)); });
}

void OperandStream::warn(std::string message) noexcept {
  answer([&] { stream_.context().warn(taken_, std::move(message)); });
}

}  // namespace isl::interpreter
