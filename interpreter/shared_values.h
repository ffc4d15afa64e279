// The non-numeric values that a Value points to. Immutable once made, except for containers.
#pragma once

#include "base/budget.h"
#include "grammar/ast.h"
#include "grammar/loader.h"
#include "interpreter/containers.h"
#include "interpreter/scopes.h"
#include "interpreter/shared.h"
#include "interpreter/value.h"
#include "renderer/scene/database.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isl::interpreter {

/// Bytes that the scene and its live values hold. Context::check_memory() makes room before something large is made.
using MemoryAccount = Charge;

struct StringValue final : Shared {
  StringValue(std::string text_, MemoryAccount& account_) : text(std::move(text_)), account(account_) {
    account.add(bytes());
  }
  ~StringValue() override { account.remove(bytes()); }

  [[nodiscard]] std::size_t bytes() const { return text.capacity() + sizeof(StringValue); }
  /// Only where nothing else points to the string.
  void append(std::string_view more) {
    account.remove(bytes());
    text.append(more);
    account.add(bytes());
  }

  std::string text;  ///< changed by append() alone
  MemoryAccount& account;
};

struct Routine;  // interpreter/routines/routine.h

struct MacroValue final : Shared {
  MacroValue(const grammar::Macro& definition_, const grammar::Unit& unit_, std::uint32_t origin_name_)
      : definition(definition_), unit(unit_), origin_name(origin_name_) {}

  const grammar::Macro& definition;
  const grammar::Unit& unit;  ///< its #include starts from this file's folder
  std::uint32_t origin_name;  ///< OriginTable::keep_name
  // Set by routine_of() (interpreter/routines/routines.h).
  mutable bool is_examined = false;
  mutable const Routine* routine = nullptr;
};

/// The look of objects, their drafts and materials.
struct Surface {
  std::optional<scene::Texture> texture;  ///< in the object's space
  /// How the pigment of `texture` was moved while it was a plain colour, in the object's space (read_pigment). Null:
  /// not at all.
  std::shared_ptr<const scene::Transform> plain_moved;
  std::optional<scene::Texture> interior_texture;  ///< of the inside of the surface, if it differs
  scene::InteriorId interior = scene::kNoInterior;
  bool uv_mapping = false;  ///< `uv_mapping` precedes the textures: all of them are evaluated at (u, v)
};

/// An object that is declared or about to be placed: a placement of shapes that are already in the database, and the
/// lights that it holds (a union may hold some; a light_source is nothing else).
struct ObjectValue final : Shared {
  grammar::Symbol word = grammar::kNoSymbol;  ///< `sphere`, `blob`, … as it was made; none for an empty object
  scene::Object object;                       ///< shape is kNone for lights
  Surface surface;
  std::vector<scene::Light> lights;
};

struct PigmentValue final : Shared {
  PigmentValue(const scene::Pigment& pigment_, const scene::Transform& plain_moved_)
      : pigment(pigment_), plain_moved(plain_moved_) {}
  const scene::Pigment pigment;
  const scene::Transform plain_moved;  ///< as in Surface, in the pigment's space
};

struct FinishValue final : Shared {
  explicit FinishValue(const scene::Finish& finish_) : finish(finish_) {}
  const scene::Finish finish;
};

struct TextureValue final : Shared {
  TextureValue(const scene::Texture& texture_, const scene::Transform& plain_moved_)
      : texture(texture_), plain_moved(plain_moved_) {}
  const scene::Texture texture;
  const scene::Transform plain_moved;  ///< as in Surface, in the texture's space
};

struct NormalValue final : Shared {
  explicit NormalValue(scene::NormalId id_) : id(id_) {}
  const scene::NormalId id;
};

struct InteriorValue final : Shared {
  explicit InteriorValue(scene::InteriorId id_) : id(id_) {}
  const scene::InteriorId id;
};

struct MaterialValue final : Shared {
  explicit MaterialValue(const Surface& surface_) : surface(surface_) {}
  const Surface surface;
};

/// A declared map: its number in the database. PigmentMapValue: colour_map and pigment_map.
template <class Id>
struct MapValue final : Shared {
  explicit MapValue(Id id_) : id(id_) {}
  const Id id;
};
using PigmentMapValue = MapValue<scene::PigmentMapId>;
using NormalMapValue = MapValue<scene::NormalMapId>;
using SlopeMapValue = MapValue<scene::SlopeMapId>;
using TextureMapValue = MapValue<scene::TextureMapId>;

struct StatementValue final : Shared {
  explicit StatementValue(scene::Statement statement_) : statement(std::move(statement_)) {}
  const scene::Statement statement;
};

struct TransformValue final : Shared {
  explicit TransformValue(const scene::Transform& transform_) : transform(transform_) {}
  const scene::Transform transform;
};

struct CameraValue final : Shared {
  CameraValue(const scene::Camera& camera_, const scene::Vec3& sky_, SourceSpan size_span_)
      : camera(camera_), sky(sky_), size_span(size_span_) {}
  const scene::Camera camera;
  const scene::Vec3 sky;
  const SourceSpan size_span;  ///< span of the item that decides its shape: `right`, else the word `camera`
};

struct FunctionValue final : Shared {
  FunctionValue(scene::FunctionPointer function_, std::size_t bytes_, MemoryAccount& account_)
      : function(std::move(function_)), bytes(bytes_), account(account_) {
    account.add(bytes);
  }
  ~FunctionValue() override { account.remove(bytes); }

  const scene::FunctionPointer function;
  const std::size_t bytes;
  MemoryAccount& account;
};

struct SplineValue final : Shared {
  SplineValue(std::shared_ptr<const scene::Spline> spline_, MemoryAccount& account_)
      : spline(std::move(spline_)), account(account_) {
    account.add(bytes());
  }
  ~SplineValue() override { account.remove(bytes()); }
  [[nodiscard]] std::size_t bytes() const { return spline->points.size() * sizeof(scene::SplinePoint); }

  const std::shared_ptr<const scene::Spline> spline;
  MemoryAccount& account;
};

}  // namespace isl::interpreter
