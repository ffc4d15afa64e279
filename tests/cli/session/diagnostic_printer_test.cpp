#include "cli/session/diagnostic_printer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace isl::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class DiagnosticPrinterTest : public testing::Test {
 protected:
  /// The span of the first occurrence of `what` in a file `a.isl` of this text.
  SourceSpan find(const std::string& text, std::string_view what) {
    const SourceSpan file = sources_.add("a.isl", text).value();
    const auto at = file.begin + static_cast<std::uint32_t>(text.find(what));
    return {at, at + static_cast<std::uint32_t>(what.size())};
  }
  [[nodiscard]] std::string formatted(const Diagnostic& diagnostic, bool colour = false) const {
    return format_diagnostic(diagnostic, sources_, colour).text();
  }

  grammar::SourceMap sources_;
};

Diagnostic error_at(SourceSpan span, std::string message) {
  return {Severity::error, span, std::move(message), {}, {}, {}};
}

ExpansionFrame call_of(std::string name, SourceSpan call) {
  return {ExpansionFrame::Kind::macro, std::move(name), call};
}

TEST_F(DiagnosticPrinterTest, ShowsPlaceLineAndCaret) {
  const SourceSpan span = find("sphere {\n  Redd\n}", "Redd");
  EXPECT_EQ(formatted(error_at(span, "unknown identifier `Redd`")),
            "a.isl:2:3: error: unknown identifier `Redd`\n"
            "     2 |   Redd\n"
            "       |   ^~~~\n");
}

TEST_F(DiagnosticPrinterTest, AddsHintNotesAndChain) {
  const SourceSpan span = find("A B", "B");
  Diagnostic diagnostic = error_at(span, "wrong");
  diagnostic.hint = "do better";
  diagnostic.notes.push_back({{span.begin - 2, span.begin - 1}, "because of this"});
  diagnostic.chain.push_back(call_of("Tree", span));
  diagnostic.chain.push_back({ExpansionFrame::Kind::include, "b.inc", span});
  EXPECT_EQ(formatted(diagnostic),
            "a.isl:1:3: error: wrong\n"
            "     1 | A B\n"
            "       |   ^\n"
            "       = hint: do better\n"
            "a.isl:1:1: note: because of this\n"
            "     1 | A B\n"
            "       | ^\n"
            "  in macro `Tree`, called at a.isl:1:3\n"
            "  in `b.inc`, included at a.isl:1:3\n");
}

TEST_F(DiagnosticPrinterTest, ShortensALongChainInTheMiddle) {
  const SourceSpan span = find("A", "A");
  Diagnostic diagnostic = error_at(span, "too deep");
  for (int i = 0; i < 1000; ++i) diagnostic.chain.push_back(call_of(fmt::format("F{}", i), span));
  const std::string text = formatted(diagnostic);
  EXPECT_THAT(text, HasSubstr("`F3`"));
  EXPECT_THAT(text, HasSubstr("… 992 more …"));
  EXPECT_THAT(text, HasSubstr("`F999`"));
  EXPECT_THAT(text, Not(HasSubstr("`F500`")));
}

TEST_F(DiagnosticPrinterTest, AlignsTheCaretBehindTabsAndForeignLetters) {
  EXPECT_THAT(formatted(error_at(find("\tä\tX", "X"), "wrong")), HasSubstr("| \tä\tX\n       | \t \t^\n"));
}

TEST_F(DiagnosticPrinterTest, MarksAPlaceBehindTheLine) {
  const SourceSpan file = sources_.add("a.isl", "A\n").value();
  EXPECT_THAT(formatted(error_at({file.begin + 1, file.begin + 1}, "wrong")), HasSubstr("| A\n       |  ^\n"));
}

TEST_F(DiagnosticPrinterTest, MarksOnlyTheFirstLineOfALongSpan) {
  EXPECT_THAT(formatted(error_at(find("A {\nB }", "{\nB }"), "wrong")), HasSubstr("| A {\n       |   ^\n"));
}

TEST_F(DiagnosticPrinterTest, CutsALineOfAMillionCharacters) {
  const std::string text =
      formatted(error_at(find(std::string(500'000, 'a') + "X" + std::string(500'000, 'b'), "X"), "wrong"));
  EXPECT_LT(text.size(), 1000u);
  EXPECT_THAT(text, HasSubstr("aXb"));
}

TEST_F(DiagnosticPrinterTest, KeepsControlCharactersFromTheTerminal) {
  const std::string text = formatted(error_at(find("\033[2J X", "X"), "wrong \033[31m"));
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, HasSubstr("wrong \\x1b[31m"));
  EXPECT_THAT(text, HasSubstr("| \xEF\xBF\xBD[2J X\n       |      ^\n")) << "the line keeps its width";
}

TEST_F(DiagnosticPrinterTest, KeepsControlsThatTurnTextAroundFromTheTerminal) {
  Diagnostic diagnostic = error_at(find("\xE2\x80\xAE X", "X"), "wrong \xE2\x80\xAE");
  diagnostic.hint = "\xE2\x81\xA6";
  diagnostic.chain.push_back(call_of("F\xC2\x9B\n", diagnostic.span));
  const std::string text = formatted(diagnostic, true);
  EXPECT_THAT(text, Not(HasSubstr("\xE2\x80\xAE")));
  EXPECT_THAT(text, HasSubstr("wrong \\u202e"));
  EXPECT_THAT(text, HasSubstr("\\u2066"));
  EXPECT_THAT(text, HasSubstr("macro `F\\x9b\\x0a`"));
  EXPECT_EQ(to_json(diagnostic, sources_)["message"], "wrong \xE2\x80\xAE") << "JSON is exact";
}

TEST_F(DiagnosticPrinterTest, ColoursOnlyWhenAsked) {
  const SourceSpan span = find("A", "A");
  EXPECT_THAT(formatted(error_at(span, "wrong"), true), HasSubstr("\033[1;31merror:"));
  EXPECT_THAT(formatted(error_at(span, "wrong"), false), Not(HasSubstr("\033")));
}

TEST_F(DiagnosticPrinterTest, NeedsNoPlace) { EXPECT_EQ(formatted(error_at({}, "wrong")), "error: wrong\n"); }

TEST_F(DiagnosticPrinterTest, WritesJsonWithPlaces) {
  const SourceSpan span = find("A\nBC", "BC");
  Diagnostic diagnostic = error_at(span, "wrong");
  diagnostic.chain.push_back(call_of("F", {}));
  const nlohmann::json json = to_json(diagnostic, sources_);
  EXPECT_EQ(json["severity"], "error");
  EXPECT_EQ(json["place"],
            (nlohmann::json{{"file", "a.isl"}, {"line", 2}, {"column", 1}, {"end_line", 2}, {"end_column", 3}}));
  EXPECT_EQ(json["chain"][0]["kind"], "macro");
  EXPECT_TRUE(json["chain"][0]["place"].is_null());
}

TEST_F(DiagnosticPrinterTest, WritesJsonOfAnyBytes) {
  const nlohmann::json json = to_json(error_at({}, "\xFF\xC0\xAF\xED\xA0\x80"), sources_);
  EXPECT_NO_THROW(static_cast<void>(json.dump()));
}

}  // namespace
}  // namespace isl::cli
