#include "renderer/shading/point_textures.h"

#include "renderer/fields/skeleton_coordinates.h"
#include "renderer/patterns/map_interval.h"
#include "renderer/patterns/own_space.h"
#include "renderer/shading/mirror.h"
#include "renderer/solids/solid.h"

#include <algorithm>
#include <span>

namespace isl::render {
namespace {

/// The point at which a texture's patterns are evaluated.
const Vec3& place_of(const scene::Texture& texture, const Vec3& point, const values::Environment& environment) {
  return texture.uv_mapping != 0 ? *environment.coordinates() : point;
}

}  // namespace

Coordinates PointTextures::coordinates_of(const SurfacePlace& place, const Vec3& world) const {
  if (place.shape == scene::kNone) return {world.x, world.y};
  if (place.kind == scene::Object::Kind::solid)
    return solid_coordinates(database_.solids[place.shape], place.point, world);
  return skeleton_coordinates(database_, database_.blobs[place.shape], place.component, place.point, world);
}

struct PointTextures::Making {
  values::Environment environment;
  std::vector<LitTexture>& lit;
  Charge& charge;
  const LayerLists& lists;
  // These are set if bumps are asked for. A texture's space lies inside those of the patterns that chose the texture.
  Vec3 normal{0};  ///< in the space of the present texture, of any length
  TextureFrame frame{};
  std::vector<const scene::Pattern*> within{};
  values::SurfaceView surface{};  ///< for patterns that depend on it

  /// Maps whose entries have maps choose so many textures that their number is limited by memory alone.
  void push(const Material& material, const Rgb& pigment, const Rgb& colour, double weight, const Rgb& let_through) {
    if (lit.size() == lit.capacity()) [[unlikely]] {
      const std::size_t capacity = std::max<std::size_t>(2 * lit.capacity(), 64);
      const std::size_t size = sizeof(LitTexture) + (lists.normals ? sizeof(Vec3) : 0) +
                               (lists.passing ? sizeof(Rgb) : 0) + (lists.opacities ? sizeof(double) : 0);
      if (!charge.grow((capacity - lit.capacity()) * size)) {
        environment.steps().spend();
        return;
      }
      lit.reserve(capacity);
    }
    lit.emplace_back(&material, pigment, colour, weight, let_through);
  }
};

PointTextures::PointTextures(const scene::Database& database, const RunLimits& run, const ImageTable* images)
    : database_(database),
      run_(run),
      materials_(database),
      coordinate_textures_(database),
      insides_(database, run),
      patterns_(database, &insides_, database.settings.number_of_waves, images),
      noise_generator_(values::noise_generator_of(database.settings.noise_generator)),
      is_old_(database.settings.language_version < 3.7) {
  const auto lit_of = [&](scene::TextureId id) {
    const scene::Texture& texture = database.texture(id);
    const Material& material = materials_[id];
    const scene::Colour& colour = database.colour(texture.pigment);
    const bool is_same = texture.pattern == scene::kNoTexturePattern && texture.below == scene::kNoTexture &&
                         texture.normal == scene::kNoNormal && !material.is_patterned && colour.filter == 0 &&
                         colour.transmit == 0;
    return LitTexture{is_same ? &material : nullptr, material.pigment, material.pigment, 1};
  };
  const auto add_texture = [&](scene::TextureId id) {
    const scene::Texture& texture = database.texture(id);
    same_everywhere_.push_back(lit_of(id));
    is_one_layer_.push_back(texture.pattern == scene::kNoTexturePattern && texture.below == scene::kNoTexture &&
                            texture.uv_mapping == 0 && !coordinate_textures_.has(id));
  };
  same_everywhere_.reserve(database.textures.size() + 1);
  is_one_layer_.reserve(database.textures.size() + 1);
  for (std::uint32_t i = 0; i < database.textures.size(); ++i) add_texture(scene::TextureId{i});
  add_texture(scene::kNoTexture);
}

bool PointTextures::append_layer(const SurfacePoint& point, std::vector<LitTexture>& lit,
                                 const LayerLists& lists) const {
  const TextureShare& share = point.textures.front();
  const scene::Texture& layer = database_.texture(share.texture);
  const Material& material = materials_[share.texture];
  values::Environment environment(noise_generator_, run_, &patterns_);
  values::SurfaceView surface{&point.position, &lists.normal, &lists.view};
  Vec3 bent;
  environment.set_surface(&surface);
  if (layer.normal != scene::kNoNormal && lists.normals) {
    const Vec3 normal = patterns_.bent(database_.normals[scene::index(layer.normal)], share.place,
                                       share.frame.enter(lists.normal), environment);
    bent = share.frame.is_world() ? normal : share.frame.leave(normal).normalized();
    surface.normal = &bent;
  }
  const scene::Colour colour = material.is_patterned ? patterns_.pigment_colour(layer.pigment, share.place, environment)
                                                     : database_.colour(layer.pigment);
  if (environment.is_spent()) return false;
  const Rgb own = rgb(colour);
  lit.emplace_back(&material, lists.passing ? own * opacity(colour) : own, own, share.weight);
  if (lists.passing) {
    lists.passing->push_back(passing_share(material, colour, *surface.normal, lists));
    if (lists.opacities) lists.opacities->push_back(opacity(colour));
  }
  if (lists.normals) lists.normals->push_back(*surface.normal);
  return true;
}

Rgb PointTextures::passing_share(const Material& material, const scene::Colour& colour, const Vec3& normal,
                                 const LayerLists& lists) const {
  const Rgb share = rgb(colour) * colour.filter + Rgb(colour.transmit);
  if (!lists.mirrors || !material.finish->conserve_energy) return share;
  const Rgb mirrored = reflectivity_at(*material.finish, -normal.dot(lists.view), lists.ior_ratio, rgb(colour));
  return share * (Rgb(1) - (material.finish->use_alpha ? mirrored * opacity(colour) : mirrored));
}

bool PointTextures::append_each(const SurfacePoint& point, std::vector<LitTexture>& lit, Charge& charge,
                                const LayerLists& lists) const {
  const std::size_t first = lit.size();
  Making making{values::Environment(noise_generator_, run_, &patterns_), lit, charge, lists};
  making.surface = {&point.position, &lists.normal, &lists.view};
  making.environment.set_surface(&making.surface);
  Vec3 coordinates;
  for (const TextureShare& share : point.textures) {
    making.environment.set_coordinates(nullptr);
    if (coordinate_textures_.has(share.texture)) {
      coordinates = coordinates_of(share.surface, point.position).point();
      making.environment.set_coordinates(&coordinates);
    }
    if (!lists.normals) {
      add(share.texture, share.weight, share.place, making);
      continue;
    }
    making.frame = share.frame;
    making.normal = share.frame.enter(lists.normal);
    add(share.texture, share.weight, share.place, making);
  }
  if (!making.environment.is_spent()) [[likely]]
    return true;
  lit.erase(lit.begin() + static_cast<std::ptrdiff_t>(first), lit.end());
  lists.resize(first);
  return false;
}

std::optional<scene::Colour> PointTextures::pigment_colour(const scene::Pigment& pigment, const Vec3& point) const {
  values::Environment environment(noise_generator_, run_, &patterns_);
  const scene::Colour colour = patterns_.pigment_colour(pigment, point, environment);
  if (environment.is_spent()) return std::nullopt;
  return colour;
}

void PointTextures::add(scene::TextureId id, double weight, const Vec3& point, Making& making) const {
  const scene::Texture& texture = database_.texture(id);
  if (texture.pattern == scene::kNoTexturePattern) return add_layers(id, weight, point, making);
  const scene::TexturePattern& choice = database_.texture_patterns[scene::index(texture.pattern)];
  const Vec3& place = place_of(texture, point, making.environment);
  if (!making.lists.normals) return add_chosen(choice, weight, place, making);
  const Vec3 normal = making.normal;
  making.normal = into_own_space(database_, choice.pattern, normal);
  making.within.push_back(&choice.pattern);
  add_chosen(choice, weight, place, making);
  making.within.pop_back();
  making.normal = normal;
}

void PointTextures::add_chosen(const scene::TexturePattern& choice, double weight, const Vec3& point,
                               Making& making) const {
  if (making.environment.is_spent()) return;
  const scene::TextureMap& map = database_.texture_maps[scene::index(choice.map)];
  making.surface.normal = &making.lists.normal;
  const PatternPlace place = patterns_.look_up(choice.pattern, point, making.environment);
  if (info_of(choice.pattern.kind).choice == PatternChoice::mean_of_map) {
    double total = 0;
    for (const scene::TextureEntry& entry : map) total += entry.value;
    if (total == 0) return;
    for (const scene::TextureEntry& entry : map)
      add(entry.texture, weight * (entry.value / total), place.point, making);
    return;
  }
  const auto interval = find_in(map, place.value);
  if (interval.first != interval.second)
    add(interval.first->texture, weight * (1 - interval.fraction), place.point, making);
  const double second = interval.first == interval.second ? 1 : interval.fraction;
  add(interval.second->texture, weight * second, place.point, making);
}

void PointTextures::add_normal(const scene::Texture& layer, const Vec3& point, Making& making) const {
  if (layer.normal == scene::kNoNormal) return making.lists.normals->push_back(making.lists.normal);
  const Vec3& place = place_of(layer, point, making.environment);
  Vec3 normal = patterns_.bent(database_.normals[scene::index(layer.normal)], place, making.normal, making.environment);
  if (making.within.empty() && making.frame.is_world())  // of unit length already
    return making.lists.normals->push_back(normal);
  for (auto pattern = making.within.rbegin(); pattern != making.within.rend(); ++pattern)
    normal = out_of_own_space(database_, **pattern, normal);
  making.lists.normals->push_back(making.frame.leave(normal).normalized());
}

void PointTextures::add_layers(scene::TextureId top, double weight, const Vec3& point, Making& making) const {
  Rgb let_through(1);
  std::vector<Rgb>* const passing = making.lists.passing;
  const std::size_t first = passing ? passing->size() : 0;
  for (scene::TextureId id = top;;) {
    const scene::Texture& layer = database_.texture(id);
    const Material& material = materials_[id];
    if (making.lists.normals) {
      making.surface.normal = &making.lists.normal;
      add_normal(layer, point, making);
      making.surface.normal = &making.lists.normals->back();
    }
    if (passing) passing->push_back(Rgb(0));
    const bool is_lowest = layer.below == scene::kNoTexture;
    if (is_lowest && !material.is_patterned && !passing) {
      making.push(material, material.pigment, material.pigment, weight, let_through);
      return;
    }
    const scene::Colour colour =
        material.is_patterned
            ? patterns_.pigment_colour(layer.pigment, place_of(layer, point, making.environment), making.environment)
            : database_.colour(layer.pigment);
    if (is_lowest && !passing) {
      making.push(material, rgb(colour), rgb(colour), weight, let_through);
      return;
    }
    if (making.lists.opacities) making.lists.opacities->push_back(opacity(colour));
    making.push(material, rgb(colour) * opacity(colour), rgb(colour), weight, let_through);
    let_through *= passing_share(
        material, colour, making.lists.normals ? making.lists.normals->back() : making.lists.normal, making.lists);
    if (let_through == Rgb(0)) return;
    if (is_lowest) {
      (*passing)[first] = let_through;
      return;
    }
    id = layer.below;
  }
}

}  // namespace isl::render
