// The fonts of a scene: each is found and opened once.
#pragma once

#include "base/source_span.h"
#include "grammar/file_access.h"
#include "interpreter/fonts/font.h"
#include "interpreter/fonts/system_fonts.h"

#include <map>
#include <memory>
#include <string>

namespace isl::interpreter {

class Context;

class FontShelf {
 public:
  /// The font of a file that the scene names, found where its other files are, or among the system's fonts. If there is
  /// none, another font takes its place, with a warning. `where` is the name's place.
  const Font& find(Context& context, const std::string& name, SourceSpan where);

 private:
  std::unique_ptr<Font> open_file(Context& context, const std::string& name, SourceSpan where,
                                  grammar::AccessProblem& problem);
  std::unique_ptr<Font> open_installed(Context& context, const std::filesystem::path& file, SourceSpan where);

  SystemFonts system_;
  std::map<std::pair<std::filesystem::path, std::string>, std::unique_ptr<Font>> fonts_;  ///< by folder of use and name
};

}  // namespace isl::interpreter
