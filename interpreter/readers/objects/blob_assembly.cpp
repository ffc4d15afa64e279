#include "interpreter/readers/objects/blob_assembly.h"

#include "interpreter/readers/textures/texture.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace isl::interpreter {
namespace {

using scene::Skeleton;

/// The scale factor of a map that can be baked into the component's record; 0 if it cannot.
double baked_factor(Skeleton skeleton, const scene::Transform& transform) {
  return has(skeleton, scene::kTakesSimilarities) ? similarity_factor(transform.matrix) : 0;
}

scene::Turn bake(scene::Component& component, const scene::Transform& transform, double factor) {
  component.a = transform.point(component.a);
  component.b = has_b(component.skeleton) ? transform.point(component.b) : scene::Vec3(0);
  component.radius_a *= factor;
  component.radius_b *= factor;
  return scene::turn_of(transform.matrix);
}

scene::TransformId add_transform(Context& context, const scene::Transform& transform) {
  context.database.transforms.push_back(transform);
  return scene::TransformId{static_cast<std::uint32_t>(context.database.transforms.size() - 1)};
}

}  // namespace

scene::Turn move(Context& context, scene::Component& component, const scene::Transform& blob_from_component) {
  if (const double factor = baked_factor(component.skeleton, blob_from_component); factor > 0) {
    return bake(component, blob_from_component, factor);
  }
  component.transform = add_transform(context, blob_from_component);
  return {};
}

void BlobAssembly::add(const scene::Component& component, OriginId origin, std::uint32_t branch,
                       const scene::Turn* turn) {
  const bool is_turned = turn && !turn->is_none();
  if (blob_.turns.empty() && is_turned) blob_.turns.resize(blob_.components.size());
  blob_.components.push_back(component);
  blob_.origins.push_back(origin);
  if (!blob_.branches.empty()) blob_.branch_of.push_back(branch);
  if (is_turned || !blob_.turns.empty()) blob_.turns.push_back(turn ? *turn : scene::Turn());
}

std::uint32_t BlobAssembly::add_branch(std::optional<std::uint32_t> maximum) {
  if (blob_.branches.empty()) {
    blob_.branches.push_back({kOwnSum, kOwnSum});
    for (std::size_t i = 0; i < blob_.components.size(); ++i) blob_.branch_of.push_back(kOwnSum);
  }
  const auto branch = static_cast<std::uint32_t>(blob_.branches.size());
  blob_.branches.push_back({kOwnSum, maximum.value_or(branch)});
  return branch;
}

void BlobAssembly::take_copy(scene::Blob part, const Placement& placement, SourceSpan span) {
  for (std::size_t i = 0; i < part.components.size(); ++i)
    context_.count_primitive(span, sizeof(scene::Component) + sizeof(OriginId));
  BlobAssembly assembly(context_);
  assembly.threshold_ = part.threshold;
  assembly.blob_ = std::move(part);
  take_over(std::move(assembly), placement);
}

void BlobAssembly::take_over(BlobAssembly part, const Placement& placement) {
  const std::size_t first = blob_.components.size();
  const auto first_corner = static_cast<std::uint32_t>(blob_.corners.size());
  for (const scene::Vec3& corner : part.blob_.corners) blob_.corners.push_back(corner);

  // The part's own sum becomes the branch that the part is added to; its other branches are appended to the present
  // ones.
  if (!part.blob_.branches.empty() && blob_.branches.empty()) {
    blob_.branches.push_back({kOwnSum, kOwnSum});
    for (std::size_t i = 0; i < first; ++i) blob_.branch_of.push_back(kOwnSum);
  }
  const auto shift = static_cast<std::uint32_t>(blob_.branches.size()) - 1;
  const auto renumbered = [&](std::uint32_t branch) { return branch == kOwnSum ? placement.branch : branch + shift; };
  for (std::size_t b = 1; b < part.blob_.branches.size(); ++b) {
    const scene::Branch& branch = part.blob_.branches[b];
    blob_.branches.push_back({renumbered(branch.parent), branch.maximum + shift});
  }

  const bool is_moved = placement.blob_from_part.matrix != scene::Matrix();
  scene::TextureId texture = scene::kNoTexture;
  if (placement.texture) {
    texture = texture_id(context_, moved(context_, *placement.texture, placement.blob_from_part));
  }
  std::unordered_map<std::uint32_t, scene::TextureId> moved_textures;
  std::unordered_map<std::uint32_t, scene::TransformId> moved_transforms;
  for (std::size_t i = 0; i < part.blob_.components.size(); ++i) {
    scene::Component component = part.blob_.components[i];
    if (has(component.skeleton, scene::kCorner)) component.corner += first_corner;
    if (component.texture == scene::kNoTexture) {
      component.texture = texture;
    } else if (is_moved) {
      const auto [place, is_new] = moved_textures.try_emplace(scene::index(component.texture));
      if (is_new) {
        const scene::Texture own = context_.database.texture(component.texture);
        place->second = texture_id(context_, moved(context_, own, placement.blob_from_part));
      }
      component.texture = place->second;
    }
    scene::Turn turn = part.blob_.turns.empty() ? scene::Turn() : part.blob_.turns[i];
    if (is_moved) turn = then(turn, move(component, placement.blob_from_part, moved_transforms));
    add(component, part.blob_.origins[i], renumbered(part.blob_.branches.empty() ? kOwnSum : part.blob_.branch_of[i]),
        &turn);
  }

  if (part.threshold_) {
    parts_.push_back({first, blob_.components.size(), *part.threshold_});
  } else {
    for (const ThresholdOfPart& inner : part.parts_)
      parts_.push_back({inner.begin + first, inner.end + first, inner.threshold});
  }
}

scene::Turn BlobAssembly::move(scene::Component& component, const scene::Transform& blob_from_part,
                               std::unordered_map<std::uint32_t, scene::TransformId>& moved) {
  if (component.transform == scene::kIdentity) {
    if (const double factor = baked_factor(component.skeleton, blob_from_part); factor > 0) {
      return bake(component, blob_from_part, factor);
    }
  }
  const auto [place, is_new] = moved.try_emplace(scene::index(component.transform));
  if (is_new) {
    const bool has_own = component.transform != scene::kIdentity;
    const scene::Transform own =
        has_own ? context_.database.transforms[scene::index(component.transform)] : scene::Transform();
    place->second = add_transform(context_, scene::then(own, blob_from_part));
  }
  component.transform = place->second;
  return {};
}

void BlobAssembly::multiply_strengths(const ThresholdOfPart& part, double threshold) {
  if (part.threshold == threshold) return;
  for (std::size_t i = part.begin; i < part.end; ++i) blob_.components[i].strength *= threshold / part.threshold;
}

void BlobAssembly::set_threshold(std::optional<double> threshold) {
  threshold_ = threshold;
  if (!threshold) return;
  for (const ThresholdOfPart& part : parts_) multiply_strengths(part, *threshold);
  parts_.clear();
}

void BlobAssembly::change_signs() {
  threshold_ = -*threshold_;
  for (scene::Component& component : blob_.components) component.strength = -component.strength;
}

void BlobAssembly::check_choices(SourceSpan span) const {
  // The number of choices: for a sum, the product over its maxima; for a maximum, the sum over its branches. Children
  // have greater numbers.
  constexpr double kMostChoices = 4096;
  std::vector<double> of_branch(blob_.branches.size(), 1), of_maximum(blob_.branches.size(), 0);
  for (std::size_t b = blob_.branches.size(); b-- > 1;) {
    const scene::Branch& branch = blob_.branches[b];
    of_maximum[branch.maximum] += of_branch[b];
    if (branch.maximum == b) of_branch[branch.parent] *= of_maximum[b];
  }
  if (of_branch.empty() || of_branch[0] <= kMostChoices) return;
  context_.fail(span, fmt::format("the unions in this blob have more than {:g} combinations", kMostChoices),
                "put components that belong together into one `union`");
}

scene::Blob BlobAssembly::take() {
  if (!threshold_) set_threshold(1);
  blob_.threshold = *threshold_;
  return std::move(blob_);
}

}  // namespace isl::interpreter
