// Problems of a scene, told to the user: as text on standard error, or as the `diagnostics` of a JSON document.
#pragma once

#include "cli/session/session.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <string_view>

namespace isl::cli {

/// Whether to write colours there: a terminal, and NO_COLOR is not set.
[[nodiscard]] bool wants_colour(std::FILE* stream);

/// Every diagnostic of the session so far, in order.
void print_problems(Session& session);

/// The same as an array.
[[nodiscard]] nlohmann::ordered_json problems_as_json(Session& session);

/// Prints one document to standard output.
void print_document(const nlohmann::ordered_json& document);

/// `isl: error: …` on standard error: for what is about no place in a scene. Lower case, no full stop.
void print_error(std::string_view message);

/// The end of a command whose scene could not be read or evaluated: tells the problems in the format asked for.
ExitCode report_failure(Session& session, ExitCode code);

}  // namespace isl::cli
