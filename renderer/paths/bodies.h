// The bodies that paths run in, such as water with a bubble. A path has entered them in their order, and leaves them in
// any.
#pragma once

#include "renderer/rays/surface_point.h"
#include "renderer/scene/ids.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isl::render {

struct Body {
  BodyId id;
  scene::InteriorId interior;
  bool is_hollow;
};

/// The lists of a batch of paths. A list is a number and is never changed: lists that begin with the same bodies share
/// them. 0 is the empty list.
class Bodies {
 public:
  void clear() { nodes_.resize(1); }

  /// The body that was entered last; null for the empty list.
  [[nodiscard]] const Body* last(std::uint32_t list) const { return list == 0 ? nullptr : &nodes_[list].body; }

  [[nodiscard]] std::uint32_t entered(std::uint32_t list, const Body& body) {
    nodes_.push_back({body, list});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  /// The list without the last of the entries that are this body; nothing if there is none.
  [[nodiscard]] std::optional<std::uint32_t> left(std::uint32_t list, const BodyId& body) {
    if (list == 0) return std::nullopt;
    const Node node = nodes_[list];
    if (node.body.id == body) return node.below;
    const std::optional<std::uint32_t> below = left(node.below, body);
    return below ? std::optional(entered(*below, node.body)) : std::nullopt;
  }
  /// The number of bodies that were entered after this one; nothing if the list does not hold it.
  [[nodiscard]] std::optional<std::uint32_t> entered_after(std::uint32_t list, const BodyId& body) const {
    for (std::uint32_t number = 0; list != 0; list = nodes_[list].below, ++number) {
      if (nodes_[list].body.id == body) return number;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool holds(std::uint32_t list, const BodyId& body) const {
    return entered_after(list, body).has_value();
  }
  [[nodiscard]] bool all_are_hollow(std::uint32_t list) const {
    for (; list != 0; list = nodes_[list].below) {
      if (!nodes_[list].body.is_hollow) return false;
    }
    return true;
  }

 private:
  struct Node {
    Body body;
    std::uint32_t below;  ///< the rest of the list
  };
  std::vector<Node> nodes_{1};
};

}  // namespace isl::render
