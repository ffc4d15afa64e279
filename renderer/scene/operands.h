// The operands of a pattern kind: a record of the kind's own type, and the list of its fields. The database holds the
// record without knowing its type; the interpreter reads it and a dump prints it with the list.
//
//   struct Ring { Vec3 middle{0}; double radius = 1; };
//   constexpr OperandField kRing[] = {modifier<&Ring::middle>("middle"), modifier<&Ring::radius>("radius")};
#pragma once

#include "renderer/scene/transform.h"

#include <any>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace isl::scene {

class OperandReader;

/// A field's value. Fields with a list of numbers are dumped, but not read.
using OperandValue = std::variant<double, int, bool, Vec3, std::string, std::vector<std::variant<double, int>>>;

namespace detail {

template <class>
struct RecordOf;
template <class Record, class Type>
struct RecordOf<Type Record::*> {
  using type = Record;
};
template <class Record>
struct RecordOf<void (*)(OperandReader&, Record&) noexcept> {
  using type = Record;
};

template <class Record>
[[nodiscard]] Record& record_in(std::any& record) noexcept {
  return *std::any_cast<Record>(&record);
}
template <class Record>
[[nodiscard]] const Record& record_in(const std::any& record) noexcept {
  return *std::any_cast<Record>(&record);
}

}  // namespace detail

/// One field of a record.
struct OperandField {
  /// Reads the field and the operands that depend on it.
  using Read = void (*)(OperandReader& reader, std::any& record) noexcept;

  std::string_view key;   ///< in a dump
  std::string_view word;  ///< the word that sets the field; empty if its value follows the kind's own word
  OperandValue (*get)(const std::any& record);
  void (*set)(std::any& record, const OperandValue& value) = nullptr;  ///< null if the field is only dumped
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  Read read = nullptr;                                  ///< null: a value of the field's type
  bool (*is_dumped)(const std::any& record) = nullptr;  ///< null: always

  [[nodiscard]] constexpr OperandField within(double least, double most) const {
    OperandField field = *this;
    field.low = least;
    field.high = most;
    return field;
  }
  [[nodiscard]] constexpr OperandField with_key(std::string_view name) const {
    OperandField field = *this;
    field.key = name;
    return field;
  }
  [[nodiscard]] constexpr OperandField with_word(std::string_view name) const {
    OperandField field = *this;
    field.word = name;
    return field;
  }
  /// `function(OperandReader&, Record&) noexcept` reads the field.
  template <auto function>
  [[nodiscard]] constexpr OperandField read_by() const {
    OperandField field = *this;
    field.read = [](OperandReader& reader, std::any& record) noexcept {
      function(reader, detail::record_in<typename detail::RecordOf<decltype(function)>::type>(record));
    };
    return field;
  }
  /// Dumps the field only if the record's `member` is not 0.
  template <auto member>
  [[nodiscard]] constexpr OperandField dumped_with() const {
    OperandField field = *this;
    field.is_dumped = [](const std::any& record) {
      return detail::record_in<typename detail::RecordOf<decltype(member)>::type>(record).*member != 0;
    };
    return field;
  }
};

/// A field whose value follows the kind's own word.
template <auto member>
[[nodiscard]] constexpr OperandField operand(std::string_view key) {
  using Record = typename detail::RecordOf<decltype(member)>::type;
  using Type = std::remove_cvref_t<decltype(std::declval<Record&>().*member)>;
  return {.key = key,
          .word = {},
          .get = [](const std::any& record) { return OperandValue(detail::record_in<Record>(record).*member); },
          .set = [](std::any& record,
                    const OperandValue& value) { detail::record_in<Record>(record).*member = std::get<Type>(value); }};
}

/// A field with a word of its own, which is its key in a dump too.
template <auto member>
[[nodiscard]] constexpr OperandField modifier(std::string_view word) {
  OperandField field = operand<member>(word);
  field.word = word;
  return field;
}

/// An entry of the dump that is computed from the record: `value(const Record&)`.
template <class Record, auto value>
[[nodiscard]] constexpr OperandField dumped(std::string_view key) {
  return {.key = key, .word = {}, .get = [](const std::any& record) {
            return OperandValue(value(detail::record_in<Record>(record)));
          }};
}

struct Operands {
  std::any record;
  std::span<const OperandField> fields;

  /// Sets the field with that key; `value` has the field's own type.
  void set(std::string_view key, const OperandValue& value) {
    for (const OperandField& field : fields) {
      if (field.key == key) field.set(record, value);
    }
  }
};

}  // namespace isl::scene
