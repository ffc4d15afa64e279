// Diagnostics → text for the user: lines on a terminal, or JSON for editors. The only place that formats them.
#pragma once

#include "base/diagnostic.h"
#include "cli/output/safe_text.h"
#include "grammar/source_map.h"

#include <nlohmann/json_fwd.hpp>

namespace isl::cli {

/// `file:line:column: error: message`, the line with a caret, hint, notes, and the call chain (shortened in the middle
/// if it is long). Control characters of the scene's text are visible.
[[nodiscard]] SafeText format_diagnostic(const Diagnostic& diagnostic, const grammar::SourceMap& sources, bool colour);

/// `{severity, message, hint, place, notes, chain}`; a place is `{file, line, column, end_line, end_column}` or null.
/// Bytes that are not UTF-8 in file names and texts are replaced, so that the result can always be written; all else is
/// exact.
[[nodiscard]] nlohmann::json to_json(const Diagnostic& diagnostic, const grammar::SourceMap& sources);

}  // namespace isl::cli
