// Kernels that are polynomials of q or, in the metaball's shell, of √q. With the hardness h, φ′(1) = −h sets Q.
#include "renderer/reference/kernel_profiles.h"

namespace isl::ISL_REFERENCE {

/// φ = d², d = 1 + (h/2)(1 − q), Q − 1 = 2/h. POV-Ray's own component: φ = (1 − q)².
ProfileInUse quartic_profile(const scene::Kernel& kernel) {
  if (kernel.meaning == scene::RadiusMeaning::support)
    return {[](const Jet& q) { return positive_square(Interval(1) - q); }, 1};
  const Interval fall = Interval(kernel.hardness) * Interval(0.5L);
  return {[=](const Jet& q) { return positive_square(depth_at(q, fall)); }, Interval(1) + Interval(1) / fall};
}

/// φ = d³, d = 1 + (h/3)(1 − q): also the kernel of a plane convolved with (1 − v)².
ProfileInUse cubic_profile(const scene::Kernel& kernel) {
  const Interval fall = Interval(kernel.hardness) / Interval(3);
  const auto profile = [=](const Jet& q) {
    const Jet depth = depth_at(q, fall);
    const Interval d = positive_part(depth.value);
    return chain(d * square(d), Interval(3) * square(d), Interval(6) * d, depth);
  };
  return {profile, Interval(1) + Interval(1) / fall};
}

/// φ = a(1 − v)²(1 − 4v/9) with v = q/Q. With y = 1 − v it is a·y²(5 + 4y)/9, and −vφ′/φ = 2v(5 + 6y)/(y(5 + 4y)) is h
/// at q = 1. There y solves ay² + by − 10 = 0, and v solves av² − cv + 9h = 0. The roots are written so that nothing
/// cancels, with the discriminant that both have.
ProfileInUse soft_profile(const scene::Kernel& kernel) {
  const Interval h(kernel.hardness), a = Interval(12) + Interval(4) * h, b = Interval(5) * h - Interval(2);
  const Interval root = square_root(square(b) + Interval(40) * a);
  const Interval y = b.sign() > 0 ? Interval(20) / (b + root) : (root - b) / (Interval(2) * a);
  const Interval support = (Interval(13) * h + Interval(22) + root) / (Interval(18) * h);
  const Interval fall = Interval(1) / (y * support), at_one = Interval(5) + Interval(4) * y;
  // depth_at is y over its value at q = 1.
  const Interval scale = Interval(1) / at_one, slant = Interval(4) * y;
  const auto profile = [=](const Jet& q) {
    const Jet depth = depth_at(q, fall);
    return positive_square(depth) * ((depth * slant + Interval(5)) * scale);
  };
  return {profile, support};
}

/// Nishimura's kernel: 1 − 3v up to v = 1/9 and then (3/2)(1 − √v)², times a. With ρ = √v at q = 1: in the shell
/// −vφ′/φ = ρ/(1 − ρ) = h; in the core, for h < 1/2, 3v/(1 − 3v) = h.
ProfileInUse metaball_profile(const scene::Kernel& kernel) {
  const Interval h(kernel.hardness), above = Interval(1) + h;
  const bool is_in_shell = kernel.hardness >= 0.5;
  const Interval rho = is_in_shell ? h / above : square_root(h / (Interval(3) * above));
  const Interval v = square(rho), to_border = is_in_shell ? Interval(1) / above : Interval(1) - rho;
  const Interval a = is_in_shell ? Interval(2) / (Interval(3) * square(to_border)) : above;
  const Interval support = Interval(1) / v, junction = support / Interval(9);
  const auto core = [=](const Jet& q) { return (Interval(1) - q * (Interval(3) * v)) * a; };
  const auto shell = [=](const Jet& q) {
    // 1 − √v = (1 − ρ) + ρ(1 − √q), where 1 − √q = (1 − q)/(1 + √q).
    const Jet root = square_root(q);
    const Jet depth = (Interval(1) - q) * inverse(root + Interval(1)) * rho + to_border;
    return positive_square(depth) * (Interval(1.5L) * a);
  };
  const auto profile = [=](const Jet& q) {
    const Interval from_junction = q.value - junction;
    if (from_junction.sign() < 0) return core(q);
    return from_junction.sign() > 0 ? shell(q) : hull(core(q), shell(q));
  };
  return {profile, support, junction};
}

}  // namespace isl::ISL_REFERENCE
