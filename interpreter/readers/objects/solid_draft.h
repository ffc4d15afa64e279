// What the readers of solids share: the first argument, which may be an object to copy, and the record's way into the
// database.
#pragma once

#include "interpreter/readers/objects/objects.h"

#include <string_view>

namespace isl::interpreter {

/// Puts the solid into the database, counts it, and makes it the draft's shape. `detail_bytes` is what it takes
/// besides.
void add_solid(ElementStream& stream, ObjectDraft& draft, const scene::Solid& solid, std::size_t detail_bytes = 0);

/// Copies the object that stands where geometry could begin; false where the next element is none.
[[nodiscard]] bool read_copy(ElementStream& stream, ObjectDraft& draft);

/// A radius, finite; POV-Ray takes a negative one for its absolute value. It may be zero: then there is no surface.
[[nodiscard]] double read_radius(ElementStream& stream, std::string_view what);

/// An empty union in place of what has no surface, with the warning "<why>; it is left out".
void leave_out(ElementStream& stream, ObjectDraft& draft, std::string_view why);

}  // namespace isl::interpreter
