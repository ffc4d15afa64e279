// Clipped shapes within random combinations, subtracted, inverse or nested, compared with the definition of their
// insides: along a line the inside changes at the hits, and else only where the clip's does, whose surface is not seen.
#include "tests/renderer/csg/random_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace isl::render::test {
namespace {

/// A combination with one clipped shape in it, and the clip as an object of its own.
struct Clipped {
  CsgScene whole, clip;
};

/// Both scenes draw the same random numbers for the clip.
Object clip_of(CsgScene& scene, Random random) { return random_leaf(scene, random); }

void make(Random& random, Clipped& made) {
  const Random of_clip = random;
  random.uniform(0, 1);
  Object shape = made.whole.clipped(random_leaf(made.whole, random), {clip_of(made.whole, of_clip)});
  shape.parent_from_object = random_transform(random);
  shape.inverse = random.uniform(0, 1) < 0.3;
  const Object beside = random_leaf(made.whole, random);
  const Operation inner = random.uniform(0, 1) < 0.5 ? Operation::intersect : Operation::merge;
  const Object group = random.uniform(0, 1) < 0.5 ? made.whole.group(inner, {shape, beside}) : shape;
  const Operation outer = random.uniform(0, 1) < 0.7 ? Operation::subtract : Operation::intersect;
  made.whole.database.objects = {made.whole.group(outer, {made.whole.solid(sphere(Vec3(0), 1.5)), group})};
  Object clip = made.clip.group(Operation::intersect, {clip_of(made.clip, of_clip)});
  clip.parent_from_object = shape.parent_from_object;
  made.clip.database.objects = {clip};
}

/// True if the clip begins or ends between two t. It may do both between the samples of a line.
bool changes(const CsgScene& clip, const Vec3& origin, const Vec3& direction, double from, double to) {
  constexpr int kSteps = 256;
  const auto holds = [&](int i) { return clip.inside(origin + direction * (from + (to - from) * i / kSteps)); };
  for (int i = 0; i < kSteps; ++i) {
    if (holds(i) != holds(i + 1)) return true;
  }
  return false;
}

TEST(ClipsInTrees, ShowTheShapeAndNotTheClip) {
  Random random(65);
  int hits = 0, unseen = 0;
  for (int turn = 0; turn < 400; ++turn) {
    Clipped made;
    make(random, made);
    TracerOptions options;
    options.solver = SolverName::exact;
    const Tracer tracer(made.whole.database, options);
    for (int line = 0; line < 20; ++line) {
      const Vec3 direction = random.direction(), origin = random.in_cube(1) - direction * 4;
      const Walk found = walk(tracer, origin, direction);
      ASSERT_LT(found.t.size(), 200U);
      hits += static_cast<int>(found.t.size());
      double last = -1;
      bool was_inside = false;
      for (int i = 0; i < 160; ++i) {
        const double t = (i + random.uniform(0, 1)) * 0.05;
        if (std::ranges::any_of(found.t, [&](double at) { return std::abs(at - t) < 1e-7; })) continue;
        const Vec3 point = origin + direction * t;
        const bool is_inside = made.whole.inside(point);
        if (last >= 0) {
          const auto crossed = std::ranges::count_if(found.t, [&](double at) { return at > last && at < t; });
          if ((is_inside != was_inside) != (crossed % 2 == 1)) {
            ASSERT_TRUE(changes(made.clip, origin, direction, last, t))
                << "from " << last << " to " << t << ", tree " << turn << " line " << line;
            ++unseen;
          }
        }
        last = t;
        was_inside = is_inside;
      }
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(unseen, 200);
}

}  // namespace
}  // namespace isl::render::test
