// The primitive database: the evaluator builds it from a scene, and the renderer compiles it. It has flat columns of
// plain records that refer to one another by index, independent of the language. Lengths are in scene units, angles
// in radians, colours in linear light.
#pragma once

#include "renderer/scene/camera.h"
#include "renderer/scene/fields.h"
#include "renderer/scene/function.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/image.h"
#include "renderer/scene/interior.h"
#include "renderer/scene/light.h"
#include "renderer/scene/objects.h"
#include "renderer/scene/settings.h"
#include "renderer/scene/solids.h"
#include "renderer/scene/statement.h"
#include "renderer/scene/texture.h"

#include <optional>
#include <vector>

namespace isl::scene {

/// The content of a scene. Immutable once the scene is evaluated.
struct Database {
  std::vector<Kernel> kernels;
  std::vector<Transform> transforms;
  std::vector<Texture> textures;
  std::vector<Finish> finishes;
  std::vector<PatternedPigment> pigments;
  std::vector<PigmentMap> pigment_maps;
  std::vector<Normal> normals;
  std::vector<NormalMap> normal_maps;
  std::vector<SlopeMap> slope_maps;
  std::vector<TexturePattern> texture_patterns;
  std::vector<TextureMap> texture_maps;
  std::vector<Image> images;
  std::vector<Interior> interiors;
  std::vector<Blob> blobs;
  std::vector<Solid> solids;
#define ISL_SOLID_DETAIL(word, Type, column) std::vector<Type> column;
#include "renderer/scene/solids.def"
  std::vector<Group> groups;
  std::vector<Object> objects;          ///< the objects of the world
  std::vector<Object> pattern_objects;  ///< objects of `object` patterns; not in the world
  std::vector<Light> lights;
  std::vector<FunctionPointer> functions;  ///< the functions that other records refer to
  std::vector<Statement> statements;       ///< of effects that have one of their own, such as the air's
  std::optional<Camera> camera;
  Texture default_texture;
  Settings settings;

  // Defaulted in database.cpp, so that they are compiled once and not in each file that holds a database.
  Database();
  Database(const Database&);
  Database(Database&&) noexcept;
  Database& operator=(const Database&);
  Database& operator=(Database&&) noexcept;
  ~Database();

  [[nodiscard]] const Texture& texture(TextureId id) const {
    return id == kNoTexture ? default_texture : textures[index(id)];
  }
  /// The colour of a uniform pigment.
  [[nodiscard]] const Colour& colour(const Pigment& pigment) const {
    return pigment.is_plain() ? pigment.colour : pigments[index(pigment.pattern)].colour;
  }
  [[nodiscard]] const Finish& finish(FinishId id) const {
    static const Finish otherwise;
    return id == kDefaultFinish ? otherwise : finishes[index(id)];
  }
};

}  // namespace isl::scene
