#include "cli/session/diagnostic_printer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace isl::cli {
namespace {

using grammar::SourceMap;
using grammar::SourcePosition;

/// Number of frames that are shown of a longer chain: its beginning and its end; those between repeat.
constexpr std::size_t kMaxFrames = 8;
/// Bytes of a line that are shown on either side of the caret.
constexpr std::size_t kLineReach = 100;

std::string_view word_of(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: break;
  }
  return "error";
}

/// The colours that compilers use.
Style colour_of(Severity severity) {
  switch (severity) {
    case Severity::note: return Style::cyan;
    case Severity::warning: return Style::magenta;
    case Severity::error: break;
  }
  return Style::red;
}

class Printer {
 public:
  Printer(const SourceMap& sources, bool colour) : sources_(sources), colour_(colour) {}

  void message(Severity severity, SourceSpan span, std::string_view message);
  void hint(std::string_view hint);
  void chain(const std::vector<ExpansionFrame>& frames);
  [[nodiscard]] SafeText take() { return std::move(text_); }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    text_ += SafeText(fmt::format(format, std::forward<Values>(values)...));
  }
  void add_styled(Style style, std::string_view text) {
    text_ += colour_ ? SafeText::styled(style, text) : SafeText(text);
  }
  [[nodiscard]] std::string place(SourceSpan span) const;
  void excerpt(Severity severity, SourceSpan span);
  void frame(const ExpansionFrame& frame);

  const SourceMap& sources_;
  bool colour_;
  SafeText text_;
};

std::string Printer::place(SourceSpan span) const {
  const SourcePosition position = sources_.position(span.begin);
  return fmt::format("{}:{}:{}", visible_name(position.file), position.line, position.column);
}

void Printer::message(Severity severity, SourceSpan span, std::string_view message) {
  const bool has_place = sources_.position(span.begin).line != 0;
  if (has_place) {
    add_styled(Style::bold, place(span));
    add(": ");
  }
  add_styled(colour_of(severity), fmt::format("{}:", word_of(severity)));
  add(" {}\n", message);
  if (has_place) excerpt(severity, span);
}

/// Prints the line and below it a caret with tildes, both shortened to the neighbourhood. Tabs stay tabs in both, so
/// that they align.
void Printer::excerpt(Severity severity, SourceSpan span) {
  const std::string_view line = sources_.line_text(span.begin);
  const auto caret = std::min<std::size_t>(sources_.text({span.begin, span.begin}).data() - line.data(), line.size());
  const std::size_t end = std::min<std::size_t>(caret + std::max(span.end, span.begin + 1) - span.begin, line.size());
  std::string shown, marks;
  std::size_t marks_end = 0;
  const auto mark = [&](std::string_view what) {
    marks += what;
    marks_end = marks.size();
  };
  for (std::size_t at = 0; at < line.size();) {
    const std::string_view character = line.substr(at, std::max<std::size_t>(character_length(line, at), 1));
    const bool is_near = at + kLineReach >= caret && at <= caret + kLineReach;
    if (is_near) shown += printable(character);
    if (at == caret) {
      mark("^");
    } else if (is_near && at > caret && at < end) {
      mark("~");
    } else if (is_near) {
      marks += character == "\t" ? "\t" : " ";
    }
    at += character.size();
  }
  if (caret == line.size()) mark("^");  // just after the line
  marks.resize(marks_end);
  const std::size_t number = sources_.position(span.begin).line;
  add("{:>6} | {}\n{:>6} | ", number, shown, "");
  add_styled(colour_of(severity), marks);
  add("\n");
}

void Printer::hint(std::string_view hint) {
  if (hint.empty()) return;
  add("{:>6} = ", "");
  add_styled(Style::bold, "hint:");
  add(" {}\n", hint);
}

void Printer::frame(const ExpansionFrame& frame) {
  const std::string_view verb = frame.kind == ExpansionFrame::Kind::macro ? "called" : "included";
  const std::string_view what = frame.kind == ExpansionFrame::Kind::macro ? "macro " : "";
  add("  in {}`{}`, {} at {}\n", what, visible_name(frame.name), verb, place(frame.call));
}

void Printer::chain(const std::vector<ExpansionFrame>& frames) {
  const bool is_long = frames.size() > kMaxFrames;
  const std::size_t first = is_long ? kMaxFrames / 2 : frames.size();
  for (std::size_t i = 0; i < first; ++i) frame(frames[i]);
  if (!is_long) return;
  add("  … {} more …\n", frames.size() - kMaxFrames);
  for (std::size_t i = frames.size() - kMaxFrames / 2; i < frames.size(); ++i) frame(frames[i]);
}

nlohmann::json json_place(SourceSpan span, const SourceMap& sources) {
  const SourcePosition begin = sources.position(span.begin);
  if (begin.line == 0) return nullptr;
  const SourcePosition end = sources.position(span.end);
  return {{"file", valid_utf8(begin.file)},
          {"line", begin.line},
          {"column", begin.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

}  // namespace

SafeText format_diagnostic(const Diagnostic& diagnostic, const SourceMap& sources, bool colour) {
  Printer printer(sources, colour);
  printer.message(diagnostic.severity, diagnostic.span, diagnostic.message);
  printer.hint(diagnostic.hint);
  for (const DiagnosticNote& note : diagnostic.notes) printer.message(Severity::note, note.span, note.message);
  printer.chain(diagnostic.chain);
  return printer.take();
}

nlohmann::json to_json(const Diagnostic& diagnostic, const SourceMap& sources) {
  nlohmann::json notes = nlohmann::json::array();
  for (const DiagnosticNote& note : diagnostic.notes) {
    notes.push_back({{"message", valid_utf8(note.message)}, {"place", json_place(note.span, sources)}});
  }
  nlohmann::json chain = nlohmann::json::array();
  for (const ExpansionFrame& frame : diagnostic.chain) {
    chain.push_back({{"kind", frame.kind == ExpansionFrame::Kind::macro ? "macro" : "include"},
                     {"name", valid_utf8(frame.name)},
                     {"place", json_place(frame.call, sources)}});
  }
  return {{"severity", word_of(diagnostic.severity)},
          {"message", valid_utf8(diagnostic.message)},
          {"hint", valid_utf8(diagnostic.hint)},
          {"place", json_place(diagnostic.span, sources)},
          {"notes", std::move(notes)},
          {"chain", std::move(chain)}};
}

}  // namespace isl::cli
