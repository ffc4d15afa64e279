// The values were measured on POV-Ray 3.7's pigments without a map (`frequency 1e-9 phase v` shows the map at v).
#include "interpreter/readers/textures/default_maps.h"

#include "base/check.h"

#include <array>
#include <span>

namespace isl::interpreter {
namespace {

using scene::PatternKind;
using scene::PigmentEntry;
using scene::PigmentMap;

constexpr PigmentEntry entry(double value, double red, double green, double blue) {
  return {value, {{red, green, blue}}};
}

constexpr PigmentEntry kGrey[] = {entry(0, 0, 0, 0), entry(1, 1, 1, 1)};
constexpr PigmentEntry kAgate[] = {entry(0, 1, 1, 1),         entry(0.5, 0.95, 0.75, 0.5), entry(0.5, 0.9, 0.7, 0.5),
                                   entry(0.6, 0.9, 0.7, 0.4), entry(0.6, 1, 0.7, 0.4),     entry(1, 0.6, 0.3, 0)};
constexpr PigmentEntry kBozo[] = {entry(0, 1, 1, 1),   entry(0.4, 1, 1, 1), entry(0.4, 0, 1, 0), entry(0.6, 0, 1, 0),
                                  entry(0.6, 0, 0, 1), entry(0.8, 0, 0, 1), entry(0.8, 1, 0, 0), entry(1, 1, 0, 0)};
constexpr PigmentEntry kMandel[] = {entry(0, 0, 0, 0),     entry(0.001, 0, 0, 0), entry(0.001, 0, 1, 1),
                                    entry(0.012, 1, 1, 0), entry(0.015, 1, 0, 1), entry(0.1, 0, 1, 1)};
constexpr PigmentEntry kMarble[] = {entry(0, 0.9, 0.8, 0.8), entry(0.9, 0.9, 0.08, 0.08), entry(0.9, 0, 0, 0),
                                    entry(1, 0, 0, 0)};
constexpr PigmentEntry kRadial[] = {entry(0, 0, 1, 1), entry(0.333, 1, 1, 0), entry(0.666, 1, 0, 1), entry(1, 0, 1, 1)};
constexpr PigmentEntry kWood[] = {entry(0, 0.666, 0.312, 0.2), entry(0.6, 0.666, 0.312, 0.2),
                                  entry(0.6, 0.4, 0.1333, 0.066), entry(1, 0.4, 0.1333, 0.066)};

/// One table for six colours: block patterns take the first ones.
constexpr PigmentEntry kBricks[] = {entry(0, 0.5, 0.5, 0.5), entry(1, 0.6, 0.15, 0.15)};
constexpr PigmentEntry kTiles[] = {entry(0, 0, 0, 1), entry(1, 0, 1, 0), entry(2, 1, 0, 0)};
constexpr PigmentEntry kPolygons[] = {entry(0, 1, 0, 0), entry(1, 0, 1, 0), entry(2, 0, 0, 1),
                                      entry(3, 1, 1, 0), entry(4, 0, 1, 1), entry(5, 1, 0, 1)};

struct MapRow {
  PatternKind kind;
  std::span<const PigmentEntry> entries;
};

constexpr MapRow kMaps[] = {
    {PatternKind::agate, kAgate},
    {PatternKind::bozo, kBozo},
    {PatternKind::brick, kBricks},
    {PatternKind::checker, std::span(kTiles).first(2)},
    {PatternKind::cubic, kPolygons},
    {PatternKind::fractal, kMandel},
    {PatternKind::hexagon, kTiles},
    {PatternKind::marble, kMarble},
    {PatternKind::object, std::span(kTiles).first(2)},
    {PatternKind::radial, kRadial},
    {PatternKind::square, std::span(kPolygons).first(4)},
    {PatternKind::triangular, kPolygons},
    {PatternKind::wood, kWood},
};

std::span<const PigmentEntry> entries_of(PatternKind kind) {
  for (const MapRow& row : kMaps) {
    if (row.kind == kind) return row.entries;
  }
  return kGrey;
}

scene::PigmentMapId shared_map(Context& context, std::span<const PigmentEntry> entries) {
  const auto [place, is_new] = context.default_maps.try_emplace({entries.data(), entries.size()}, scene::kNoPigmentMap);
  if (is_new) {
    auto& maps = context.database.pigment_maps;
    place->second = scene::PigmentMapId{static_cast<std::uint32_t>(maps.size())};
    maps.emplace_back(entries.begin(), entries.end());
  }
  return place->second;
}

}  // namespace

scene::PigmentMapId default_pigment_map(Context& context, const scene::Pattern& pattern) {
  const auto* const fractal = std::get_if<scene::FractalOperands>(&pattern.operands);
  // Among the fractals only the Mandelbrot set is coloured.
  const bool is_grey = fractal && (fractal->is_julia || fractal->magnet != 0);
  return shared_map(context, is_grey ? std::span<const PigmentEntry>(kGrey) : entries_of(pattern.kind));
}

PigmentMap default_pigment_list(PatternKind kind) {
  const std::span<const PigmentEntry> entries = entries_of(kind);
  return {entries.begin(), entries.end()};
}

scene::PigmentMapId default_pigment_list_id(Context& context, PatternKind kind) {
  return shared_map(context, entries_of(kind));
}

}  // namespace isl::interpreter
