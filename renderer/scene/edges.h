// The references between the database's records, listed once per kind of record. The pruner follows and renumbers them,
// and every search of what a scene holds uses them. A new member that refers to a record is one line here.
//
// for_each_edge(record, visit) calls visit(id) for every reference that the record holds itself, in the order of its
// members, whether or not it refers to anything. Ids are lvalues: in a record that is not const they may be changed.
// Functions are shared objects that hold patterns and pigments of their own; interpreter/prune_functions.h walks them.
#pragma once

#include "renderer/scene/database.h"

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

namespace isl::scene {

template <class Given, class Record>
concept Either = std::same_as<std::remove_const_t<Given>, Record>;

namespace detail {

/// Visits an index as the id that it stands for.
template <class Id, class Index, class Visit>
void visit_as(Index& number, Visit& visit) {
  Id id{number};
  visit(id);
  if constexpr (!std::is_const_v<Index>) number = index(id);
}

}  // namespace detail

// ---- Textures -------------------------------------------------------------------------------------------------------

template <Either<Pigment> Record, class Visit>
void for_each_edge(Record& pigment, Visit&& visit) {
  visit(pigment.pattern);
}

template <Either<Pattern> Record, class Visit>
void for_each_edge(Record& pattern, Visit&& visit) {
  for (auto& warp : pattern.warps) {
    if (auto* const transform = std::get_if<TransformId>(&warp)) visit(*transform);
  }
  auto& operands = pattern.operands;
  if (auto* const image = std::get_if<ImageId>(&operands)) visit(*image);
  if (auto* const function = std::get_if<FunctionOperands>(&operands)) visit(function->function);
  if (auto* const pigment = std::get_if<PigmentOperands>(&operands)) visit(pigment->pigment);
  if (auto* const colour = std::get_if<ColourOperands>(&operands)) {
    for (auto& term : colour->terms) visit(term);
  }
  if (auto* const object = std::get_if<ObjectOperands>(&operands))
    detail::visit_as<PatternObjectId>(object->object, visit);
}

template <Either<Texture> Record, class Visit>
void for_each_edge(Record& texture, Visit&& visit) {
  for_each_edge(texture.pigment, visit);
  visit(texture.normal);
  visit(texture.finish);
  visit(texture.pattern);
  visit(texture.below);
}

template <Either<TexturePattern> Record, class Visit>
void for_each_edge(Record& choice, Visit&& visit) {
  for_each_edge(choice.pattern, visit);
  visit(choice.map);
}

template <Either<TextureMap> Record, class Visit>
void for_each_edge(Record& map, Visit&& visit) {
  for (auto& entry : map) visit(entry.texture);
}

template <Either<PatternedPigment> Record, class Visit>
void for_each_edge(Record& pigment, Visit&& visit) {
  for_each_edge(pigment.pattern, visit);
  visit(pigment.map);
}

template <Either<PigmentMap> Record, class Visit>
void for_each_edge(Record& map, Visit&& visit) {
  for (auto& entry : map) for_each_edge(entry.pigment, visit);
}

template <Either<Normal> Record, class Visit>
void for_each_edge(Record& normal, Visit&& visit) {
  for_each_edge(normal.pattern, visit);
  visit(normal.slope_map);
  visit(normal.map);
}

template <Either<NormalMap> Record, class Visit>
void for_each_edge(Record& map, Visit&& visit) {
  for (auto& entry : map) visit(entry.normal);
}

template <Either<Image> Record, class Visit>
void for_each_edge(Record& image, Visit&& visit) {
  visit(image.function);
}

// ---- Shapes, objects and lights -------------------------------------------------------------------------------------

template <Either<Component> Record, class Visit>
void for_each_edge(Record& component, Visit&& visit) {
  visit(component.texture);
  visit(component.transform);
  visit(component.kernel);
}

template <Either<Blob> Record, class Visit>
void for_each_edge(Record& blob, Visit&& visit) {
  for (auto& component : blob.components) for_each_edge(component, visit);
}

template <Either<Solid> Record, class Visit>
void for_each_edge(Record& solid, Visit&& visit) {
  switch (traits_of(solid.kind).detail) {
    case SolidDetail::none: break;
#define ISL_SOLID_DETAIL(word, Type, column)         \
  case SolidDetail::word:                            \
    detail::visit_as<Type##Id>(solid.detail, visit); \
    break;
#include "renderer/scene/solids.def"
  }
}

template <Either<Object> Record, class Visit>
void for_each_edge(Record& object, Visit&& visit) {
  switch (object.kind) {
    case Object::Kind::solid: detail::visit_as<SolidId>(object.shape, visit); break;
    case Object::Kind::blob: detail::visit_as<BlobId>(object.shape, visit); break;
    case Object::Kind::group: detail::visit_as<GroupId>(object.shape, visit); break;
  }
  visit(object.texture);
  visit(object.interior_texture);
  visit(object.interior);
  visit(object.clip);
  visit(object.bound);
}

template <Either<Light> Record, class Visit>
void for_each_edge(Record& light, Visit&& visit) {
  visit(light.projected_through);
}

template <Either<Group> Record, class Visit>
void for_each_edge(Record& group, Visit&& visit) {
  for (auto& child : group.children) for_each_edge(child, visit);
  for (auto& light : group.lights) for_each_edge(light, visit);
}

// ---- The world ------------------------------------------------------------------------------------------------------

namespace detail {

/// Visits what a field of a statement refers to; most refer to nothing.
template <class Statement_, class Visit>
struct FieldEdges {
  Visit& visit;

  template <class Value>
  void operator()(Value* value) const {
    auto& field = const_cast<std::conditional_t<std::is_const_v<Statement_>, const Value, Value>&>(*value);
    if constexpr (std::is_same_v<Value, std::vector<Pigment>>) {
      for (auto& pigment : field) for_each_edge(pigment, visit);
    } else if constexpr (std::is_enum_v<Value>) {
      visit(field);
    }
  }
};

}  // namespace detail

template <Either<Statement> Record, class Visit>
void for_each_edge(Record& statement, Visit&& visit) {
  // Fields know only records that may be changed; that of a constant statement is not.
  auto& record = const_cast<std::any&>(statement.record);
  for (const StatementField& field : statement.kind->fields)
    std::visit(detail::FieldEdges<Record, std::remove_reference_t<Visit>>{visit}, field.place(record));
}

template <Either<Camera> Record, class Visit>
void for_each_edge(Record& camera, Visit&& visit) {
  visit(camera.normal);
  for (auto& function : camera.location_of) visit(function);
  for (auto& function : camera.direction_of) visit(function);
  if (camera.blur && camera.blur->bokeh) for_each_edge(*camera.blur->bokeh, visit);
}

/// Visits the records that the world consists of, to which no other record refers: objects, lights, camera, sky …
template <Either<Database> Scene, class Visit>
void for_each_root(Scene& database, Visit&& visit) {
  if (database.camera) visit(*database.camera);
  for (auto& light : database.lights) visit(light);
  for (auto& statement : database.statements) visit(statement);
  visit(database.default_texture);
  for (auto& object : database.objects) visit(object);
}

// ---- Columns --------------------------------------------------------------------------------------------------------

/// A column and the type of its records' ids.
template <class Id_, class Record>
struct ColumnOf {
  using Id = Id_;
  std::vector<Record> Database::*records;
};

/// The columns whose records other records refer to.
inline constexpr auto kColumns = std::tuple{ColumnOf<KernelId, Kernel>{&Database::kernels},
                                            ColumnOf<TransformId, Transform>{&Database::transforms},
                                            ColumnOf<TextureId, Texture>{&Database::textures},
                                            ColumnOf<FinishId, Finish>{&Database::finishes},
                                            ColumnOf<PigmentId, PatternedPigment>{&Database::pigments},
                                            ColumnOf<PigmentMapId, PigmentMap>{&Database::pigment_maps},
                                            ColumnOf<NormalId, Normal>{&Database::normals},
                                            ColumnOf<NormalMapId, NormalMap>{&Database::normal_maps},
                                            ColumnOf<SlopeMapId, SlopeMap>{&Database::slope_maps},
                                            ColumnOf<TexturePatternId, TexturePattern>{&Database::texture_patterns},
                                            ColumnOf<TextureMapId, TextureMap>{&Database::texture_maps},
                                            ColumnOf<ImageId, Image>{&Database::images},
                                            ColumnOf<InteriorId, Interior>{&Database::interiors},
                                            ColumnOf<BlobId, Blob>{&Database::blobs},
                                            ColumnOf<SolidId, Solid>{&Database::solids},
#define ISL_SOLID_DETAIL(word, Type, column) ColumnOf<Type##Id, Type>{&Database::column},
#include "renderer/scene/solids.def"
                                            ColumnOf<GroupId, Group>{&Database::groups},
                                            ColumnOf<PatternObjectId, Object>{&Database::pattern_objects},
                                            ColumnOf<FunctionId, FunctionPointer>{&Database::functions}};

/// Calls visit(column) with each of kColumns.
template <class Visit>
void for_each_column(Visit&& visit) {
  std::apply([&](const auto&... columns) { (visit(columns), ...); }, kColumns);
}

/// The position in kColumns of the column with this type of ids.
template <class Id, std::size_t i = 0>
constexpr std::size_t column_of() {
  if constexpr (std::is_same_v<typename std::tuple_element_t<i, decltype(kColumns)>::Id, Id>) {
    return i;
  } else {
    return column_of<Id, i + 1>();
  }
}

/// True for records that refer to others.
template <class Record>
concept HasEdges = requires(Record& record) {
  for_each_edge(record, [](auto& /*id*/) {});
};

}  // namespace isl::scene
