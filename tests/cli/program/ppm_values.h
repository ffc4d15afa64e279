// Reads the values of a binary PPM.
#pragma once

#include <string>
#include <vector>

namespace isl::test {

/// The three values of each pixel, from 0 to 1, of a file given by its bytes; 8 or 16 bits each.
[[nodiscard]] std::vector<double> ppm_values(const std::string& file);

}  // namespace isl::test
