// Rules between the options of `isl render` about files: --output, --bits, --aov, --format.
#pragma once

#include "cli/options/options.h"

#include <optional>
#include <string>

namespace isl::cli {

struct OutputComplaint {
  std::string message;
  std::string hint;  ///< "": none
};

/// The first contradiction. Checks names only, no files.
[[nodiscard]] std::optional<OutputComplaint> check_output_options(const PictureOptions& picture, OutputFormat format);

}  // namespace isl::cli
