// Every implementation is tested for every property with every field of the list, and every property with a field that
// violates it.
#include "tests/conformance/properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <tuple>

namespace isl::conformance {
namespace {

class Conformance : public testing::TestWithParam<std::tuple<Implementation, Property>> {};

TEST_P(Conformance, Holds) {
  const auto& [implementation, property] = GetParam();
  int violations = 0;
  for (const FieldCase& field : field_cases()) {
    const std::string found = property.violation(implementation.make(field), field);
    if (found.empty()) continue;
    if (++violations <= 10) ADD_FAILURE() << field.name << ": " << found;
  }
  EXPECT_EQ(violations, 0) << "of " << field_cases().size() << " fields";
}

INSTANTIATE_TEST_SUITE_P(Fields, Conformance,
                         testing::Combine(testing::ValuesIn(implementations()), testing::ValuesIn(properties())),
                         [](const auto& given) {
                           return std::get<0>(given.param).name + "_" + std::get<1>(given.param).name;
                         });

/// A way to break a correct field, and the property that must notice.
struct Sabotage {
  const char* property;
  FieldUnderTest (*broken)(FieldUnderTest);
};

FieldUnderTest off_in_the_eleventh_digit(FieldUnderTest field) {
  field.value = [value = field.value](const Vec3& p) { return value(p) * (1 + 1e-10); };
  return field;
}
FieldUnderTest gradient_off_in_the_ninth_digit(FieldUnderTest field) {
  field.gradient = [gradient = field.gradient](const Vec3& p) { return gradient(p) * (1 + 1e-8); };
  return field;
}
FieldUnderTest gradient_with_a_wrong_sign(FieldUnderTest field) {
  field.gradient = [gradient = field.gradient](const Vec3& p) {
    const Vec3 g = gradient(p);
    return Vec3(g.x, g.y, -g.z);
  };
  return field;
}
FieldUnderTest a_little_softer(FieldUnderTest field) {
  field.gradient = [gradient = field.gradient](const Vec3& p) { return gradient(p) * 0.999; };
  return field;
}
FieldUnderTest nowhere_zero(FieldUnderTest field) {
  field.value = [value = field.value](const Vec3& p) { return value(p) + 1e-12; };
  return field;
}
FieldUnderTest derivative_along_a_unit_direction(FieldUnderTest field) {
  field.along_ray = [along = field.along_ray](const Vec3& origin, const Vec3& direction, double t) {
    ValueAndDerivative here = along(origin, direction, t);
    here.derivative /= direction.length();
    return here;
  };
  return field;
}
FieldUnderTest cut_off_without_a_window(FieldUnderTest field) {
  field.along_ray = [along = field.along_ray](const Vec3& origin, const Vec3& direction, double t) {
    ValueAndDerivative here = along(origin, direction, t);
    if (here.value != 0) here.value += 1e-3;
    return here;
  };
  return field;
}
FieldUnderTest bounded_from_its_corners(FieldUnderTest field) {
  field.range_over_box = [value = field.value](const Vec3& low, const Vec3& high) {
    return ValueRange{std::min(value(low), value(high)), std::max(value(low), value(high))};
  };
  return field;
}
FieldUnderTest bounded_by_everything(FieldUnderTest field) {
  field.range_over_box = [](const Vec3&, const Vec3&) { return ValueRange{-1e300, 1e300}; };
  return field;
}
FieldUnderTest ranging_over_the_first_half(FieldUnderTest field) {
  field.range_along_ray = [range = field.range_along_ray](const Vec3& origin, const Vec3& direction, double t0,
                                                          double t1) {
    return range(origin, direction, t0, 0.5 * (t0 + t1));
  };
  return field;
}
FieldUnderTest sloping_as_in_the_middle(FieldUnderTest field) {
  field.slope_range_along_ray = [range = field.slope_range_along_ray](const Vec3& origin, const Vec3& direction,
                                                                      double t0, double t1) {
    const double middle = 0.5 * (t0 + t1);
    return range(origin, direction, middle, middle);
  };
  return field;
}
FieldUnderTest sure_to_be_straight(FieldUnderTest field) {
  field.bend_range_along_ray = [](const Vec3&, const Vec3&, double, double) { return ValueRange{0, 0}; };
  return field;
}
FieldUnderTest sloping_in_every_way(FieldUnderTest field) {
  field.slope_range_along_ray = [](const Vec3&, const Vec3&, double, double) { return ValueRange{-1e300, 1e300}; };
  return field;
}
FieldUnderTest sure_of_its_values(FieldUnderTest field) {
  field.remainder = [bound = field.remainder](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    return RemainderBounds{0, bound(origin, direction, t0, t1).derivative};
  };
  return field;
}
FieldUnderTest sure_of_its_slopes(FieldUnderTest field) {
  field.remainder = [bound = field.remainder](const Vec3& origin, const Vec3& direction, double t0, double t1) {
    return RemainderBounds{bound(origin, direction, t0, t1).value, 0};
  };
  return field;
}

TEST(Properties, EachNoticesAFieldThatBreaksIt) {
  const std::vector<Sabotage> sabotages = {{"ValueIsTheReferences", off_in_the_eleventh_digit},
                                           {"GradientIsTheReferences", gradient_off_in_the_ninth_digit},
                                           {"GradientIsTheSlopeOfTheValue", gradient_with_a_wrong_sign},
                                           {"SurfaceAloneIsAtTheRadius", off_in_the_eleventh_digit},
                                           {"SlopeAtTheRadiusIsMinusHardness", a_little_softer},
                                           {"BorderHasNoValueAndNoSlope", nowhere_zero},
                                           {"AlongARayIsTheValueAndItsDerivative", derivative_along_a_unit_direction},
                                           {"IsSmoothAlongRays", cut_off_without_a_window},
                                           {"BoxRangeHoldsEverySample", bounded_from_its_corners},
                                           {"BoxRangeShrinksWithTheBox", bounded_by_everything},
                                           {"RangeAlongARayHoldsEverySample", ranging_over_the_first_half},
                                           {"SlopeAndBendAlongARayHoldEverySample", sloping_as_in_the_middle},
                                           {"SlopeAndBendAlongARayHoldEverySample", sure_to_be_straight},
                                           {"SlopeRangeShrinksWithTheStretch", sloping_in_every_way},
                                           {"RemainderBoundsTheCubicsError", sure_of_its_values},
                                           {"RemainderBoundsTheCubicsError", sure_of_its_slopes}};
  for (const Property& property : properties()) {
    const auto breaks_it = [&](const Sabotage& sabotage) { return sabotage.property == property.name; };
    EXPECT_TRUE(std::any_of(sabotages.begin(), sabotages.end(), breaks_it)) << property.name << " is never broken";
    for (const Sabotage& sabotage : sabotages) {
      if (!breaks_it(sabotage)) continue;
      const bool is_of_the_radius = sabotage.property == std::string_view("SurfaceAloneIsAtTheRadius") ||
                                    sabotage.property == std::string_view("SlopeAtTheRadiusIsMinusHardness");
      int noticed = 0, fields = 0;
      for (const FieldCase& field : field_cases()) {
        if (field.kernel.meaning != scene::RadiusMeaning::surface || field.kernel.hardness != 4) continue;
        // The extremes of a half-space are at a box's corners, so this sabotage does not break it.
        const bool is_plane = field.component.skeleton == scene::Skeleton::plane;
        if (is_plane && sabotage.broken == bounded_from_its_corners) continue;
        if (is_of_the_radius && !is_function_of_distance(field)) continue;
        // The reference's ranges of integrated fields are wide: that of the first half may contain the second half too.
        if (sabotage.broken == ranging_over_the_first_half && !is_function_of_distance(field)) continue;
        ++fields;
        const FieldUnderTest tested = reference_field_under_test(field);
        if (!property.violation(sabotage.broken(tested), field).empty()) ++noticed;
      }
      EXPECT_EQ(noticed, fields) << property.name;
    }
  }
}

}  // namespace
}  // namespace isl::conformance
