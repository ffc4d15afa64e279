#include "renderer/effects/pigment_search.h"

#include <unordered_set>
#include <variant>

namespace isl::render {
namespace {

/// Looks at each pigment once.
class PigmentSearch {
 public:
  PigmentSearch(const scene::Database& database, IsSuchPigment is_such) : database_(database), is_such_(is_such) {}

  std::optional<OriginId> find(const scene::Pigment& pigment) {
    if (pigment.is_plain())
      return is_such_(database_, pigment, nullptr) ? std::optional(pigment.said_at) : std::nullopt;
    if (!seen_.insert(index(pigment.pattern)).second) return std::nullopt;
    const scene::PatternedPigment& record = database_.pigments[index(pigment.pattern)];
    if (is_such_(database_, pigment, &record)) return record.pattern.said_at;
    if (const auto* const inner = std::get_if<scene::PigmentOperands>(&record.pattern.operands)) {
      if (const auto found = find({.pattern = inner->pigment})) return found;
    }
    if (record.map == scene::kNoPigmentMap) return std::nullopt;
    for (const scene::PigmentEntry& entry : database_.pigment_maps[index(record.map)]) {
      if (const auto found = find(entry.pigment)) return found;
    }
    return std::nullopt;
  }

 private:
  const scene::Database& database_;
  IsSuchPigment is_such_;
  std::unordered_set<std::uint32_t> seen_;
};

}  // namespace

std::optional<OriginId> find_pigment(const scene::Database& database, const scene::Pigment& pigment,
                                     IsSuchPigment is_such) {
  return PigmentSearch(database, is_such).find(pigment);
}

scene::Colour stand_in(const scene::Database& database, const scene::PatternedPigment& pigment) {
  if (pigment.quick_colour) return *pigment.quick_colour;
  scene::Colour sum;
  int count = 0;
  if (pigment.map != scene::kNoPigmentMap) {
    for (const scene::PigmentEntry& entry : database.pigment_maps[index(pigment.map)]) {
      if (!entry.pigment.is_plain()) continue;
      sum.red += entry.pigment.colour.red;
      sum.green += entry.pigment.colour.green;
      sum.blue += entry.pigment.colour.blue;
      ++count;
    }
  }
  if (count == 0) return {0.5, 0.5, 0.5};
  return {sum.red / count, sum.green / count, sum.blue / count};
}

}  // namespace isl::render
