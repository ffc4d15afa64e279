// Visits the groups that a group is made of, from the inside out. A loop of a scene may nest thousands of groups
// (`#declare U = union { object { U } … }`), so every walk over groups keeps a list of its own: depth costs no stack.
#pragma once

#include "renderer/scene/edges.h"

#include <cstdint>
#include <type_traits>
#include <vector>

namespace isl::scene {

/// Calls finish(i) for the group `root` and every group that it refers to, directly or through others: children, clips
/// and bounds. A group comes after all that it refers to. Groups for which is_finished(i) holds are passed over;
/// finish(i) must make it hold.
template <class IsFinished, class Finish>
void finish_groups(const Database& database, std::uint32_t root, const IsFinished& is_finished, const Finish& finish) {
  std::vector<std::uint32_t> open{root};
  while (!open.empty()) {
    const std::uint32_t group = open.back();
    const std::size_t before = open.size();
    if (!is_finished(group)) {
      for (const Object& child : database.groups[group].children) {
        for_each_edge(child, [&]<class Id>(Id id) {
          if constexpr (std::is_same_v<Id, GroupId>) {
            if (id != kNoGroup && !is_finished(index(id))) open.push_back(index(id));
          }
        });
      }
    }
    if (open.size() > before) continue;  // the group is finished when the walk comes back to it
    if (!is_finished(group)) finish(group);
    open.pop_back();
  }
}

}  // namespace isl::scene
