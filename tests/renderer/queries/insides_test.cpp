// Questions about insides that go by boxes, against the same questions to every part, and against the reference. The
// answers must be the same, also within rounding of a surface; and they must be found by looking at few parts, which is
// counted.
#include "renderer/queries/insides.h"

#include "renderer/fields/component_table.h"
#include "renderer/queries/enclosures.h"
#include "renderer/reference/reference_field.h"
#include "tests/reference/random_scenes.h"
#include "tests/renderer/queries/random_object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

namespace isl::render::test {
namespace {

std::vector<KernelConstants> kernels_of(const scene::Database& database) {
  std::vector<KernelConstants> kernels;
  for (const scene::Kernel& kernel : database.kernels) kernels.push_back(kernel_constants(kernel));
  return kernels;
}

/// More questions than it takes until indexes are built.
constexpr int kManyQuestions = 100;

/// The neighbours of a number, and itself.
double near_to(double x, int step) {
  return step == 0 ? x : std::nextafter(x, step * std::numeric_limits<double>::infinity());
}

/// The last point with property `holds` on the way from one that has it to one that does not, and the first without.
template <class Holds>
std::pair<Vec3, Vec3> border(Vec3 with, Vec3 without, const Holds& holds) {
  while (true) {
    const Vec3 middle = (with + without) * 0.5;
    if (middle == with || middle == without) return {with, without};
    (holds(middle) ? with : without) = middle;
  }
}

/// One object asked both ways.
class BothWays {
 public:
  BothWays(const scene::Database& database, const Object& object)
      : database_(database), object_(object), kernels_(kernels_of(database)), insides_(database) {}

  [[nodiscard]] bool plain(const Vec3& point) const {
    StepCounter steps;
    return is_inside(database_, kernels_, object_, point, steps);
  }
  [[nodiscard]] bool by_boxes(const Vec3& point) const {
    StepCounter steps;
    return insides_.is_inside(object_, point, steps);
  }
  /// Compares at a point, and counts the answer.
  void compare(const Vec3& point) {
    const bool expected = plain(point);
    ASSERT_EQ(by_boxes(point), expected) << "at " << point;
    ++answers[expected];
  }
  /// Compares at points of which draw() makes one, and wherever the surface lies between two of them.
  template <class Draw>
  void compare_at(int points, const Draw& draw) {
    Vec3 last[2];
    bool has[2] = {false, false};
    for (int i = 0; i < points; ++i) {
      const Vec3 point = draw();
      compare(point);
      if (testing::Test::HasFatalFailure()) return;
      const bool is_in = plain(point);
      last[is_in] = point;
      has[is_in] = true;
      if (!has[0] || !has[1] || i % 8 != 0) continue;
      const auto [inner, outer] = border(last[1], last[0], [&](const Vec3& p) { return plain(p); });
      for (const Vec3& at : {inner, outer}) {
        for (int near = 0; near < 27; ++near) {
          compare({near_to(at.x, near % 3 - 1), near_to(at.y, near / 3 % 3 - 1), near_to(at.z, near / 9 - 1)});
          if (testing::Test::HasFatalFailure()) return;
        }
        ++borders;
      }
    }
  }

  int answers[2] = {0, 0};  ///< by the answer
  int borders = 0;

 private:
  const scene::Database& database_;
  const Object& object_;
  std::vector<KernelConstants> kernels_;
  Insides insides_;
};

/// Sums of what was compared over many objects.
struct Compared {
  int answers[2] = {0, 0}, borders = 0;

  void add(const BothWays& asked) {
    answers[0] += asked.answers[0];
    answers[1] += asked.answers[1];
    borders += asked.borders;
  }
};

TEST(InsidesByBoxes, are_those_of_all_components_of_a_blob) {
  reference::RandomSource source(611);
  Random random(611);
  Compared all;
  for (int turn = 0; turn < 120; ++turn) {
    scene::Database database = reference::random_blob(source, {.components = 10 + turn % 50,
                                                               .maxima = turn % 5 == 1,
                                                               .half_space = turn % 5 == 2,
                                                               .convolutions = turn % 5 == 3});
    scene::Blob& blob = database.blobs[0];
    blob.is_unblended = turn % 5 == 4;
    if (turn % 12 == 7) blob.threshold = turn % 24 == 7 ? 0 : -0.2;
    Object object = database.objects[0];
    const Place place(random);
    object.parent_from_object = place.transform;
    object.inverse = turn % 7 == 3;
    BothWays asked(database, object);
    asked.compare_at(400, [&] { return place.transform.point(random.in_cube(1.2)); });
    if (HasFatalFailure()) FAIL() << "turn " << turn;
    all.add(asked);
  }
  EXPECT_GT(all.answers[0], 10000);
  EXPECT_GT(all.answers[1], 10000);
  EXPECT_GT(all.borders, 5000);
}

/// Many objects of all kinds, many of them small and apart.
Object random_crowd(CsgScene& scene, Random& random, int depth) {
  std::vector<Object> children;
  const int count = 3 + static_cast<int>(random.uniform(0, depth == 0 ? 40 : 6));
  for (int i = 0; i < count; ++i) {
    const double choice = random.uniform(0, 10);
    Object child =
        depth > 0 && choice < 5 ? random_crowd(scene, random, depth - 1)
        : choice < 7
            ? random_tree(scene, random, 2, true)
            : random_of_kind(scene, random, static_cast<scene::SolidKind>(random.uniform(0, scene::kSolidKindCount)));
    scene::Matrix size, shift;
    size.setScale(Vec3(random.uniform(0.1, 0.5)));
    shift.setTranslation(random.in_cube(1));
    child.parent_from_object = then(child.parent_from_object, affine(size * shift));
    if (random.uniform(0, 1) < 0.1) child.inverse = !child.inverse;
    if (random.uniform(0, 1) < 0.1) child = scene.clipped(child, {random_tree(scene, random, 1, false)});
    children.push_back(child);
    if (random.uniform(0, 1) < 0.2) {  // another instance of the same shape
      child.parent_from_object = then(child.parent_from_object, random_transform(random));
      children.push_back(child);
    }
  }
  const Operation operations[] = {Operation::unite, Operation::merge, Operation::intersect, Operation::subtract};
  // A union is what there usually is much of, and an intersection of many is empty.
  const double choice = random.uniform(0, 10);
  Object result = scene.group(operations[choice < 5 ? 0 : choice < 7 ? 1 : choice < 8 ? 2 : 3], std::move(children));
  result.inverse = random.uniform(0, 1) < 0.1;
  return result;
}

TEST(InsidesByBoxes, are_those_of_all_members_of_a_group) {
  Random random(612);
  Compared all;
  for (int turn = 0; turn < 400; ++turn) {
    CsgScene scene;
    Object object = random_crowd(scene, random, turn % 3);
    const Place place(random);
    object.parent_from_object = place.transform;
    BothWays asked(scene.database, object);
    asked.compare_at(300, [&] { return place.transform.point(random.in_cube(1.5)); });
    if (HasFatalFailure()) FAIL() << "turn " << turn;
    all.add(asked);
  }
  EXPECT_GT(all.answers[0], 10000);
  EXPECT_GT(all.answers[1], 10000);
  EXPECT_GT(all.borders, 1000);
}

TEST(InsidesByBoxes, of_a_point_that_is_no_number_stay_what_they_are) {
  CsgScene scene;
  const Object object =
      scene.group(Operation::unite, {scene.solid(box(Vec3(-1), Vec3(1))), scene.solid(sphere({5, 0, 0}, 1))});
  BothWays asked(scene.database, object);
  for (int i = 0; i < kManyQuestions; ++i) {
    for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      asked.compare({odd, 0, 0});
  }
}

TEST(InsidesByBoxes, of_a_blob_are_those_of_the_reference) {
  reference::RandomSource source(613);
  int answers[2] = {0, 0};
  for (int turn = 0; turn < 24; ++turn) {
    scene::Database database = reference::random_blob(
        source,
        {.components = 40, .maxima = turn % 4 == 1, .half_space = turn % 4 == 2, .convolutions = turn % 4 == 3});
    database.blobs[0].is_unblended = turn % 8 == 4;
    const reference::ReferenceField field(database, database.blobs[0]);
    BothWays asked(database, database.objects[0]);
    const auto judge = [&](const Vec3& point) {
      const reference::FieldSample sample = field.sample({point.x, point.y, point.z});
      // Some ten roundings of 2⁻⁵³, which the steepest of these kernels, e^−8q, magnifies a hundredfold.
      if (std::abs(sample.value) <= 0x1p-43L * (sample.sum_of_values + 1)) return;
      ASSERT_EQ(asked.by_boxes(point), sample.value > 0) << "turn " << turn << " at " << point;
      ++answers[sample.value > 0];
    };
    Vec3 inner(0), outer(100);
    for (int i = 0; i < 300; ++i) {
      const Vec3 point = source.in_ball(1.2);
      judge(point);
      (asked.by_boxes(point) ? inner : outer) = point;
      if (!asked.by_boxes(inner) || asked.by_boxes(outer)) continue;
      const Vec3 surface = border(inner, outer, [&](const Vec3& p) { return asked.by_boxes(p); }).first;
      for (const double away : {1e-4, 1e-8, 1e-11}) judge(surface + source.direction() * away);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(answers[0], 3000);
  EXPECT_GT(answers[1], 3000);
}

TEST(Enclosures, hold_all_points_where_a_component_has_a_field) {
  reference::RandomSource source(614);
  Random random(614);
  int borders = 0;
  for (int turn = 0; turn < 300; ++turn) {
    scene::Database database = reference::random_blob(source, {.components = 10, .convolutions = turn % 2 == 1});
    // Maps whose parts nearly cancel one another.
    for (scene::Transform& transform : database.transforms) {
      scene::Matrix there, back;
      const Vec3 far = random.direction() * std::pow(10, random.uniform(0, 14));
      there.setTranslation(far);
      back.setTranslation(-far);
      transform = then(then(then(transform, affine(there)), random_transform(random)), affine(back));
    }
    const std::vector<KernelConstants> kernels = kernels_of(database);
    const scene::Blob& blob = database.blobs[0];
    for (const scene::Component& c : blob.components) {
      const KernelConstants& kernel = kernels[index(c.kernel)];
      const Imath::Box3d box = support_box(database, blob, c, kernel);
      const auto has_field = [&](const Vec3& p) { return field_at(database, blob, c, kernel, p) != 0; };
      const Vec3 middle = c.transform == scene::kIdentity ? c.a : database.transforms[index(c.transform)].point(c.a);
      if (!has_field(middle)) continue;  // what cancelled has left nothing, or a ring is empty in the middle
      for (int way = 0; way < 18; ++way) {
        Vec3 along(0);
        along[way / 2 % 3] = way % 2 == 0 ? 1 : -1;
        if (way >= 6) along = random.direction();
        const double far = 10 * (box.size().length() + 1);
        if (has_field(middle + along * far)) continue;  // it has no end there
        const Vec3 last = border(middle, middle + along * far, has_field).first;
        ASSERT_TRUE(box.intersects(last)) << last << " is outside of " << box.min << " " << box.max;
        ++borders;
      }
    }
  }
  EXPECT_GT(borders, 5000);
}

TEST(Enclosures, hold_all_points_in_a_solid) {
  Random random(615);
  for (int kind = 0; kind < scene::kSolidKindCount; ++kind) {
    int borders = 0;
    for (int turn = 0; turn < 60; ++turn) {
      CsgScene scene;
      Object object = random_of_kind(scene, random, static_cast<scene::SolidKind>(kind));
      const Place place(random);
      scene::Matrix size;
      size.setScale(Vec3(place.scale));
      // Without a rotation, the border of many kinds is on the box.
      object.parent_from_object = turn % 2 == 0 ? place.transform : affine(size);
      const std::vector<KernelConstants> kernels;
      const Enclosure whole = Enclosures(scene.database, kernels).of(object, false);
      const Enclosure inverse = Enclosures(scene.database, kernels).of(object, true);
      StepCounter steps;
      const auto is_in = [&](const Vec3& p) { return is_inside(scene.database, kernels, object, p, steps); };
      for (int i = 0; i < 200; ++i) {
        const Vec3 from = object.parent_from_object.point(random.in_cube(1));
        Vec3 along(0);
        along[i / 2 % 3] = i % 2 == 0 ? 1 : -1;
        const Vec3 to = from + along * (100 * place.scale);
        if (!is_in(from) || is_in(to)) continue;
        const auto [inner, outer] = border(from, to, is_in);
        ASSERT_TRUE(whole.box.intersects(inner)) << "kind " << kind << ": " << inner;
        EXPECT_TRUE(whole.box.intersects(to) || !whole.beyond);
        EXPECT_TRUE(inverse.box.intersects(to) || inverse.beyond);
        ++borders;
      }
    }
    const bool is_open = kind == static_cast<int>(scene::SolidKind::triangle) ||
                         kind == static_cast<int>(scene::SolidKind::smooth_triangle) ||
                         kind == static_cast<int>(scene::SolidKind::polygon);
    EXPECT_EQ(borders > 0, !is_open) << "kind " << kind;
  }
}

/// An object of many parts, asked once its indexes are there. Counts by the limit of steps: an object asked is one
/// step, and 64 components are.
class ManyParts : public testing::Test {
 protected:
  /// Asks often without a limit, and then with one. Every part would spend it.
  void expect_few_steps(const Object& object, double size, std::uint64_t most) {
    const Insides insides(scene_.database);
    const std::vector<KernelConstants> kernels = kernels_of(scene_.database);
    std::uint64_t spent = 0;
    for (int i = 0; i < 6 * kManyQuestions; ++i) {
      const Vec3 point = random_.in_cube(size);
      StepCounter few(i < 4 * kManyQuestions ? StepCounter::kUnlimited : most), all(most), unlimited;
      const bool is_in = insides.is_inside(object, point, few);
      EXPECT_FALSE(few.is_spent());
      EXPECT_EQ(is_in, is_inside(scene_.database, kernels, object, point, unlimited));
      (void)is_inside(scene_.database, kernels, object, point, all);
      spent += all.is_spent() ? 1 : 0;
    }
    EXPECT_GT(spent, 0u) << "the limit tells nothing";
  }
  [[nodiscard]] Object ball_of_many(double radius) { return scene_.solid(sphere(random_.in_cube(10), radius)); }
  [[nodiscard]] Object blob_of(int components, double size) {
    std::vector<scene::Component> balls(static_cast<std::size_t>(components));
    for (scene::Component& c : balls) {
      c.a = random_.in_cube(size);
      c.radius_a = 0.35;
    }
    return scene_.blob(balls, 0.3);
  }

  CsgScene scene_;
  Random random_{616};
};

TEST_F(ManyParts, of_a_blob_are_hardly_looked_at) {
  const Object blob = blob_of(20000, 10);
  // 20,000 supports of a volume of 0.18 in 8000: a box that bounds one holds 1.9 of it.
  expect_few_steps(blob, 10, 2);
}

TEST_F(ManyParts, of_a_maximum_are_hardly_looked_at) {
  const Object object = blob_of(5000, 6);
  scene::Blob& blob = scene_.database.blobs[object.shape];
  blob.branches.push_back({0, 0});
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    blob.branches.push_back({0, 1});
    blob.branch_of.push_back(i + 1);
  }
  expect_few_steps(object, 6, 2);
}

TEST_F(ManyParts, of_a_union_are_hardly_asked) {
  std::vector<Object> balls;
  for (int i = 0; i < 3000; ++i) balls.push_back(ball_of_many(0.5));
  expect_few_steps(scene_.group(Operation::unite, balls), 10, 20);
}

TEST_F(ManyParts, of_what_is_taken_away_are_hardly_asked) {
  std::vector<Object> cheese{scene_.solid(box(Vec3(-10), Vec3(10)))};
  for (int i = 0; i < 3000; ++i) cheese.push_back(ball_of_many(0.5));
  expect_few_steps(scene_.group(Operation::subtract, cheese), 10, 20);
}

TEST_F(ManyParts, of_a_union_of_blobs_are_hardly_asked) {
  std::vector<Object> blobs;
  for (int i = 0; i < 300; ++i) {
    blobs.push_back(blob_of(10, 0.5));
    scene::Matrix shift;
    shift.setTranslation(random_.in_cube(10));
    blobs.back().parent_from_object = affine(shift);
  }
  expect_few_steps(scene_.group(Operation::merge, blobs), 10, 20);
}

TEST_F(ManyParts, of_unions_of_unions_are_hardly_asked) {
  Object half = scene_.solid(sphere(Vec3(0), 0.3));
  for (int level = 0; level < 12; ++level) {
    Object other = half;
    scene::Matrix shift;
    shift.setTranslation(Vec3(level % 3 == 0, level % 3 == 1, level % 3 == 2) * std::pow(2, level / 3));
    other.parent_from_object = affine(shift);
    half = scene_.group(Operation::unite, {half, other});
  }
  expect_few_steps(half, 16, 100);  // the parts are 4096
}

TEST_F(ManyParts, are_all_asked_where_there_is_no_memory_for_an_index) {
  const Object object = blob_of(1000, 2);
  for (const std::size_t limit : {std::size_t{0}, std::size_t{40000}, std::size_t{1} << 20}) {
    Budget budget(limit);
    {
      RunLimits run;
      run.budget = &budget;
      const Insides insides(scene_.database, run);
      const std::vector<KernelConstants> kernels = kernels_of(scene_.database);
      for (int i = 0; i < kManyQuestions; ++i) {
        const Vec3 point = random_.in_cube(2);
        StepCounter steps;
        EXPECT_EQ(insides.is_inside(object, point, steps), is_inside(scene_.database, kernels, object, point, steps));
      }
      EXPECT_EQ(budget.held() > 0, limit > 100000);
    }
    EXPECT_EQ(budget.held(), 0u);
  }
}

TEST_F(ManyParts, may_be_asked_by_several_threads) {
  std::vector<Object> parts{blob_of(500, 3)};
  for (int i = 0; i < 200; ++i) parts.push_back(ball_of_many(0.5));
  const Object object = scene_.group(Operation::unite, parts);
  const Insides insides(scene_.database);
  const std::vector<KernelConstants> kernels = kernels_of(scene_.database);
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      Random random(seed);
      for (int i = 0; i < 5 * kManyQuestions; ++i) {
        const Vec3 point = random.in_cube(4);
        StepCounter steps;
        const bool expected = is_inside(scene_.database, kernels, object, point, steps);
        wrong += insides.is_inside(object, point, steps) != expected ? 1 : 0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace isl::render::test
