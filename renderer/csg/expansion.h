// How many parts an object has when it is placed: groups hold groups, so sixty unions of two make 10¹⁸ objects out of a
// few lines. Each group is counted once, so that the count is known before anything is expanded.
#pragma once

#include "renderer/scene/database.h"

#include <array>
#include <optional>
#include <vector>

namespace isl::render {

/// True if an object is more than its parts side by side: combined by an operation, clipped, or a union turned inside
/// out. `is_inverse`: the object's parent is inverse.
[[nodiscard]] bool needs_csg(const scene::Database& database, const scene::Object& object, bool is_inverse);

/// Counts the parts of the objects of a database, which does not change meanwhile. Numbers are doubles, because no
/// integer holds them.
class Expansion {
 public:
  explicit Expansion(const scene::Database& database);

  /// True for a group that is the empty set because nothing is in it but such groups. It need not be expanded.
  [[nodiscard]] bool is_nothing(std::uint32_t group) const { return is_nothing_[group]; }

  /// The number of instances that a placed object becomes: none if there is no surface in it. `is_inverse`: the
  /// object's parent is inverse.
  [[nodiscard]] double instances(const scene::Object& object, bool is_inverse) const;

  /// The number of objects that are visited to place it, groups included: a long chain of unions around one object is
  /// one instance.
  [[nodiscard]] double visits(const scene::Object& object, bool is_inverse) const;

  /// At most the nodes and leaves of a CSG tree.
  struct Size {
    double groups = 0, leaves = 0;

    Size& operator+=(const Size& other) {
      groups += other.groups;
      leaves += other.leaves;
      return *this;
    }
  };
  /// The size of the object's CSG tree.
  [[nodiscard]] Size tree_of(const scene::Object& object) const;

 private:
  void count(std::uint32_t group);

  const scene::Database& database_;
  std::vector<bool> is_nothing_;                  ///< by group
  std::vector<std::optional<Size>> trees_;        ///< by group, with its own node
  std::array<std::vector<double>, 2> instances_;  ///< of a union's children, by group: upright and inverse
  std::array<std::vector<double>, 2> visits_;     ///< likewise
};

}  // namespace isl::render
