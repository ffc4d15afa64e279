// Bounds of fields over a box from Lipschitz constants, as LG-surfaces have them (Kalra and Barr 1989): the value in the box's
// middle, and how much less or more it may be at any place in it.
//
// With x = √q, q the skeleton's squared distance over squared radius, x is the least of distances over radii, each of which has
// the Lipschitz constant 1/radius: it has that of the thinnest sphere, times what a transform stretches, no more than the
// Frobenius norm of its inverse. And f = φ(v), v = scale · x², changes with √v by 2√v|φ′(v)|, of which 2√v_high |φ′(v_low)| is a
// bound, φ being convex and falling.
#pragma once

#include "renderer/fields/component_table.h"

namespace isl::render {

/// An enclosure of f_component over the box, in blob space; wider than field_range(), which it is for convolved components and
/// for a box without end.
/// {0, 0} where the support certainly does not reach the box.
[[nodiscard]] FieldRange lipschitz_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                                         const Box& box);

}  // namespace isl::render
