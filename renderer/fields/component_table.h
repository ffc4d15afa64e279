// A blob's components made ready for evaluation: sorted into groups of one form and one kernel, in a canonical order (Morton
// code, then parameters) so that neither the order in which a scene names them nor the number of threads decides a bit of any
// sum. Everything is in the blob's own space. Made once a blob; read by grid, solvers and shading.
#pragma once

#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/fields/skeletons/limb.h"
#include "renderer/scene/database.h"

#include <ImathBox.h>

#include <cstdint>
#include <vector>

namespace isl::render {

using Box = Imath::Box3d;

/// What decides the code that evaluates a component. `affine`: its transform is no similarity and stays a map of its own.
enum class FieldForm : std::uint8_t { point, limb, affine_point, affine_limb };

/// Components begin … end − 1 share form and kernel.
struct FieldGroup {
  FieldForm form;
  KernelConstants kernel;
  std::uint32_t begin, end;
};

struct ComponentTable {
  double threshold = 1;
  std::vector<FieldGroup> groups;
  // One row a component.
  std::vector<double> x, y, z;      ///< centre of a point; end a of a limb; in component space for affine forms
  std::vector<double> scale;        ///< of a point: v = scale · distance²; of a limb: v = scale · q
  std::vector<double> amplitude;    ///< strength times the kernel's
  std::vector<scene::TextureId> texture;
  std::vector<std::uint32_t> source;  ///< index into scene::Blob::components
  // Limbs and affine maps lie apart: one row a component from first_limb, first_affine on (they need more than points do).
  std::uint32_t first_limb = 0, first_affine = 0;
  std::vector<Limb> limbs;
  std::vector<scene::Transform> blob_from_component;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(x.size()); }
  [[nodiscard]] const FieldGroup& group_of(std::uint32_t component) const;
  [[nodiscard]] std::size_t bytes() const;
};

/// `database` resolves kernels and transforms. Components of strength 0 are left out: they add nothing.
[[nodiscard]] ComponentTable compile_components(const scene::Database& database, const scene::Blob& blob);

/// Range of a field over a box: least and greatest value.
struct FieldRange {
  double low, high;
};

/// An enclosure of f_component over the box, tight for points; {0, 0} exactly when the support does not reach it.
[[nodiscard]] FieldRange field_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component, const Box& box);

/// A box around the component's support.
[[nodiscard]] Box support_bounds(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

/// Radius of the largest sphere of the skeleton times the root of the support's q: how far the field reaches from its skeleton.
[[nodiscard]] double support_radius(const ComponentTable& table, const FieldGroup& group, std::uint32_t component);

}  // namespace isl::render
