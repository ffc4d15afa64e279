// A blob in the making: components, the parts that `blob` and `union` inside it contribute, and the branches of its
// maxima (scene::Branch). Parts are dissolved: only the place and the look of their components remain.
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

  /// `turn`: the rotation that was baked into the component, null if it was not moved.
  void add(const scene::Component& component, OriginId origin, std::uint32_t branch, const scene::Turn* turn = nullptr);
  /// Adds a branch to a new maximum of the blob's own sum, or to an existing one (`maximum`: its first branch).
  std::uint32_t add_branch(std::optional<std::uint32_t> maximum);

  /// The place of a part in the blob.
  struct Placement {
    scene::Transform blob_from_part;
    std::optional<scene::Texture> texture;  ///< for components without one; in the part's space
    std::uint32_t branch = kOwnSum;
  };
  void take_over(BlobAssembly part, const Placement& placement);
  /// Takes over a blob that is already in the database. Its components count against the scene's limits.
  void take_copy(scene::Blob part, const Placement& placement, SourceSpan span);

  /// Sets the blob's threshold. A part keeps the surface that it has alone under its own threshold: its strengths are
  /// multiplied by the blob's threshold over the part's. A part without a threshold has the blob's.
  void set_threshold(std::optional<double> threshold);
  /// The threshold; 1 if none was set.
  [[nodiscard]] double threshold() const { return threshold_.value_or(1); }
  /// Changes the signs of the threshold and of all strengths. Precondition: the threshold is set.
  void change_signs();
  [[nodiscard]] bool has_maxima() const { return !blob_.branches.empty(); }

  /// Fails if the maxima have more combinations of branches than the renderer can process.
  void check_choices(SourceSpan span) const;

  /// The finished blob, with its threshold; 1 if none was set.
  [[nodiscard]] scene::Blob take();

 private:
  struct ThresholdOfPart {
    std::size_t begin, end;  ///< components
    double threshold;
  };
  void multiply_strengths(const ThresholdOfPart& part, double threshold);
  /// Returns the rotation that was baked into the component.
  scene::Turn move(scene::Component& component, const scene::Transform& blob_from_part,
                   std::unordered_map<std::uint32_t, scene::TransformId>& moved);

  Context& context_;
  scene::Blob blob_;
  std::optional<double> threshold_;
  std::vector<ThresholdOfPart> parts_;  ///< parts whose strengths wait for the blob's threshold
};

/// Moves a component. A similarity moves the record of a skeleton that takes similarities; any other map, and that of
/// any other skeleton, is stored beside it. Returns the rotation that was baked into the component.
scene::Turn move(Context& context, scene::Component& component, const scene::Transform& blob_from_component);

}  // namespace isl::interpreter
