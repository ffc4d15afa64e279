// What each command does. Errors have been told to the user when one returns.
#pragma once

#include "cli/options/options.h"
#include "cli/output/exit_code.h"

namespace isl::cli {

/// Reads, evaluates, traces, writes the image files.
[[nodiscard]] ExitCode run(const RenderCommand& command);

/// Reads and evaluates; tells the problems, also those of rendering; what the scene holds, its bounding box and a camera that sees it.
[[nodiscard]] ExitCode run(const CheckCommand& command);

/// Prints the effects that the scene calls for, and which statements do.
[[nodiscard]] ExitCode run(const PlanCommand& command);

/// Measures what the scene's camera rays cost and how far off they are with one setting after the other.
[[nodiscard]] ExitCode run(const AccuracyCommand& command);

/// Prints one stage of the way from text to picture.
[[nodiscard]] ExitCode run(const DumpCommand& command);

}  // namespace isl::cli
