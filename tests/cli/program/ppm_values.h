// What a binary PPM holds.
#pragma once

#include <string>
#include <vector>

namespace isl::test {

/// Three values a pixel, from 0 to 1, of the file's bytes; 8 or 16 bits each.
[[nodiscard]] std::vector<double> ppm_values(const std::string& file);

}  // namespace isl::test
