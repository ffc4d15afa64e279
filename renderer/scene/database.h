// The primitive database: what the evaluator makes of a scene and the renderer compiles. Flat columns of plain records that
// refer to one another by number; nothing here knows text. Lengths are scene units, angles radians, colours linear light.
#pragma once

#include "base/source_span.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace isl::scene {

/// Linear red, green, blue, and POV-Ray's filter and transmit (0 is opaque).
struct Colour {
  double red = 0, green = 0, blue = 0, filter = 0, transmit = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

// ---- Fields ---------------------------------------------------------------------------------------------------------

/// The shape of φ(q), q = squared distance to the skeleton over the squared radius.
enum class KernelShape : std::uint8_t { quartic, gaussian };

/// What a component's radius means. `surface`: the radius of the surface that the component has alone (ours: φ(1) = 1,
/// φ′(1) = −hardness). `support`: where the field ends (POV-Ray's own components: φ(q) = (1 − q)², q = 1 at the radius).
enum class RadiusMeaning : std::uint8_t { surface, support };

struct Kernel {
  KernelShape shape = KernelShape::quartic;
  RadiusMeaning meaning = RadiusMeaning::support;
  double hardness = 4;  ///< in (0, 500]; without meaning for `support`
  friend bool operator==(const Kernel&, const Kernel&) = default;
};

/// point: a, radius_a. segment: a to b, radius_a. cone: a to b, radius_a at a and radius_b at b (a round cone: the union of
/// the spheres whose centre and radius run linearly from one end to the other).
enum class Skeleton : std::uint8_t { point, segment, cone };

/// One field of a blob: f = strength · φ(squared distance / radius²), in the blob's space after `transform`.
struct Component {
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
  double strength = 1;
  TextureId texture = kNoTexture;       ///< kNoTexture: the blob's
  TransformId transform = kIdentity;    ///< blob_from_component
  KernelId kernel{};
  Skeleton skeleton = Skeleton::point;
};

/// Components whose fields add up; the surface is where the sum meets the threshold. In the blob's own space.
struct Blob {
  double threshold = 1;
  std::vector<Component> components;
  std::vector<OriginId> origins;  ///< cold: one a component
};

// ---- Solids ---------------------------------------------------------------------------------------------------------

/// sphere: centre a, radius_a. cylinder: a to b, radius_a, with flat caps. cone: a, radius_a to b, radius_b, flat caps.
/// plane: the half-space p·a ≤ radius_a, a normalised.
enum class SolidKind : std::uint8_t { sphere, cylinder, cone, plane };

struct Solid {
  SolidKind kind = SolidKind::sphere;
  bool open = false;  ///< cylinder and cone: without caps
  Vec3 a{0}, b{0};
  double radius_a = 0, radius_b = 0;
};

// ---- Materials ------------------------------------------------------------------------------------------------------

struct Pigment {
  Colour colour{};  ///< POV-Ray's default pigment is black
};

/// POV-Ray 3.7's defaults.
struct Finish {
  Colour ambient{0.1, 0.1, 0.1};
  double diffuse = 0.6;
  double brilliance = 1;
  double phong = 0;
  double phong_size = 40;
  double specular = 0;
  double roughness = 0.05;
};

struct Texture {
  Pigment pigment;
  Finish finish;
};

// ---- Objects --------------------------------------------------------------------------------------------------------

/// Something placed: a shape and where it stands. Shapes are shared; placing one again costs an Object.
struct Object {
  enum class Kind : std::uint8_t { solid, blob, group };
  Kind kind = Kind::solid;
  bool no_shadow = false;
  std::uint32_t shape = kNone;       ///< index into solids, blobs or groups
  Transform parent_from_object{};    ///< into the group that holds it, or the world
  TextureId texture = kNoTexture;    ///< kNoTexture: the group's, in the end the scene's default
  OriginId origin{};
};

/// A union: children with their own textures and transforms. Children are whole objects, so that a group is self-contained.
struct Group {
  std::vector<Object> children;
};

// ---- The rest of a scene --------------------------------------------------------------------------------------------

/// A perspective camera after look_at, angle and sky have been applied: the ray through image coordinates (u, v), u and v
/// from −½ to ½, right and up, goes along direction + u·right + v·up. The vectors carry their lengths.
struct Camera {
  Vec3 location{0, 0, 0};
  Vec3 direction{0, 0, 1};
  Vec3 right{4.0 / 3.0, 0, 0};
  Vec3 up{0, 1, 0};
};

/// A point light without fading.
struct Light {
  Vec3 location{0};
  Colour colour{1, 1, 1};
  bool shadowless = false;
  OriginId origin{};
};

struct Settings {
  double language_version = 3.7;
  /// None: no gamma handling at all (a scene of before 3.7 that does not set it): pixel values go to the file as they are.
  std::optional<double> assumed_gamma;
  /// srgb: assumed_gamma 'srgb', a transfer curve rather than a power.
  bool assumed_gamma_srgb = false;
  Colour ambient_light{1, 1, 1};
  Colour background{0, 0, 0};
  int max_trace_level = 5;
  double adc_bailout = 1.0 / 255.0;
  std::string solver;     ///< "" where the scene does not say
  std::string tolerance;  ///< as written: "0.05px" or "1e-4"; "" where the scene does not say
};

/// Everything a scene says. Immutable once evaluated.
struct Database {
  std::vector<Kernel> kernels;
  std::vector<Transform> transforms;
  std::vector<Texture> textures;
  std::vector<Blob> blobs;
  std::vector<Solid> solids;
  std::vector<Group> groups;
  std::vector<Object> objects;  ///< what stands in the world
  std::vector<Light> lights;
  std::optional<Camera> camera;
  Texture default_texture;
  Settings settings;

  [[nodiscard]] const Texture& texture(TextureId id) const { return id == kNoTexture ? default_texture : textures[index(id)]; }
};

}  // namespace isl::scene
