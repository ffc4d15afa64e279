// seed() and rand(), with POV-Ray's exact sequence: a linear congruential generator modulo 2³².
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::interpreter {

class RandomStreams {
 public:
  /// A new stream that starts from `seed`; returns its number, which the scene passes to next().
  [[nodiscard]] double open(std::int32_t seed) {
    states_.push_back(static_cast<std::uint32_t>(seed));
    return static_cast<double>(states_.size() - 1);
  }

  /// The next number in [0, 1]; nothing if there is no such stream.
  [[nodiscard]] std::optional<double> next(double stream) {
    if (!(stream >= 0 && stream < static_cast<double>(states_.size()))) return std::nullopt;
    std::uint32_t& state = states_[static_cast<std::size_t>(stream)];
    state = state * 1812433253u + 12345u;
    return state / 4294967295.0;
  }

  [[nodiscard]] std::size_t count() const { return states_.size(); }

 private:
  std::vector<std::uint32_t> states_;
};

}  // namespace isl::interpreter
