// Makes instances of placed objects: unions are placed part by part, other groups become CSG trees.
#pragma once

#include "base/run_limits.h"
#include "renderer/compiled/compiled_scene.h"
#include "renderer/csg/csg_builder.h"
#include "renderer/csg/expansion.h"
#include "renderer/rays/ray.h"

#include <cstdint>
#include <vector>

namespace isl::render {

/// The kinds of rays that an object is hidden from, as bits.
[[nodiscard]] inline unsigned hidden_from(const scene::Object& object) {
  const auto bit = [](bool is_hidden, RayKind kind) { return is_hidden ? static_cast<unsigned>(kind) : 0; };
  return bit(object.no_image, RayKind::image) | bit(object.no_reflection, RayKind::reflection) |
         bit(object.no_shadow, RayKind::shadow) | bit(object.no_radiosity, RayKind::around);
}

/// Walks the tree of objects, composing transforms and handing textures down. The unions that are open are a list
/// instead of recursion, so that depth costs no stack.
class Flattener {
 public:
  Flattener(const scene::Database& database, const Expansion& expansion, Meter& meter, CompiledScene& compiled)
      : database_(database),
        expansion_(expansion),
        meter_(meter),
        compiled_(compiled),
        csg_(database, expansion, meter, compiled.charge) {}

  /// State that an object hands down to its children.
  struct Inherited {
    scene::Transform world_from_parent{};
    PlacedTexture texture{}, interior_texture{};
    std::uint8_t hidden_from = 0;
    bool is_inverse = false;
    bool is_lit_from_both_sides = false;
    bool is_hollow = false;
    scene::InteriorId interior = scene::kNoInterior;
    std::uint32_t holder = scene::kNone;
    std::uint32_t light_group = scene::kNone;
  };

  /// Adds an object of the world.
  void add(const scene::Object& object) {
    add(object, {});
    while (!open_.empty()) {
      OpenUnion& innermost = open_.back();
      if (innermost.next == innermost.children->size()) {
        open_.pop_back();
      } else {
        const scene::Object& child = (*innermost.children)[innermost.next++];
        add(child, Inherited(innermost.own));  // a copy, because opening the child moves the list
      }
      if (!meter_.goes_on()) open_.clear();
    }
  }

  void finish() { compiled_.trees = csg_.take_trees(); }

 private:
  struct OpenUnion {
    const std::vector<scene::Object>* children;
    Inherited own;
    std::size_t next = 0;
  };

  /// Makes the object's instance, or opens it if it is a union.
  void add(const scene::Object& object, const Inherited& above) {
    // Groups of empty groups are as many as others.
    if (!meter_.goes_on() || expansion_.instances(object, above.is_inverse) == 0) return;
    Inherited own{then(object.parent_from_object, above.world_from_parent),
                  above.texture,
                  above.interior_texture,
                  static_cast<std::uint8_t>(above.hidden_from | hidden_from(object)),
                  above.is_inverse != object.inverse,
                  above.is_lit_from_both_sides || object.double_illuminate,
                  above.is_hollow || object.hollow,
                  object.interior == scene::kNoInterior ? above.interior : object.interior,
                  object.interior == scene::kNoInterior && above.holder != scene::kNone ? above.holder : holders_++,
                  above.light_group};
    const bool is_csg = needs_csg(database_, object, above.is_inverse);
    const bool is_union = object.kind == scene::Object::Kind::group && !is_csg;
    const auto take = [&](scene::TextureId id, PlacedTexture& texture) {
      if (id == scene::kNoTexture) return true;
      texture = {id, kOwnSpace};
      if (!is_union || database_.texture(id).is_plain()) return true;
      if (!meter_.grow(compiled_.charge, 2 * sizeof(scene::Transform))) return false;
      texture.space = static_cast<TextureSpace>(compiled_.texture_spaces.size());
      compiled_.texture_spaces.push_back(own.world_from_parent);
      return true;
    };
    if (!take(object.texture, own.texture) || !take(object.interior_texture, own.interior_texture)) return;
    if (object.kind == scene::Object::Kind::group && database_.groups[object.shape].is_light_group &&
        !enter_light_group(scene::GroupId{object.shape}, own)) {
      return;
    }
    if (is_union) {
      open_.push_back({&database_.groups[object.shape].children, own});
      return;
    }
    const bool is_placed = own.world_from_parent.matrix != scene::Matrix();
    const std::uint32_t shape = is_csg ? csg_.tree_of(object, above.is_inverse) : object.shape;
    compiled_.instances.push_back({is_csg ? scene::Object::Kind::group : object.kind,
                                   own.hidden_from,
                                   is_placed,
                                   own.is_inverse && !is_csg,
                                   own.is_lit_from_both_sides,
                                   own.is_hollow,
                                   shape,
                                   own.texture,
                                   own.interior_texture,
                                   own.interior,
                                   own.holder,
                                   &object,
                                   own.world_from_parent,
                                   object.origin,
                                   own.light_group,
                                   0,
                                   {}});
  }

  /// The lights of the innermost group count. Whether those of the world do is decided by the outermost, as in POV-Ray.
  bool enter_light_group(scene::GroupId group, Inherited& own) {
    // Each placed group has its own copies of its lights when pictures are made.
    const std::size_t lights = database_.groups[index(group)].lights.size();
    if (!meter_.grow(compiled_.charge, 2 * sizeof(LightGroup) + lights * sizeof(scene::Light))) return false;
    const bool has_global_lights = own.light_group == scene::kNone
                                       ? database_.groups[index(group)].global_lights
                                       : compiled_.light_groups[own.light_group].has_global_lights;
    own.light_group = static_cast<std::uint32_t>(compiled_.light_groups.size());
    compiled_.light_groups.push_back({group, own.world_from_parent, has_global_lights});
    return true;
  }

  const scene::Database& database_;
  const Expansion& expansion_;
  Meter& meter_;
  CompiledScene& compiled_;
  CsgBuilder csg_;
  std::vector<OpenUnion> open_;
  std::uint32_t holders_ = 0;  ///< of interiors, until now
};

}  // namespace isl::render
