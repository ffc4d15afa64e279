// Paths from the eye into the scene: rays that wait to be traced together, and the state that each path has besides its
// ray. A ray holds only what the tracer needs; whatever an effect has to remember from one surface to the next is in
// PathEntry.
#pragma once

#include "renderer/rays/ray.h"
#include "renderer/shading/material.h"
#include "renderer/shading/spectrum.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isl::render {

/// A segment of a path. Light is linear along it, so every term adds factor × term to the path's sample.
struct PathEntry {
  Rgb factor{1};             ///< share of the light along the ray that reaches the eye; in the scene's working space
  double weight = 1;         ///< POV-Ray's estimate of that share; a path ends when it is below adc_bailout
  std::uint32_t sample = 0;  ///< the number, in the batch, of the camera sample whose colour it adds to
  std::uint16_t level = 1;   ///< segments of the path so far, this one included
  RayKind kind = RayKind::image;
  Wave wave{};               ///< white until dispersion parts the light
  std::uint32_t bodies = 0;  ///< the bodies that the segment runs in: a list of Bodies
  /// The face of a contact (contacts.h) where the segment ends; 0 if it ends elsewhere. It is known before the segment
  /// is traced if that has no length.
  std::uint32_t contact = 0;
  bool in_solid = false;  ///< the segment runs in something that is not `hollow`, which keeps media out
};

/// Segments of one kind that are traced together; hits[i] is where rays[i] ends.
struct PathBatch {
  std::vector<Ray> rays;
  std::vector<PathEntry> entries;
  std::vector<Hit> hits;

  [[nodiscard]] std::size_t size() const { return rays.size(); }
  void clear() {
    rays.clear();
    entries.clear();
    hits.clear();
  }
  void push(const Ray& ray, const PathEntry& entry) {
    rays.push_back(ray);
    entries.push_back(entry);
  }
};

/// Segments that wait for the next level, kept apart by kind, so that each batch is of one kind.
class ChildQueues {
 public:
  void push(const Ray& ray, const PathEntry& entry) { of(entry.kind).push(ray, entry); }
  [[nodiscard]] std::size_t size() const { return image_.size() + reflection_.size() + around_.size(); }
  void clear() {
    image_.clear();
    reflection_.clear();
    around_.clear();
  }
  /// Calls visit(batch) with the queue of each kind.
  template <class Visit>
  void for_each(Visit&& visit) const {
    visit(image_);
    visit(reflection_);
    visit(around_);
  }

 private:
  PathBatch& of(RayKind kind) {
    return kind == RayKind::reflection ? reflection_ : kind == RayKind::around ? around_ : image_;
  }

  PathBatch image_, reflection_, around_;
};

/// Paths that a limit ended.
struct EndedPaths {
  std::uint64_t by_level = 0;   ///< max_trace_level
  std::uint64_t by_weight = 0;  ///< adc_bailout
};

/// Numbers of rays traced, by their purpose.
struct PathCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t around = 0;            ///< for light from around, without those that go on as paths
  std::vector<std::uint64_t> spawned;  ///< by effect of the plan that spawns rays, in the plan's order
  EndedPaths ended;

  PathCounts& operator+=(const PathCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    around += other.around;
    spawned.resize(std::max(spawned.size(), other.spawned.size()));
    for (std::size_t i = 0; i < other.spawned.size(); ++i) spawned[i] += other.spawned[i];
    ended.by_level += other.ended.by_level;
    ended.by_weight += other.ended.by_weight;
    return *this;
  }
};

}  // namespace isl::render
