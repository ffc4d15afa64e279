// Finishes: how a surface reflects and emits light.
#pragma once

#include "renderer/scene/colour.h"
#include "renderer/scene/said_at.h"

#include <cstddef>
#include <cstdint>

namespace isl::scene {

/// Reflection of other things: from `minimum` seen head-on to `maximum` at grazing angles, by the power `falloff`.
/// `exponent` is that of the reflected brightness.
struct Reflection {
  Colour minimum{}, maximum{};
#define ISL_REFLECTION_NUMBER(word, otherwise, form) double word = otherwise;
#include "renderer/scene/finish.def"
};

/// Items whose places are kept.
enum class FinishItem : std::uint8_t {
#define ISL_FINISH_COLOUR(word, grey, dump) word,
#define ISL_FINISH_NUMBER(word, otherwise, form, dump) word,
#define ISL_FINISH_FLAG(word, form, dump) word,
#include "renderer/scene/finish.def"
  reflection,
  fresnel_reflection,
  exponent,
  irid,
  count
};

/// How a scene writes an item.
enum class FinishForm : std::uint8_t {
  plain,     ///< its word, then its value
  albedo,    ///< `albedo` may stand before the value; the record has the peak
  amount,    ///< the value may be missing, and is 1 then
  positive,  ///< as `plain`, and the value must be above 0
  part,      ///< nothing: another item's reader sets it
};

/// When an item is in the dump: always, or if it differs from its default.
enum class FinishDump : std::uint8_t { always, changed };

/// POV-Ray 3.7's defaults; finish.def explains most members. Comparable byte by byte once its places are taken away
/// (without_places).
struct Finish {
#define ISL_FINISH_COLOUR(word, grey, dump) Colour word{grey, grey, grey};
#include "renderer/scene/finish.def"
#define ISL_FINISH_NUMBER(word, otherwise, form, dump) double word = otherwise;
#include "renderer/scene/finish.def"
  double irid = 0;
  double old_ior = 0;  ///< `ior` of POV-Ray 3.0, for the interior of an object without one; 0: not set
  double old_caustics = 0;
  Reflection reflection{};
#define ISL_FINISH_FLAG(word, form, dump) bool word = false;
#include "renderer/scene/finish.def"
  bool fresnel_reflection = false;  ///< by Fresnel's formula with the interior's ior

  /// The power of a highlight's cosine that `roughness` stands for.
  [[nodiscard]] double specular_exponent() const { return roughness == 0 ? 0 : 1 / roughness; }

 private:
  struct Flags {
#define ISL_FINISH_FLAG(word, form, dump) bool word;
#include "renderer/scene/finish.def"
    bool fresnel_reflection;
  };
  static constexpr std::size_t kTail = sizeof(Flags) + sizeof(SaidAt<FinishItem>) + sizeof(OriginId);

 public:
  bool unused[8 - kTail % 8] = {};  ///< instead of padding
  SaidAt<FinishItem> said_at{};
  OriginId named_at{};  ///< place of the identifier, if the finish is a declared one
};

static_assert(offsetof(Finish, said_at) + sizeof(Finish::said_at) + sizeof(OriginId) == sizeof(Finish), "no padding");

[[nodiscard]] inline Finish without_places(Finish finish) {
  finish.said_at = {};
  finish.named_at = {};
  return finish;
}

/// True if the finish reflects at any angle.
[[nodiscard]] inline bool reflects(const Finish& finish) {
  const auto shines = [](const Colour& colour) { return colour.red != 0 || colour.green != 0 || colour.blue != 0; };
  return shines(finish.reflection.minimum) || shines(finish.reflection.maximum);
}

}  // namespace isl::scene
