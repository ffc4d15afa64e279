// x^y and eˣ with the same bits on every machine. The C library's pow picks its code by the processor it runs on (with
// or without fused multiply-add), and what it returns ends up in pixels; these use +, −, ×, ÷ only.
#pragma once

#include <span>

namespace isl::render {

/// x^y for x ≥ 0; relative error below 1e-14·(1 + |y log₂ x|/40). As with pow: x⁰ = 1 for every x, 0^y = 0 for y > 0,
/// and infinite for y < 0. A negative or NaN x gives NaN unless y is 0.
[[nodiscard]] double power(double x, double y) noexcept;

/// result[i] = power(x[i], y[i]), to the same bits. Several at a time take a third of the time, because none waits for
/// another. All spans have the same length.
void powers(std::span<const double> x, std::span<const double> y, std::span<double> result) noexcept;

/// eˣ; relative error below 1e-14·(1 + |x|/27).
[[nodiscard]] double exponential(double x) noexcept;

}  // namespace isl::render
