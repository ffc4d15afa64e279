#include "renderer/scene/json_statement.h"

#include "renderer/scene/json_pattern.h"
#include "renderer/scene/json_texture.h"
#include "renderer/scene/json_values.h"

#include <type_traits>

namespace isl::scene {
namespace {

/// The field's value, as its type is dumped.
struct FieldWriter {
  Json operator()(const double* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const Vec3* value) const { return vector(*value); }
  Json operator()(const Colour* value) const { return colour(*value); }
  Json operator()(const Turbulence* value) const { return turbulence_json(*value); }
  Json operator()(const TransformId* value) const { return index(*value); }
  Json operator()(const PigmentMapId* value) const { return index(*value); }
  Json operator()(const std::vector<Pigment>* value) const {
    Json json = Json::array();
    for (const Pigment& pigment : *value) json.push_back(pigment_reference(pigment));
    return json;
  }
};

}  // namespace

Json statement_json(const Statement& statement) {
  Json json = Json::object();
  std::any record = statement.record, otherwise = statement.kind->make();
  for (const StatementField& field : statement.kind->fields) {
    const FieldPlace place = field.place(record);
    const Json value = std::visit(FieldWriter(), place);
    if (value == std::visit(FieldWriter(), field.place(otherwise))) continue;
    if (std::holds_alternative<Turbulence*>(place)) {
      json.update(value);
    } else {
      json[std::string(field.key)] = value;
    }
  }
  return json;
}

}  // namespace isl::scene
