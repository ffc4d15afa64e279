// Statements of the world that one effect alone knows, such as those of the air. The effect's file declares the record
// of such a statement and the list of its fields; from these follow how the interpreter reads it, how a dump prints it,
// and which other records it refers to. The database holds the record without knowing its type.
//
//   struct Mist { Colour colour; double distance = 0; };
//   constexpr StatementField kMistFields[] = {field<&Mist::colour>("").with_key("colour"),
//                                             field<&Mist::distance>("distance")};
#pragma once

#include "base/source_span.h"
#include "renderer/scene/colour.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/operands.h"
#include "renderer/scene/pigment.h"
#include "renderer/scene/transform.h"
#include "renderer/scene/warp.h"

#include <any>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace isl::scene {

/// A field in its record. The type says what is read:
///   - double, int, Vec3, Colour: such a value after the field's word;
///   - Turbulence: the words of turbulence;
///   - TransformId: transforms, one after the other;
///   - PigmentMapId: a `color_map`;
///   - vector<Pigment>: one more `pigment` block each time.
using FieldPlace =
    std::variant<double*, int*, Vec3*, Colour*, Turbulence*, TransformId*, PigmentMapId*, std::vector<Pigment>*>;

/// How reading a field differs from that of its type.
enum class FieldRule : std::uint8_t {
  none,
  degrees,  ///< the scene gives degrees, the record holds radians
  turned,   ///< a direction of unit length, which the statement's transforms turn
  bare,     ///< the value may stand without its word; without a word at all, any colour
};

struct StatementField {
  std::string_view word;  ///< empty if the type has words of its own
  std::string_view key;   ///< in a dump
  FieldPlace (*place)(std::any& record);
  FieldRule rule = FieldRule::none;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

  [[nodiscard]] constexpr StatementField with_key(std::string_view name) const {
    StatementField changed = *this;
    changed.key = name;
    return changed;
  }
  [[nodiscard]] constexpr StatementField with(FieldRule given) const {
    StatementField changed = *this;
    changed.rule = given;
    return changed;
  }
  [[nodiscard]] constexpr StatementField within(double least, double most) const {
    StatementField changed = *this;
    changed.low = least;
    changed.high = most;
    return changed;
  }
};

template <auto member>
[[nodiscard]] constexpr StatementField field(std::string_view word) {
  return {.word = word, .key = word, .place = [](std::any& record) -> FieldPlace {
            return &(detail::record_in<typename detail::RecordOf<decltype(member)>::type>(record).*member);
          }};
}

struct StatementKind {
  std::string_view word;       ///< the word that begins it
  std::string_view noun;       ///< in messages: "a mist"
  bool is_setting = false;     ///< it stands in `global_settings`; its word may be one of ours, not reserved
  std::string_view list = {};  ///< in a dump; empty: a later statement replaces an earlier one
  std::any (*make)();          ///< a record with the defaults
  std::span<const StatementField> fields;
  /// Called after all is read: completes the record. Returns what is wrong with it, or nothing.
  std::string (*check)(std::any& record) = nullptr;
};

struct Statement {
  const StatementKind* kind = nullptr;
  std::any record;
  OriginId origin{};

  template <class Record>
  [[nodiscard]] const Record& as() const noexcept {
    return detail::record_in<Record>(record);
  }
};

/// For StatementKind::make.
template <class Record>
[[nodiscard]] std::any make_record() {
  return Record{};
}

/// For StatementKind::check: `function(Record&)` returns the message.
template <class Record, auto function>
[[nodiscard]] std::string check_record(std::any& record) {
  return function(detail::record_in<Record>(record));
}

}  // namespace isl::scene
