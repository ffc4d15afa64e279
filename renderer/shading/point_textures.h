// The textures at a point of a surface, as lighting needs them: patterns choose among textures, layers are laid over
// one another, and pigments are evaluated.
#pragma once

#include "base/run_limits.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/insides.h"
#include "renderer/rays/surface_point.h"
#include "renderer/scene/coordinate_textures.h"
#include "renderer/shading/material.h"
#include "renderer/solids/surface_coordinates.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace isl::render {

/// Lists of what effects ask for besides a point's LitTextures, in their order. Null: not asked for.
struct LayerLists {
  Vec3 normal{0};                        ///< of the point: unit, in the world, turned to the viewer
  std::vector<Vec3>* normals = nullptr;  ///< as bumps bend it
  /// The share of light that the whole texture lets through, at its top layer; 0 at the layers below. If it is not
  /// asked for, the lowest layer lets nothing through.
  std::vector<Rgb>* passing = nullptr;
  /// The share of a layer's own colour that is seen. It is asked for together with `passing`.
  std::vector<double>* opacities = nullptr;
  Vec3 view{0};          ///< the direction of the ray
  bool mirrors = false;  ///< layers that conserve energy let less through, the more they mirror
  double ior_ratio = 1;  ///< the index of refraction before the surface over that behind it

  void resize(std::size_t size) const {
    if (normals) normals->resize(size);
    if (passing) passing->resize(size);
    if (opacities) opacities->resize(size);
  }
};

/// Serves one database; immutable, shared by all threads.
class PointTextures {
 public:
  /// `run` limits the steps at each point. `images` may be null if no texture has one.
  explicit PointTextures(const scene::Database& database, const RunLimits& run = {},
                         const ImageTable* images = nullptr);
  PointTextures(const PointTextures&) = delete;
  PointTextures& operator=(const PointTextures&) = delete;

  /// Appends the textures that the point's shares consist of: at least one entry for each, in their order, the top
  /// layer first, and appends to `lists` as well. `charge` counts the memory that `lit` grows by. False, with
  /// nothing appended, if that or the steps of the run did not suffice, or the run is stopped.
  [[nodiscard]] bool append(const SurfacePoint& point, std::vector<LitTexture>& lit, Charge& charge,
                            const LayerLists& lists = {}) const {
    if (point.textures.size() == 1 && lit.size() < lit.capacity()) [[likely]] {
      const TextureShare& share = point.textures.front();
      if (const LitTexture& same = same_everywhere_[texture_number(share.texture)]; same.material != nullptr) {
        lit.push_back(same);
        if (lists.normals) lists.normals->push_back(lists.normal);
        if (lists.passing) {
          lists.passing->push_back(Rgb(0));
          if (lists.opacities) lists.opacities->push_back(1);
        }
        return true;
      }
      if (is_one_layer_[texture_number(share.texture)]) return append_layer(point, lit, lists);
    }
    return append_each(point, lit, charge, lists);
  }

  /// The colour of a pigment that is on no surface, such as the sky's. Nullopt if the steps of the run did not suffice,
  /// or the run is stopped.
  [[nodiscard]] std::optional<scene::Colour> pigment_colour(const scene::Pigment& pigment, const Vec3& point) const;

  /// (u, v) of a place on a shape; `world` is the same point in the world.
  [[nodiscard]] Coordinates coordinates_of(const SurfacePlace& place, const Vec3& world) const;

 private:
  [[nodiscard]] std::size_t texture_number(scene::TextureId id) const {
    return id == scene::kNoTexture ? same_everywhere_.size() - 1 : index(id);
  }
  /// append() for a single layer that is all the point's texture.
  [[nodiscard]] bool append_layer(const SurfacePoint& point, std::vector<LitTexture>& lit,
                                  const LayerLists& lists) const;
  /// append() for all others that depend on the point.
  [[nodiscard]] bool append_each(const SurfacePoint& point, std::vector<LitTexture>& lit, Charge& charge,
                                 const LayerLists& lists) const;
  /// The textures of one point in the making.
  struct Making;
  /// Adds a texture with all its parts, at a point of the space that it lives in.
  void add(scene::TextureId id, double weight, const Vec3& point, Making& making) const;
  /// Adds the textures that a pattern chooses at the point.
  void add_chosen(const scene::TexturePattern& choice, double weight, const Vec3& point, Making& making) const;
  /// The share of a layer's own colour that is seen; below 0 if it lets more than all through.
  [[nodiscard]] double opacity(const scene::Colour& colour) const {
    const double filter = is_old_ ? colour.filter * largest(rgb(colour)) : colour.filter;
    return 1 - filter - colour.transmit;
  }
  /// The share of light that a layer lets through.
  [[nodiscard]] Rgb passing_share(const Material& material, const scene::Colour& colour, const Vec3& normal,
                                  const LayerLists& lists) const;
  /// Adds a layer's normal to the list.
  void add_normal(const scene::Texture& layer, const Vec3& point, Making& making) const;
  /// Adds the texture and the layers below it.
  void add_layers(scene::TextureId top, double weight, const Vec3& point, Making& making) const;

  const scene::Database& database_;
  RunLimits run_;
  MaterialTable materials_;
  /// Textures that are one opaque layer of one colour without bumps, by number, the scene's default last; all others
  /// have no material here.
  std::vector<LitTexture> same_everywhere_;
  std::vector<bool> is_one_layer_;  ///< of textures, in the same order: no others, no coordinates of the surface
  scene::CoordinateTextures coordinate_textures_;
  Insides insides_;
  Patterns patterns_;
  values::NoiseGenerator noise_generator_;
  bool is_old_;  ///< before version 3.7, dark filters hid less of their own colour
};

}  // namespace isl::render
