// A blob in the making: components, the parts that `blob` and `union` inside it bring along, and the branches of its maxima
// (scene::Branch). Parts are taken over as they stand, so that nothing of them is left but where they are and how they look.
#pragma once

#include "interpreter/context.h"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace isl::interpreter {

/// The blob's own sum, as a branch.
inline constexpr std::uint32_t kOwnSum = 0;

class BlobAssembly {
 public:
  explicit BlobAssembly(Context& context) : context_(context) {}

  [[nodiscard]] scene::Blob& blob() { return blob_; }

  /// `turn`: what was baked into the component, null where it was not moved.
  void add(const scene::Component& component, OriginId origin, std::uint32_t branch, const scene::Turn* turn = nullptr);
  /// A branch of a new maximum of the blob's own sum, or (`maximum`: its first branch) of one that is there.
  std::uint32_t add_branch(std::optional<std::uint32_t> maximum);

  /// How a part stands in the blob.
  struct Placement {
    scene::Transform blob_from_part;
    std::optional<scene::Texture> texture;  ///< of its components without one; in the part's space
    std::uint32_t branch = kOwnSum;
  };
  void take_over(BlobAssembly part, const Placement& placement);
  /// The same of a blob that stands in the database. Its components count against the scene's limits.
  void take_copy(scene::Blob part, const Placement& placement, SourceSpan span);

  /// The threshold that was said. A part keeps the surface that it has alone under its own threshold: its strengths are
  /// multiplied by the blob's threshold over the part's. Without a threshold of its own a part has the blob's.
  void set_threshold(std::optional<double> threshold);

  /// Fails if the maxima can be chosen from in more ways than the renderer takes apart.
  void check_choices(SourceSpan span) const;

  /// With the threshold settled; 1 unless said otherwise.
  [[nodiscard]] scene::Blob take();

 private:
  struct ThresholdOfPart {
    std::size_t begin, end;  ///< components
    double threshold;
  };
  void multiply_strengths(const ThresholdOfPart& part, double threshold);
  /// Returns the turn that was baked into the component.
  scene::Turn move(scene::Component& component, const scene::Transform& blob_from_part,
                   std::unordered_map<std::uint32_t, scene::TransformId>& moved);

  Context& context_;
  scene::Blob blob_;
  std::optional<double> threshold_;
  std::vector<ThresholdOfPart> parts_;  ///< whose strengths wait for the blob's threshold
};

/// Moves a component. A similarity keeps a point, segment or cone what it is; any other map, and of any other skeleton,
/// stays beside it. Returns the turn that was baked into the component.
scene::Turn move(Context& context, scene::Component& component, const scene::Transform& blob_from_component);

}  // namespace isl::interpreter
