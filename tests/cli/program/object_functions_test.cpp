// `trace`, `inside`, `min_extent` and `max_extent` as a scene calls them. The numbers are those that POV-Ray 3.7
// prints.
#include "tests/cli/program/program_fixture.h"

namespace isl::test {
namespace {

using testing::HasSubstr;

class ObjectFunctions : public ProgramTest {
 protected:
  /// The text that #debug wrote.
  [[nodiscard]] std::string said(std::string_view scene) const {
    write("scene.isl", scene);
    return run({"check", "scene.isl"}).err;
  }
};

TEST_F(ObjectFunctions, TraceGivesPointAndNormal) {
  EXPECT_THAT(said(R"(#declare L = sphere { 0, 1 scale <2, 1, 1> }
#declare N = <1, 2, 3>;
#debug concat(vstr(3, trace(L, <-5, .5, 0>, x, N), ",", 0, 4), " ", vstr(3, N, ",", 0, 4), "\n")
#debug concat(vstr(3, trace(L, -5*z, -z, N), ",", 0, 4), " ", vstr(3, N, ",", 0, 4), "\n")
L)"),
              HasSubstr("-1.7321,0.5000,0.0000 -0.6547,0.7559,0.0000\n"
                        "0.0000,0.0000,0.0000 0.0000,0.0000,0.0000\n"));
}

TEST_F(ObjectFunctions, TraceWritesTheNormalIntoArraysAndThroughParameters) {
  EXPECT_THAT(said(R"(#declare L = sphere { 0, 1 }
#declare A = array[1] { <0, 0, 0> }
#macro Height(X, Z, Normal) trace(L, <X, 9, Z>, -y, Normal) #end
#declare P = Height(0, 0, A[0]);
#debug concat(vstr(3, P, ",", 0, 1), " ", vstr(3, A[0], ",", 0, 1), "\n")
L)"),
              HasSubstr("0.0,1.0,0.0 0.0,1.0,0.0\n"));
}

TEST_F(ObjectFunctions, InsideAndExtentsOfADifference) {
  EXPECT_THAT(said(R"(#declare L = difference { box { -1, 1 } torus { 1, .25 } translate 5*x }
#debug concat(str(inside(L, 5*x), 0, 0), str(inside(L, 6*x), 0, 0), str(inside(L, 0), 0, 0), " ")
#debug concat(vstr(3, min_extent(L), ",", 0, 2), " ", vstr(3, max_extent(L), ",", 0, 2), "\n")
L)"),
              HasSubstr("100 4.00,-1.00,-1.00 6.00,1.00,1.00\n"));
}

TEST_F(ObjectFunctions, ExtentsOfPovraysBlobsAreWhatPovrayGives) {
  const auto extents = [this](const std::string& components) {
    return said("#declare B = blob { threshold 0.5 " + components + R"( }
#debug concat("from ", vstr(3, min_extent(B), " ", 0, 4), " to ", vstr(3, max_extent(B), " ", 0, 4), "\n")
B)");
  };
  EXPECT_THAT(extents("sphere { <1, 2, 3>, 0.5, 1 rotate 30*y translate x scale 2 }"),
              HasSubstr("from 5.7321 3.0000 3.1962 to 7.7321 5.0000 5.1962\n"));
  EXPECT_THAT(extents("sphere { <1, 2, 3>, 0.5, 1 scale <1, 2, 1> rotate 30*y translate x scale 2 }"),
              HasSubstr("from 4.7321 6.0000 2.1962 to 8.7321 10.0000 6.1962\n"));
  EXPECT_THAT(extents("sphere { 0, 1, 1 } cylinder { 0, 4*x, 1, -1 } sphere { 5*y, 0.1, 1 }"),
              HasSubstr("from -1.0000 -1.0000 -1.0000 to 1.0000 5.1000 1.0000\n"));
  EXPECT_THAT(extents("cylinder { 0, <1, 2, 3>, 1, 1 }"),
              HasSubstr("from -2.9017 -2.4017 -1.9017 to 3.9017 4.4017 4.9017\n"));
  EXPECT_THAT(extents("cylinder { 0, 2*z, 0.5, 1 scale 2 }"),
              HasSubstr("from -2.2361 -2.2361 -1.0000 to 2.2361 2.2361 5.0000\n"));
  EXPECT_THAT(extents("cylinder { 0, 4*x, 1, 1 } rotate 45*z"),
              HasSubstr("from -2.2882 -2.2882 -2.2361 to 5.1167 5.1167 2.2361\n"));
  // The radius of one of our own kernels is that of the surface.
  EXPECT_THAT(extents("kernel \"gaussian\" sphere { 0, 1 strength 0.5 }"),
              HasSubstr("from -1.0000 -1.0000 -1.0000 to 1.0000 1.0000 1.0000\n"));
}

TEST_F(ObjectFunctions, APatternOfAnObjectIsOneInside) {
  EXPECT_THAT(said(R"(#declare F = function { pattern { object { torus { 1, .25 } } scale 2 } }
#declare G = function { pigment { object { sphere { 0, 1 } rgb 0.25 rgb 0.75 } translate x } }
#debug concat(str(F(2, 0, 0), 0, 0), str(F(1, 0, 0), 0, 0), " ")
#debug concat(str(G(0.5, 0, 0).red, 0, 2), " ", str(G(-0.5, 0, 0).red, 0, 2), "\n")
)"),
              HasSubstr("10 0.75 0.25\n"));
}

TEST_F(ObjectFunctions, ExtentsWithoutEndAreTenToTheTenth) {
  EXPECT_THAT(said(R"(#declare L = poly { 2, <1, 0, 0, 0, 0, 0, 0, 0, 0, -1> }
#debug concat(str(max_extent(L).x, 0, 0), str(min_extent(L).y, 0, 0), "\n")
L)"),
              HasSubstr("10000000000-10000000000\n"));
}

TEST_F(ObjectFunctions, TellWhatTheyCannotAnswer) {
  const std::string errors = said(R"(#declare T = torus { 1, .2 }
#declare L = light_source { 0, 1 }
#declare F = 3;
#declare P = trace(3, 0, x);
#declare P = trace(sphere { 0, 1 }, 0, x, F);
#declare P = trace(object { T }, 0, x, <0, 0, 0>);
#declare P = inside(L, 0);
#declare P = min_extent(3);
)");
  EXPECT_THAT(errors, HasSubstr("4:20: error: `trace`: expected an object, found a number"));
  EXPECT_THAT(
      errors,
      HasSubstr("5:43: error: `trace`: expected a variable with a 3-term vector for the normal, found a number"));
  EXPECT_THAT(errors, HasSubstr("6:40: error: `trace`: expected the name of a variable"));
  EXPECT_THAT(errors, HasSubstr("7:21: error: `inside`: a light has no surface"));
  EXPECT_THAT(errors, HasSubstr("8:25: error: `min_extent`: expected an object, found a number"));
}

}  // namespace
}  // namespace isl::test
