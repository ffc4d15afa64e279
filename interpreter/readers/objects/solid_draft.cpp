#include "interpreter/readers/objects/solid_draft.h"

#include "interpreter/expressions.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/records.h"

#include <fmt/format.h>

#include <cmath>

namespace isl::interpreter {

void add_solid(ElementStream& stream, ObjectDraft& draft, const scene::Solid& solid, std::size_t detail_bytes) {
  Context& context = stream.context();
  constexpr std::size_t kRecords = kHeldWhileMoving * (sizeof(scene::Solid) + sizeof(scene::Object));
  context.count_primitive(stream.span(), kRecords + kOriginBytes + detail_bytes);
  draft.object.kind = scene::Object::Kind::solid;
  draft.object.shape = static_cast<std::uint32_t>(context.database.solids.size());
  context.database.solids.push_back(solid);
}

bool read_copy(ElementStream& stream, ObjectDraft& draft) {
  const Element next = stream.peek();
  // Only a name can refer to an object; any other value is geometry.
  const bool may_name = next.is(ElementKind::value) && grammar::is_place(*next.node);
  if (!may_name) return false;
  const Slot* const slot = find_slot_if_declared(stream.context(), *next.node);
  if (!slot || slot->value.kind() != ValueKind::object) return false;
  const Value value = stream.take_value();
  copy_object(stream, value.as<ObjectValue>(), draft);
  return true;
}

double read_radius(ElementStream& stream, std::string_view what) {
  const SourceSpan span = stream.peek().span;
  const double radius = std::abs(read_number(stream, what));
  if (!std::isfinite(radius))
    stream.context().fail_not_finite(span, fmt::format("{} must be finite, found {:g}", what, radius));
  return radius;
}

bool read_open(ElementStream& stream) {
  if (!stream.peek().is_word(grammar::word::kw_open)) return false;
  stream.drop();
  return true;
}

void add_outline(ElementStream& stream, ObjectDraft& draft, const scene::Solid& solid, scene::Outline outline) {
  scene::Database& database = stream.context().database;
  const std::size_t bytes = sizeof(scene::Outline) + outline.points.size() * sizeof(scene::PlanePoint) +
                            outline.orders.size() + outline.contours.size() * sizeof(std::uint32_t);
  scene::Solid placed = solid;
  placed.detail = static_cast<std::uint32_t>(database.outlines.size());
  database.outlines.push_back(std::move(outline));
  add_solid(stream, draft, placed, bytes);
}

void leave_out(ElementStream& stream, ObjectDraft& draft, std::string_view why) {
  stream.context().warn(stream.span(), fmt::format("{}; it is left out", why));
  set_group(stream, draft, {});
}

}  // namespace isl::interpreter
