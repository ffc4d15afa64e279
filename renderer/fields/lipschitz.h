// Bounds of fields over a box from Lipschitz constants, as in LG-surfaces (Kalra and Barr 1989): the value at the box's
// centre, plus and minus the greatest change within the box.
//
// Let x = √q, q the skeleton's squared distance over squared radius. x is the least of quotients distance/radius, each
// of which has the Lipschitz constant 1/radius. So x has the constant of the thinnest sphere, times the greatest
// stretch of the map into the component's space, which is at most the Frobenius norm of the transform's inverse. The
// derivative of f = φ(v), v = scale · x², by √v is 2√v φ′(v). Its size is at most 2√v_high |φ′(v_low)|, since φ is
// convex and falls.
#pragma once

#include "renderer/fields/component_table.h"

namespace isl::render {

/// An enclosure of the component's field over the box, in the blob's space; {0, 0} if the support certainly does not
/// reach the box. It is wider than field_range(), except for convolved components and infinite boxes, where it returns
/// field_range().
[[nodiscard]] FieldRange lipschitz_range(const ComponentTable& table, const FieldGroup& group, std::uint32_t component,
                                         const Box& box);

}  // namespace isl::render
