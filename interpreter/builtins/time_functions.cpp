// `datetime(days)` and the constant `now`: times as days since the beginning of the year 2000, in UTC.
#include "interpreter/builtins/builtins.h"
#include "interpreter/expressions.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

constexpr double kSecondsPerDay = 86400;
constexpr double kSecondsTo2000 = 946684800;  ///< seconds from 1970, the epoch of system clocks
constexpr double kMaxDays = 1e7;              ///< a later year does not fit the calendar's four digits

Value date_and_time(const Arguments& a) {
  const double days = a.number(0);
  if (!(std::abs(days) < kMaxDays)) a.fail(0, fmt::format("{:g} days from the year 2000 is not a valid date", days));
  const std::string format = a.size() == 2 ? a.string(1) : "%Y-%m-%d %H:%M:%SZ";
  if (format.empty()) a.fail(1, "the format is empty");
  const auto seconds = static_cast<std::time_t>(std::floor(days * kSecondsPerDay + kSecondsTo2000 + 0.5));
  std::tm calendar{};
  if (gmtime_r(&seconds, &calendar) == nullptr)
    a.fail(0, fmt::format("{:g} days from the year 2000 is not a valid date", days));
  std::array<char, 512> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), format.c_str(), &calendar);
  if (size == 0) a.fail(1, "the format gives an empty text, or one that is too long");
  return make_string(a.context(), std::string(text.data(), size), a.span());
}

constexpr Builtin kTimeFunctions[] = {{word::kw_datetime, 1, 2, nullptr, date_and_time}};

}  // namespace

std::span<const Builtin> time_functions() { return kTimeFunctions; }

double days_since_2000() {
  const std::chrono::duration<double> since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return (since_1970.count() - kSecondsTo2000) / kSecondsPerDay;
}

}  // namespace isl::interpreter
