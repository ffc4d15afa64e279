// The commands. When one returns, it has reported its errors to the user.
#pragma once

#include "cli/options/options.h"
#include "cli/output/exit_code.h"

namespace isl::cli {

/// Reads, evaluates, traces, writes the image files.
[[nodiscard]] ExitCode run(const RenderCommand& command);

/// Reads and evaluates; reports the problems, also those of rendering, the contents of the scene, its bounding box and
/// a camera that sees it.
[[nodiscard]] ExitCode run(const CheckCommand& command);

/// Prints the effects that the scene calls for, and the statements that call for them.
[[nodiscard]] ExitCode run(const PlanCommand& command);

/// Measures, with one setting after the other, the cost and the errors of the scene's camera rays.
[[nodiscard]] ExitCode run(const AccuracyCommand& command);

/// Prints what the standard library has, or explains one name of it.
[[nodiscard]] ExitCode run(const LibraryCommand& command);

/// Prints one stage of the way from text to picture.
[[nodiscard]] ExitCode run(const DumpCommand& command);

}  // namespace isl::cli
