// A shape that is not supported yet is refused by its name wherever an object may stand, with no other message.
#include "grammar/symbols.h"
#include "interpreter/readers/words/supported.h"
#include "renderer/queries/object_queries.h"
#include "tests/interpreter/evaluated_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {
namespace {

std::vector<std::string> unsupported_shapes() {
  const grammar::SymbolTable symbols;
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < grammar::word::kReservedCount; ++i) {
    if (interpreter::is_unsupported_object(grammar::Symbol{i})) names.emplace_back(symbols.text(grammar::Symbol{i}));
  }
  return names;
}

/// The text within the braces is not read, whether or not it is right for the shape.
constexpr std::string_view kShape = "{} {{ 4, <0, 1>, \"a\" scale 2 }}";

constexpr std::string_view kShapePlaces[] = {
    "@",
    "object {{ @ translate x }}",
    "union {{ sphere {{ 0, 1 }} @ }}",
    "union {{ @ sphere {{ 0, 1 }} translate x }}",
    "intersection {{ sphere {{ 0, 1 }} @ }}",
    "difference {{ @ sphere {{ 0, 1 }} }}",
    "merge {{ sphere {{ 0, 1 }} @ sphere {{ x, 1 }} }}",
    "light_group {{ light_source {{ 9, 1 }} @ }}",
    "sphere {{ 0, 1 clipped_by {{ @ }} }}",
    "sphere {{ 0, 1 bounded_by {{ @ }} }}",
    "light_source {{ 9, 1 looks_like {{ @ }} }}",
    "light_source {{ 9, 1 projected_through {{ @ }} }}",
    "sphere {{ 0, 1 pigment {{ object {{ @ rgb 1, rgb 0 }} }} }}",
    "sphere {{ 0, 1 pigment {{ object {{ @ pigment {{ rgb 1 }} pigment {{ rgb 0 }} }} }} }}",
    "sphere {{ 0, 1 texture {{ object {{ @ texture {{ }} texture {{ }} }} }} }}",
    "#declare F = function {{ pattern {{ object {{ @ }} }} }}",
    "#declare A = @",
    "#declare A = @ object {{ A }} union {{ object {{ A }} sphere {{ 0, 1 }} }}",
    "#declare A = array[1] {{ @ }}",
    "#macro M() @ #end M()",
    "#macro M() @ #end object {{ M() }}",
    "#macro M() @ #end union {{ M() sphere {{ 0, 1 }} }}",
    "#macro M() @ #end #declare A = M();",
    "#macro M(A) object {{ A }} #end M(@)",
    "#declare V = trace(@, 0, z);",
    "#declare V = inside(@, 0);",
    "#declare V = max_extent(@);",
    "#if (1) @ #end",
};

std::string place(std::string_view shape, std::string_view place) {
  std::string text = fmt::format(fmt::runtime(place));
  const std::string block = fmt::format(fmt::runtime(kShape), shape);
  text.replace(text.find('@'), 1, block);
  return text;
}

TEST(UnsupportedShapes, AreRefusedByNameWhereverAnObjectMayStand) {
  const std::vector<std::string> shapes = unsupported_shapes();
  ASSERT_GT(shapes.size(), 5u);
  for (const std::string& shape : shapes) {
    for (const std::string_view where : kShapePlaces) {
      const std::string scene = place(shape, where);
      render::ObjectQueries queries;
      interpreter::EvaluateOptions options;
      options.queries = &queries;
      EXPECT_EQ(EvaluatedText(scene, options).messages(), fmt::format("error: `{}` is not supported\n", shape))
          << scene;
    }
  }
}

}  // namespace
}  // namespace isl::test
