#include "renderer/csg/expansion.h"

#include <algorithm>

namespace isl::render {

using scene::Group;
using scene::Object;

bool needs_csg(const scene::Database& database, const Object& object, bool is_inverse) {
  if (object.clip != scene::kNoGroup) return true;
  if (object.kind != Object::Kind::group) return false;
  const Group& group = database.groups[object.shape];
  // A group with one child is that child, whatever its operation.
  if (group.children.size() <= 1) return false;
  return group.operation != scene::Operation::unite || is_inverse != object.inverse;
}

/// A group may be counted once the groups that it holds are. A list of those that wait takes the place of recursion, so
/// that depth costs no stack.
Expansion::Expansion(const scene::Database& database)
    : database_(database), is_nothing_(database.groups.size()), trees_(database.groups.size()) {
  for (auto* const counts : {&instances_, &visits_}) {
    for (std::vector<double>& of_groups : *counts) of_groups.resize(database.groups.size());
  }
  std::vector<std::uint32_t> waiting;
  const auto wait_for = [&](std::uint32_t group) {
    if (!trees_[group]) waiting.push_back(group);
  };
  for (std::uint32_t group = 0; group < database.groups.size(); ++group) {
    wait_for(group);
    while (!waiting.empty()) {
      const std::uint32_t next = waiting.back();
      if (trees_[next]) {  // it waited for several groups
        waiting.pop_back();
        continue;
      }
      const std::size_t before = waiting.size();
      for (const Object& child : database.groups[next].children) {
        if (child.kind == Object::Kind::group) wait_for(child.shape);
        if (child.clip != scene::kNoGroup) wait_for(index(child.clip));
      }
      if (waiting.size() > before) continue;
      waiting.pop_back();
      count(next);
    }
  }
}

void Expansion::count(std::uint32_t group) {
  const std::vector<Object>& children = database_.groups[group].children;
  Size tree{1, 0};
  is_nothing_[group] = std::ranges::all_of(children, [this](const Object& child) {
    return child.kind == Object::Kind::group && !child.inverse && is_nothing_[child.shape];
  });
  for (const Object& child : children) {
    if (is_nothing_[group]) break;
    tree += tree_of(child);
    for (const bool is_inverse : {false, true}) {
      instances_[is_inverse][group] += instances(child, is_inverse);
      visits_[is_inverse][group] += visits(child, is_inverse);
    }
  }
  trees_[group] = tree;
}

double Expansion::instances(const Object& object, bool is_inverse) const {
  if (object.kind != Object::Kind::group) return 1;
  if (is_nothing_[object.shape]) return 0;  // turned inside out it is everything, which has no surface either
  if (needs_csg(database_, object, is_inverse)) return 1;
  return instances_[is_inverse != object.inverse][object.shape];
}

double Expansion::visits(const Object& object, bool is_inverse) const {
  const bool is_opened = object.kind == Object::Kind::group && instances(object, is_inverse) != 0 &&
                         !needs_csg(database_, object, is_inverse);
  return is_opened ? 1 + visits_[is_inverse != object.inverse][object.shape] : 1;
}

Expansion::Size Expansion::tree_of(const Object& object) const {
  Size size = object.kind == Object::Kind::group ? *trees_[object.shape] : Size{0, 1};
  if (object.clip != scene::kNoGroup) {
    size += *trees_[index(object.clip)];
    size.groups += 1;
  }
  return size;
}

}  // namespace isl::render
