#include "renderer/reference/reference_convolution.h"

#include "base/check.h"
#include "renderer/reference/reference_curves.h"

#include <algorithm>

namespace isl::ISL_REFERENCE {
namespace {

Interval around(Real x, Real error) { return {x - error, x + error}; }

Real least_at(Real distance) { return distance > 0 ? distance * distance : 0; }

}  // namespace

ReferenceConvolution::ReferenceConvolution(const scene::Component& component, const scene::Kernel& kernel)
    : window_(kernel), unit_(1 / (component.radius_a * sqrt(window_.border()))) {
  ISL_CHECK(component.skeleton == scene::Skeleton::segment || component.skeleton == scene::Skeleton::circle,
            "skeleton {}", static_cast<int>(component.skeleton));
  curve_ =
      component.skeleton == scene::Skeleton::segment ? segment_curve(component, unit_) : circle_curve(component, unit_);
}

/// The ball around a box. The box's rounding, and that of all distances from it, is part of it.
ReferenceConvolution::Ball ReferenceConvolution::ball_of(const Vector<Interval>& p) const {
  const Vector<Real> middle{p.x.middle() * unit_, p.y.middle() * unit_, p.z.middle() * unit_};
  const Vector<Real> half{p.x.width() / 2, p.y.width() / 2, p.z.width() / 2};
  const Real size = sqrt(squared_length(middle)) + 1;
  return {middle, sqrt(squared_length(half)) * unit_ * kWindowMargin + size * (16 * kRoundoff)};
}

ReferenceConvolution::Sample ReferenceConvolution::at(const Vector<Interval>& p) const {
  const Ball ball = ball_of(p);
  const Real distance = curve_->distance(ball.centre);
  if (distance - ball.radius >= 1) return {};
  const ReferenceWindow::View view = curve_->view(ball.centre, ball.radius, least_at(distance - ball.radius));
  const Real slope = window_.most_slope(view), bend = window_.most_bend(view), amplitude = window_.amplitude();
  Curve::Integrals sum{};
  if (distance < 1) sum = curve_->integrals(ball.centre, window_);
  const Real value_error = slope * ball.radius + sum.fall * kPlaceRounding + sum.value * kIntegralRounding;
  const Real gradient_error = bend * ball.radius + slope * kIntegralRounding;
  const auto component = [&](Real g) { return Interval(amplitude * unit_) * around(g, gradient_error); };
  Interval value = Interval(amplitude) * around(sum.value, value_error);
  value.lo = std::max(value.lo, Real(0));
  return {
      value, {component(sum.gradient.x), component(sum.gradient.y), component(sum.gradient.z)}, amplitude * sum.fall};
}

FieldRange ReferenceConvolution::at(const Line& line, Real t) const {
  const Sample here = at(line.at(t));
  return {here.value, dot(here.gradient, line.direction)};
}

FieldRange ReferenceConvolution::over(const Line& line, Real t0, Real t1, const FieldRange& first,
                                      const FieldRange& last) const {
  Ball ball = ball_of(line.at(t0 + (t1 - t0) / 2));
  const Vector<Real> along{line.direction.x.magnitude(), line.direction.y.magnitude(), line.direction.z.magnitude()};
  const Real speed = sqrt(squared_length(along)) * unit_ * kWindowMargin, h = (t1 - t0) * kWindowMargin;
  ball.radius += speed * h / 2 * kWindowMargin;
  const Real distance = curve_->distance(ball.centre) - ball.radius;
  if (distance >= 1) return {0, 0};
  const ReferenceWindow::View view = curve_->view(ball.centre, ball.radius, least_at(distance));
  const Real amplitude = window_.amplitude() * kWindowMargin;
  const Real slope = amplitude * speed * window_.most_slope(view);
  // f′ cannot be higher than the point where lines of the steepest bend from both ends meet.
  const Real turn = amplitude * speed * speed * window_.most_bend(view) * h / 2 * kWindowMargin;
  const Interval &a = first.derivative, &b = last.derivative;
  const Interval derivative = common({-slope, slope}, widened((a.lo + b.lo) / 2 - turn, (a.hi + b.hi) / 2 + turn));
  const Interval step(0, h);
  Interval value = common({0, amplitude * window_.most(view)}, first.value + derivative * step);
  value = common(value, last.value - derivative * step);
  return {value, derivative};
}

Interval ReferenceConvolution::range(const Vector<Interval>& box) const {
  const Ball ball = ball_of(box);
  const Real distance = curve_->distance(ball.centre) - ball.radius;
  if (distance >= 1) return 0;
  const ReferenceWindow::View view = curve_->view(ball.centre, ball.radius, least_at(distance));
  const Vector<Interval> middle{box.x.middle(), box.y.middle(), box.z.middle()};
  const Real change = window_.amplitude() * window_.most_slope(view) * ball.radius * kWindowMargin;
  return common({0, window_.amplitude() * window_.most(view) * kWindowMargin},
                at(middle).value + Interval(-change, change));
}

}  // namespace isl::ISL_REFERENCE
