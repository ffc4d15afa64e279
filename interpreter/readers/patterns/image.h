// Pictures by name: `png "wood.png" gamma 2.2 map_type 1 …`, as in image_map, bump_map, image_pattern and material_map.
// A missing file is an error here already; the renderer decodes its bytes.
#pragma once

#include "interpreter/element_stream.h"

namespace isl::interpreter {

/// The file: its type's word, if any, and its name; or `function w, h { … }`.
[[nodiscard]] scene::Image read_image_source(ElementStream& stream);
/// Reads one modifier of a picture if the next element is one.
[[nodiscard]] bool read_image_item(ElementStream& stream, scene::Image& image);
[[nodiscard]] scene::ImageId add_image(Context& context, scene::Image&& image);

/// The name of a file that may be read: a string in which a backslash is an ordinary character. Reports a missing file,
/// and goes on.
[[nodiscard]] std::string read_file_name(ElementStream& stream, std::string_view what);

}  // namespace isl::interpreter
