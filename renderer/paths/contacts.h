// Contacts: places where faces of several objects coincide, such as those of a glass and its drink. A path crosses such
// faces one after the other, as if there were gaps of no width between them: first those of the bodies that it is in,
// the last entered first, then the others, in the order of declaration. Between two faces the path has no length, so
// nothing is traced there: rounding could neither lose a face nor find one twice.
//
// A path that turns back at a face, such as a mirrored one, crosses those before it once more, in the opposite order.
#pragma once

#include "renderer/paths/bodies.h"
#include "renderer/rays/ray.h"
#include "renderer/trace/tracer.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isl::render {

/// A face that a ray crosses at a contact.
struct CrossedFace {
  Hit hit;
  Vec3 forward{0};                                  ///< the face's normal, along the ray
  std::optional<std::uint32_t> entered_after = {};  ///< of a body that is left: how many were entered after it
};

/// The faces of `hits`, which are those of one ray, in the order in which they are crossed in the bodies of a list.
[[nodiscard]] std::vector<CrossedFace> in_order(std::span<const CoincidingHit> hits, const Tracer& tracer,
                                                const Bodies& bodies, std::uint32_t list, TraceCounters& counters);

/// The hits of the first ray of a list.
[[nodiscard]] std::span<const CoincidingHit> of_one_ray(std::span<const CoincidingHit> hits);

/// The number of a face of a contact; 0 is none.
using ContactFace = std::uint32_t;

/// The contacts of a batch of paths.
class Contacts {
 public:
  void clear() { faces_.resize(1); }
  [[nodiscard]] bool is_empty() const { return faces_.size() == 1; }

  /// Keeps the faces of a contact. The first of them.
  ContactFace add(std::span<const CrossedFace> faces);

  /// The hit of a segment of no length that ends at the face.
  [[nodiscard]] const Hit& hit_at(ContactFace face) const { return faces_[face].hit; }
  /// The face that is next for rays of a kind which go on from a face in some direction.
  [[nodiscard]] ContactFace next(ContactFace face, const Vec3& direction, RayKind kind, const Tracer& tracer) const;

 private:
  std::vector<CrossedFace> faces_{1};  ///< a miss stands before and behind those of each contact
};

/// The lists of a batch. Its paths hold indices into them.
struct PathLists {
  Bodies bodies;
  Contacts contacts;

  void clear() {
    bodies.clear();
    contacts.clear();
  }
};

}  // namespace isl::render
