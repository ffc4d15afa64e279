#include "tests/cli/program/ppm_values.h"

#include <cctype>
#include <cstdlib>

namespace isl::test {

std::vector<double> ppm_values(const std::string& file) {
  std::size_t at = 2;  // after "P6"
  int header[3] = {0, 0, 0};
  for (int& number : header) {
    while (at < file.size() && std::isspace(static_cast<unsigned char>(file[at])) != 0) ++at;
    while (at < file.size() && file[at] == '#') at = file.find('\n', at) + 1;
    number = std::atoi(file.c_str() + at);
    while (at < file.size() && std::isdigit(static_cast<unsigned char>(file[at])) != 0) ++at;
  }
  ++at;
  const std::size_t bytes = header[2] > 255 ? 2 : 1;
  std::vector<double> result;
  for (; at + bytes <= file.size(); at += bytes) {
    double value = static_cast<unsigned char>(file[at]);
    if (bytes == 2) value = value * 256 + static_cast<unsigned char>(file[at + 1]);
    result.push_back(value / header[2]);
  }
  return result;
}

}  // namespace isl::test
