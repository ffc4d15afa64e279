#include "tests/fuzz/kinds_of_values.h"

namespace isl::test {

const std::string& declarations_of_every_kind() {
  static const std::string text = R"(#version 3.7;
#declare Number = 2;
#declare Pair = <1, 2>;
#declare Vector = <1, 2, 3>;
#declare Quadruple = <1, 2, 3, 4>;
#declare Colour = rgbft <1, 2, 3, 4, 5>;
#declare Text = "text";
#declare Numbers = array[2] { 1, 2 }
#declare Table = array[2][2] { { 1, 2 }, { 3, 4 } }
#declare Unset = array[2]
#declare Strings = array[1] { "a" }
#declare Formula = function (x, y) { x + y }
#declare Field = function { x }
#declare Paint = function { pigment { gradient x } }
#declare Curve = spline { linear_spline 0, <0, 0, 0>, 1, <1, 1, 1> }
#declare Ball = sphere { 0, 1 }
#declare Pair_of_balls = union { sphere { 0, 1 } sphere { x, 1 } }
#declare Drop = blob { sphere { 0, 1, 1 } }
#declare Lamp = light_source { 0, rgb 1 }
#declare Pigment = pigment { gradient x }
#declare Normal = normal { bumps 1 }
#declare Finish = finish { phong 1 }
#declare Texture = texture { pigment { rgb 1 } }
#declare Material = material { texture { pigment { rgb 1 } } }
#declare Interior = interior { ior 1.5 }
#declare Colours = color_map { [0 rgb 0] [1 rgb 1] }
#declare Pigments = pigment_map { [0 gradient x] [1 rgb 1] }
#declare Normals = normal_map { [0 bumps] [1 dents] }
#declare Slopes = slope_map { [0 <0, 1>] [1 <1, 0>] }
#declare Textures = texture_map { [0 pigment { rgb 1 }] }
#declare Sky = sky_sphere { pigment { rgb 1 } }
#declare Fog = fog { distance 1 rgb 1 }
#declare Bow = rainbow { direction z angle 40 width 5 distance 10 color_map { [0 rgb 0] [1 rgb 1] } }
#declare Move = transform { translate x }
#declare View = camera { location -5*z }
#macro Yield(A) A #end
#macro Nothing() #end
#macro Two() 1, 2 #end
#macro Statement() #declare Number = 2; #end
#declare Generator = seed(1);
)";
  return text;
}

std::span<const std::string_view> expressions_of_every_kind() {
  static constexpr std::string_view kExpressions[] = {
      "1",
      "Number",
      "Pair",
      "Vector",
      "Quadruple",
      "Colour",
      "<1, 2>",
      "<1, 2, 3>",
      "x",
      "u",
      "t",
      "\"text\"",
      "Text",
      "Numbers",
      "Numbers[0]",
      "Table",
      "Table[1]",
      "Table[0][1]",
      "Unset",
      "Unset[0]",
      "Strings[0]",
      "Formula",
      "Field",
      "Paint",
      "Formula(1, 2)",
      "Paint(1, 2, 3)",
      "Curve",
      "Curve(0.5)",
      "Ball",
      "Pair_of_balls",
      "Drop",
      "Lamp",
      "Pigment",
      "Normal",
      "Finish",
      "Texture",
      "Material",
      "Interior",
      "Colours",
      "Pigments",
      "Normals",
      "Slopes",
      "Textures",
      "Sky",
      "Fog",
      "Bow",
      "Move",
      "View",
      "Yield",
      "Yield(1)",
      "Yield(Ball)",
      "Nothing()",
      "Two()",
      "Statement()",
      "Undeclared",
      "Undeclared(1)",
      "Undeclared[0]",
      "kernel",
      "pi",
      "version",
      "sin(1)",
      "(1 < 2)",
      "-1",
      "array[1] { 1 }",
      "function { x }",
      "sphere { 0, 1 }",
      "pigment { rgb 1 }",
      "rgb 1",
      "1e308*10",
      "(0/0)",
  };
  return kExpressions;
}

}  // namespace isl::test
