// The value of an expression: one tagged struct of 48 bytes. Numbers and vectors of two to five terms lie inline, so
// that arithmetic never allocates; all other values point to a Shared (interpreter/shared_values.h).
#pragma once

#include "base/check.h"
#include "interpreter/shared.h"

#include <array>
#include <new>
#include <string_view>

namespace isl::interpreter {

enum class ValueKind : std::uint8_t {
  none,     ///< an array element that was never set
  poison,   ///< from a declaration that failed and was reported; using it fails silently
  numeric,  ///< 1 to 5 terms: number, vectors, colour (5)
  // The kinds from here on point to a Shared.
  string,
  array,
  dictionary,
  macro,
  object,
  pigment,
  normal,
  finish,
  texture,
  material,
  interior,
  colour_map,
  pigment_map,
  normal_map,
  slope_map,
  texture_map,
  statement,  ///< one that an effect declares (renderer/scene/statement.h)
  transform,
  camera,
  spline,
  file,
  // A declaration of a name with one of the kinds from here on needs extra steps (directives.cpp).
  function,
  deprecated,  ///< a name's value is in another slot (interpreter/deprecated_names.h)
};

/// The kind's name in messages: "number", "3-term vector", "string", …
class Value;
[[nodiscard]] std::string_view describe(const Value& value);

class Value {
 public:
  static constexpr int kMaxTerms = 5;
  using Terms = std::array<double, kMaxTerms>;

  Value() {}
  explicit Value(double number) : kind_(ValueKind::numeric), term_count_(1) { terms_[0] = number; }
  /// A vector of `count` of the `terms`; the rest must be zero.
  Value(int count, const Terms& terms)
      : kind_(ValueKind::numeric), term_count_(static_cast<std::uint8_t>(count)), terms_(terms) {}
  Value(ValueKind kind, Ref<Shared> shared) : kind_(kind), shared_(std::move(shared)) {
    ISL_DCHECK(is_shared(), "kind {}", static_cast<int>(kind));
  }
  [[nodiscard]] static Value poison() {
    Value value;
    value.kind_ = ValueKind::poison;
    return value;
  }

  Value(const Value& other) : kind_(other.kind_), term_count_(other.term_count_) { copy_payload(other); }
  Value(Value&& other) noexcept : kind_(other.kind_), term_count_(other.term_count_) { take_payload(other); }
  Value& operator=(const Value& other) {
    if (is_shared() || other.is_shared()) [[unlikely]]
      return *this = Value(other);
    kind_ = other.kind_;
    term_count_ = other.term_count_;
    copy_payload(other);
    return *this;
  }
  Value& operator=(Value&& other) noexcept {
    if (this == &other) return *this;
    if (is_shared()) [[unlikely]]
      shared_.~Ref();
    kind_ = other.kind_;
    term_count_ = other.term_count_;
    take_payload(other);
    return *this;
  }
  ~Value() {
    if (is_shared()) [[unlikely]]
      shared_.~Ref();
  }

  /// Returns to ValueKind::none.
  void reset() {
    if (is_shared()) [[unlikely]]
      shared_.~Ref();
    kind_ = ValueKind::none;
    term_count_ = 0;
  }
  /// Becomes a number, writing as little memory as possible.
  void set_number(double number) {
    if (is_shared()) [[unlikely]]
      shared_.~Ref();
    kind_ = ValueKind::numeric;
    term_count_ = 1;
    terms_[0] = number;
  }

  /// A number becomes another one.
  void change_number(double number) {
    ISL_DCHECK(is_number(), "{} terms", term_count());
    terms_[0] = number;
  }

  [[nodiscard]] ValueKind kind() const { return kind_; }
  [[nodiscard]] bool is_numeric() const { return kind_ == ValueKind::numeric; }
  [[nodiscard]] bool is_number() const { return term_count_ == 1; }
  /// 1 for a number, 2 to 5 for vectors, 0 for non-numeric values.
  [[nodiscard]] int term_count() const { return term_count_; }
  [[nodiscard]] double number() const { return terms_[0]; }
  /// In a vector, terms from term_count() on are zero; a number has only the first.
  [[nodiscard]] const Terms& terms() const { return terms_; }
  /// Term `i`, zero past the last.
  [[nodiscard]] double term(int i) const { return i < term_count_ ? terms_[i] : 0; }

  /// True if no other value points to the shared object; the caller has checked kind().
  [[nodiscard]] bool is_only_owner() const { return shared_.is_only(); }
  /// The shared object; the caller has checked kind().
  template <class T>
  [[nodiscard]] T& as() const {
    ISL_DCHECK(is_shared(), "kind {}", static_cast<int>(kind_));
    return static_cast<T&>(*shared_);
  }

 private:
  [[nodiscard]] bool is_shared() const { return kind_ > ValueKind::numeric; }
  void copy_payload(const Value& other) {
    if (term_count_ == 1) {
      terms_[0] = other.terms_[0];
    } else if (term_count_ != 0) {
      terms_ = other.terms_;
    } else if (is_shared()) {
      new (&shared_) Ref<Shared>(other.shared_);
    }
  }
  void take_payload(Value& other) noexcept {
    if (term_count_ == 1) {
      terms_[0] = other.terms_[0];
    } else if (term_count_ != 0) {
      terms_ = other.terms_;
    } else if (is_shared()) {
      new (&shared_) Ref<Shared>(std::move(other.shared_));
    }
  }

  ValueKind kind_ = ValueKind::none;
  std::uint8_t term_count_ = 0;  ///< 0 for non-numeric values
  union {
    Terms terms_;
    Ref<Shared> shared_;
  };
};
static_assert(sizeof(Value) == 48);

}  // namespace isl::interpreter
