// Pictures by name: `png "wood.png" gamma 2.2 map_type 1 …`, as in image_map, bump_map, image_pattern and material_map.
// A missing file is an error here already; the renderer decodes its bytes.
#pragma once

#include "interpreter/element_stream.h"

#include <span>

namespace isl::interpreter {

/// The file: its type's word, if any, and its name; or `function w, h { … }`.
[[nodiscard]] scene::Image read_image_source(ElementStream& stream);
/// Reads one modifier of a picture if the next element is one.
[[nodiscard]] bool read_image_item(ElementStream& stream, scene::Image& image);
[[nodiscard]] scene::ImageId add_image(Context& context, scene::Image&& image);

/// A file that may be read. `bytes` is null if it is missing, which is reported.
struct NamedFile {
  std::string name;  ///< as written
  OriginId said_at;  ///< place of the name
  std::shared_ptr<const std::string> bytes;
};
/// The name of a file is a string in which a backslash is an ordinary character. A name without an extension that no
/// file has is tried with these.
[[nodiscard]] NamedFile read_file(ElementStream& stream, std::string_view what,
                                  std::span<const std::string_view> extensions = {});

}  // namespace isl::interpreter
