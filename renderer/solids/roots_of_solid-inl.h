// The crossings of eight lines with solids of order 3 and 4 (has_octet_roots).
#if defined(ISL_RENDERER_SOLIDS_ROOTS_OF_SOLID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLIDS_ROOTS_OF_SOLID_INL_H_
#undef ISL_RENDERER_SOLIDS_ROOTS_OF_SOLID_INL_H_
#else
#define ISL_RENDERER_SOLIDS_ROOTS_OF_SOLID_INL_H_
#endif

#include "renderer/solids/octet_polynomial-inl.h"
#include "renderer/solids/octet_torus-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

/// The first `most` crossings beyond t = 0. Those outside of the stretch may be left out, as in boundary(); `most` of
/// them lie within it.
[[nodiscard]] inline OctetRoots roots_of_solid(const scene::Solid& solid, const SolidDetails& details,
                                               const OctetLines& lines, const Octet& start_part,
                                               const OctetStretch& stretch, std::size_t most) {
  if (solid.kind == scene::SolidKind::torus) return OctetTorus(solid, lines, start_part, most).roots();
  const PreparedPolynomial& polynomial = details.polynomials[solid.detail];
  switch (polynomial.order) {
    case 3: return OctetPolynomial<3>(polynomial, lines, start_part, stretch, most).roots();
    case 4: return OctetPolynomial<4>(polynomial, lines, start_part, stretch, most).roots();
    default: {  // its leading terms are 0
      OctetRoots roots;
      roots.alone = all_lanes();
      return roots;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
