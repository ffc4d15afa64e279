// Escape-time fractals in the plane of x and y: Mandelbrot and Julia sets of any power, and the magnets (Peitgen,
// Richter, "The Beauty of Fractals", 1986).
#pragma once

#include "renderer/scene/pattern.h"

namespace isl::render {

[[nodiscard]] double fractal(const scene::Vec3& p, const scene::FractalOperands& operands) noexcept;

}  // namespace isl::render
