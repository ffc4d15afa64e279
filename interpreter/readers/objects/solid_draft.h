// The common parts of the readers of solids: the first argument, which may be an object to copy, and the record's way
// into the database.
#pragma once

#include "interpreter/readers/objects/objects.h"

#include <string_view>

namespace isl::interpreter {

/// Puts the solid into the database, counts it, and makes it the draft's shape. `detail_bytes` is the size of its data
/// outside the record.
void add_solid(ElementStream& stream, ObjectDraft& draft, const scene::Solid& solid, std::size_t detail_bytes = 0);

/// Copies an object whose name stands in place of geometry; returns false if the next element is none.
[[nodiscard]] bool read_copy(ElementStream& stream, ObjectDraft& draft);

/// A finite radius; POV-Ray takes a negative one for its absolute value. It may be zero: then there is no surface.
[[nodiscard]] double read_radius(ElementStream& stream, std::string_view what);

/// Reads `open` if it is next.
[[nodiscard]] bool read_open(ElementStream& stream);

/// Puts the outline into the database and makes a solid of this kind, swept between the two heights, the draft's shape.
void add_outline(ElementStream& stream, ObjectDraft& draft, const scene::Solid& solid, scene::Outline outline);

/// Makes an empty union of a solid without a surface, with the warning "<why>; it is left out".
void leave_out(ElementStream& stream, ObjectDraft& draft, std::string_view why);

}  // namespace isl::interpreter
