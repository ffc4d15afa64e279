// A file of values, as `#read` takes them one by one: numbers, `<vectors>` and "strings" between commas, with the
// language's own spelling and comments. Text in, values out; it knows no scene.
#pragma once

#include "base/diagnostic.h"
#include "grammar/lexer.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace isl::grammar {

/// One value of a data file.
struct Datum {
  enum class Kind : std::uint8_t {
    end,  ///< no value is left
    number,
    vector,
    string,
    mistake,  ///< `text` says what was expected; nothing more can be read
  };

  Kind kind = Kind::end;
  SourceSpan span;
  int count = 0;                  ///< number of terms; 2 to 5 for a vector
  std::array<double, 5> terms{};  ///< a number is the first term
  std::string text;
};

class DataFile {
 public:
  /// `text` starts at the offset `begin` and outlives this. Bad characters go to `sink`. Throws ScannerFailure.
  DataFile(std::string_view text, std::uint32_t begin, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink)
      : lexer_(text, begin, symbols, arena, sink) {}

  /// Reads the next value, and the comma after it. POV-Ray takes any token for the comma, and so loses a value if one
  /// is missing; here every other token but `;` is a mistake. Throws ScannerFailure.
  [[nodiscard]] Datum next();

  /// True if the text ended at a place for a comma: there is nothing more to read.
  [[nodiscard]] bool is_at_end() const { return at_end_; }

 private:
  Datum value(const Token& first);
  Datum vector(const Token& opening);
  /// Reads a number with its sign; returns false for anything else and sets `token` to the unexpected one.
  bool read_number(Token& token, double& number);

  Lexer lexer_;
  bool at_end_ = false;
};

}  // namespace isl::grammar
