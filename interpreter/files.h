// The directives for files of a scene's own: #fopen, #fclose, #read, #write. grammar/file_access.h decides which files
// may be opened; file_output.h formats the written values.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

void open_file(Context& context, const grammar::Fopen& node);
/// Closing a closed file does nothing: POV-Ray's scenes close files that reading to their end has closed.
void close_file(Context& context, const grammar::Fclose& node);
void read_file(Context& context, const grammar::Read& node);
void write_file(Context& context, const grammar::Write& node);

/// Called at the scene's end: closes the files that are still open.
void close_all_files(Context& context);

/// Called when the scene has been read without errors: makes files of all that it wrote, which take their places with
/// the run's other outputs.
void stage_written_files(Context& context);

/// `file_exists(name)`: true if the scene could read it.
[[nodiscard]] bool file_exists(const Context& context, const std::string& name);

}  // namespace isl::interpreter
