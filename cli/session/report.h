// Reports a scene's problems to the user: as text on standard error, or as the `diagnostics` of a JSON document.
#pragma once

#include "cli/output/output_files.h"
#include "cli/session/session.h"
#include "renderer/scene/refusal.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace isl::cli {

/// Prints every diagnostic of the session so far, in order.
void print_problems(Session& session);

/// The same as an array.
[[nodiscard]] nlohmann::ordered_json problems_as_json(Session& session);

/// Reports a problem that was found after those of the text were printed.
void report_late(Session& session, Diagnostic problem);

/// Prints one document to standard output.
void print_document(const nlohmann::ordered_json& document);

/// `isl: error: …` on standard error, for errors without a place in a scene. Lower case, no full stop.
void print_error(std::string_view message);

/// Ends a command that has done its work: the files of the run take their places. Reports failures.
[[nodiscard]] ExitCode finish(OutputWriter writer);

/// Ends a command whose scene could not be read or evaluated: reports the problems in the requested format.
ExitCode report_failure(Session& session, ExitCode code);

/// Ends a command whose scene takes more than the run allows: reports that at its place. The problems of the text were
/// printed before, or are in the same document.
ExitCode refuse(Session& session, const scene::Refusal& refusal);

}  // namespace isl::cli
