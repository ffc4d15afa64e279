// The directives for files of a scene's own: #fopen, #fclose, #read, #write. Which files may be opened is
// grammar/file_access.h's; how written values look is file_output.h's.
#pragma once

#include "interpreter/context.h"

namespace isl::interpreter {

void open_file(Context& context, const grammar::Fopen& node);
/// Of what is not open there is nothing to close: POV-Ray's scenes close files that reading to their end has closed.
void close_file(Context& context, const grammar::Fclose& node);
void read_file(Context& context, const grammar::Read& node);
void write_file(Context& context, const grammar::Write& node);

/// At the scene's end: writes what is still open.
void close_all_files(Context& context);

/// `file_exists(name)`: whether the scene could read it.
[[nodiscard]] bool file_exists(const Context& context, const std::string& name);

}  // namespace isl::interpreter
