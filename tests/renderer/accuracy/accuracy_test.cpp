// Reports of errors, and their reference: neither may praise what is wrong.
#include "renderer/accuracy/comparison.h"
#include "renderer/accuracy/measured_aovs.h"
#include "renderer/accuracy/measured_layers.h"
#include "renderer/film/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace isl::render {
namespace {

constexpr double kMiss = std::numeric_limits<double>::infinity();

/// Two balls that blend into one another, seen from the front.
scene::Database two_balls() {
  scene::Database database;
  database.camera = scene::Camera{};
  database.camera->location = {0, 0, -6};
  database.kernels.push_back(
      {.shape = scene::KernelShape::gaussian, .meaning = scene::RadiusMeaning::surface, .hardness = 3});
  database.transforms.emplace_back();
  scene::Blob blob;
  for (const double x : {-0.9, 0.9}) {
    scene::Component component;
    component.a = {x, 0, 0};
    component.radius_a = 1;
    component.kernel = scene::KernelId{0};
    blob.components.push_back(component);
  }
  database.blobs.push_back(blob);
  database.objects.push_back({.kind = scene::Object::Kind::blob, .shape = 0});
  return database;
}

TracerOptions options_of(SolverName solver, const scene::Database& database) {
  TracerOptions options;
  options.solver = solver;
  options.pixel_angle = pixel_angle(*database.camera, 40, 30);
  return options;
}

ReferenceHit hit_at(double t) { return {t, 0, Knowledge::proven}; }

Ray ray_from(const Vec3& origin, const Vec3& direction) { return {origin, direction, kMiss, 0, {}}; }

ReferenceHit first_hit(const scene::Database& database, const Ray& ray, const TracerOptions& options = {}) {
  return ReferenceHits(database, options).first_hit(ray);
}

TEST(RayErrors, AreLengthsOverTheFootprint) {
  const RayError error = error_of(Ray{}, {.t = 10.5}, hit_at(10), 0.01);
  EXPECT_EQ(error.outcome, RayOutcome::hit);
  EXPECT_DOUBLE_EQ(error.units, 0.5);
  EXPECT_DOUBLE_EQ(error.pixels, 5);
}

TEST(RayErrors, TellWhatIsMissedFromWhatIsInvented) {
  EXPECT_EQ(error_of(Ray{}, {.t = kMiss}, hit_at(1), 1).outcome, RayOutcome::missed);
  EXPECT_EQ(error_of(Ray{}, {.t = 1}, hit_at(kMiss), 1).outcome, RayOutcome::false_surface);
  EXPECT_EQ(error_of(Ray{}, {.t = kMiss}, hit_at(kMiss), 1).outcome, RayOutcome::background);
}

TEST(RayErrors, BlameNobodyWhereTheReferenceIsUndecided) {
  const ReferenceHit undecided{kMiss, 0, Knowledge::undecided};
  EXPECT_EQ(error_of(Ray{}, {.t = kMiss}, undecided, 1).outcome, RayOutcome::undecided);
  EXPECT_EQ(error_of(Ray{}, {.t = 1}, undecided, 1).outcome, RayOutcome::undecided);
  const RayError errors[] = {{.outcome = RayOutcome::undecided}};
  const ErrorSummary summary = summarise_errors(errors, 1);
  EXPECT_EQ(summary.undecided, 1u);
  EXPECT_EQ(summary.missed + summary.false_surfaces + summary.hits, 0u);
}

TEST(ErrorSummaries, TakeQuantilesOverTheHitsAlone) {
  std::vector<RayError> errors(200);
  for (std::size_t i = 0; i < 100; ++i) {
    const double off = static_cast<double>(i + 1) / 50;
    errors[i] = {RayOutcome::hit, 2 * off, off};
  }
  const ErrorSummary summary = summarise_errors(errors, 20);
  EXPECT_EQ(summary.hits, 100u);
  EXPECT_DOUBLE_EQ(summary.median_pixels, 1);
  EXPECT_DOUBLE_EQ(summary.p99_pixels, 1.98);
  EXPECT_DOUBLE_EQ(summary.worst_pixels, 2);
  EXPECT_DOUBLE_EQ(summary.worst_units, 4);
  EXPECT_EQ(summary.beyond_pixel, 50u);
}

TEST(ErrorSummaries, CallAHoleWhatIsMissedAmidASurface) {
  std::vector<RayError> errors(25, {RayOutcome::hit, 0, 0});  // 5×5
  errors[12].outcome = RayOutcome::missed;                    // in the middle
  errors[4].outcome = RayOutcome::missed;                     // at the border
  EXPECT_EQ(summarise_errors(errors, 5).missed, 2u);
  EXPECT_EQ(summarise_errors(errors, 5).holes, 1u);
  errors[6].outcome = RayOutcome::background;
  EXPECT_EQ(summarise_errors(errors, 5).holes, 0u) << "the silhouette is no hole";
}

TEST(ReferenceHits, ProveWhereTheFirstSurfaceIs) {
  const scene::Database database = two_balls();
  const std::vector<Ray> rays = centre_rays(*database.camera, 40, 30);
  std::vector<ReferenceHit> hits(rays.size());
  ReferenceHits(database, {}).find(rays, hits);
  const double angle = pixel_angle(*database.camera, 40, 30);
  const ReferenceSummary summary = summarise_reference(rays, hits, angle);
  EXPECT_EQ(summary.rays, 1200u);
  EXPECT_EQ(summary.proven, 1200u);
  EXPECT_GT(summary.worst_pixels, 0);
  EXPECT_LT(summary.worst_pixels, 1e-9);
  // A ball alone has its surface at the radius, whatever the kernel.
  scene::Database one = database;
  one.blobs[0].components = GrowingArray<scene::Component>{database.blobs[0].components[1]};
  one.blobs[0].components[0].a = {0, 0, 0};
  EXPECT_NEAR(first_hit(one, ray_from({0, 0, -6}, {0, 0, 1})).t, 5, 1e-15);
}

TEST(ReferenceHits, AreThoseOfThePlacedBlobs) {
  scene::Database database = two_balls();
  database.blobs[0].components = GrowingArray<scene::Component>{database.blobs[0].components[1]};
  database.blobs[0].components[0].a = {0, 0, 0};
  const auto placed_at = [&](double z, double size) {
    scene::Object object = database.objects[0];
    object.parent_from_object.matrix.setScale(Vec3(size));
    object.parent_from_object.inverse.setScale(Vec3(1 / size));
    object.parent_from_object.matrix[3][2] = z;
    object.parent_from_object.inverse[3][2] = -z / size;
    return object;
  };
  database.objects = {placed_at(8, 2), placed_at(0, 0.5)};
  const Ray ray = ray_from({0, 0, -6}, {0, 0, 1});
  EXPECT_NEAR(first_hit(database, ray).t, 5.5, 1e-15);
  database.objects[1].no_image = true;
  EXPECT_NEAR(first_hit(database, ray).t, 12, 1e-15);
  database.groups.push_back({.children = database.objects});
  database.objects = {{.kind = scene::Object::Kind::group, .shape = 0}};
  database.objects[0].parent_from_object.matrix[3][2] = 1;
  database.objects[0].parent_from_object.inverse[3][2] = -1;
  EXPECT_NEAR(first_hit(database, ray).t, 13, 1e-15);
}

TEST(ReferenceHits, TakeSolidsAndCombinationsFromTheTracer) {
  scene::Database database = two_balls();
  database.solids.push_back({.kind = scene::SolidKind::sphere, .a = {0, 0, 0}, .radius_a = 3});
  database.objects.push_back({.kind = scene::Object::Kind::solid, .shape = 0});
  const Ray ray = ray_from({0.9, 0, -6}, {0, 0, 1});
  EXPECT_EQ(first_hit(database, ray).knowledge, Knowledge::trusted);
  database.solids[0].radius_a = 0.5;
  EXPECT_EQ(first_hit(database, ray).knowledge, Knowledge::proven);
  const double t = first_hit(database, ray).t;
  database.groups.push_back({.operation = scene::Operation::merge, .children = database.objects});
  database.objects = {{.kind = scene::Object::Kind::group, .shape = 0}};
  EXPECT_EQ(first_hit(database, ray).knowledge, Knowledge::trusted);
  EXPECT_NEAR(first_hit(database, ray).t, t, 1e-14);
}

TEST(ReferenceHits, DrawUnblendedBlobsAsTheirComponents) {
  scene::Database database = two_balls();
  const Ray between = ray_from({0, 0, -6}, {0, 0, 1});
  const double blended = first_hit(database, between).t;
  TracerOptions unblended;
  unblended.unblended = true;
  const double alone = first_hit(database, between, unblended).t;
  EXPECT_NEAR(alone, 6 - std::sqrt(1 - 0.81), 1e-14);
  EXPECT_LT(blended, alone - 0.1);
  database.blobs[0].is_unblended = true;
  EXPECT_EQ(first_hit(database, between).t, alone);
}

TEST(ReferenceHits, TellWhatTheyCannotDecide) {
  scene::Database database = two_balls();
  database.blobs[0].components = GrowingArray<scene::Component>{database.blobs[0].components[1]};
  database.blobs[0].components[0].a = {0, 0, 0};
  EXPECT_EQ(first_hit(database, ray_from({1, 0, -6}, {0, 0, 1})).knowledge, Knowledge::undecided) << "a tangent";
  EXPECT_EQ(first_hit(database, ray_from({1.0000001, 0, -6}, {0, 0, 1})).knowledge, Knowledge::proven);
}

TEST(Comparisons, MeasureEverySettingAgainstTheReference) {
  const scene::Database database = two_balls();
  const TracerOptions exact = options_of(SolverName::exact, database);
  ComparisonOptions options;
  options.width = 40;
  options.height = 30;
  options.rounds = 3;
  double last = 0;
  options.progress = [&last](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  const Comparison comparison =
      compare(database, exact,
              {options_of(SolverName::paper, database), options_of(SolverName::hermite, database), exact}, 1, options);
  ASSERT_TRUE(comparison.complete);
  EXPECT_EQ(last, 1);
  ASSERT_EQ(comparison.settings.size(), 3u);
  const auto& [paper, hermite, same] = std::tie(comparison.settings[0], comparison.settings[1], comparison.settings[2]);
  EXPECT_GT(paper.summary.worst_pixels, 0.01);
  EXPECT_LT(hermite.summary.worst_pixels, 0.05) << "the tolerance promises this";
  EXPECT_LT(same.summary.worst_pixels, 1e-9) << "a solver of its own gives the same places";
  EXPECT_EQ(comparison.reference.proven, 1200u);
  EXPECT_EQ(hermite.relative_time, 1);
  EXPECT_GT(paper.relative_time, 0);
  EXPECT_GT(hermite.evaluations_per_ray, 0.5);
  EXPECT_GT(hermite.solver_steps_per_ray, 0);
  for (const Measured& measured : comparison.settings) {
    EXPECT_EQ(measured.rays.size(), 1200u);
    EXPECT_GT(measured.summary.hits, 50u);
  }
}

Image layers_of(SolverName solver, const PixelRect& window) {
  const scene::Database database = two_balls();
  const TracerOptions options = options_of(solver, database);
  const Tracer tracer(database, options);
  Image image;
  image.full_width = 40;
  image.full_height = 30;
  image.window = window;
  Aovs aovs;
  for (const MeasuredAov& row : measured_aovs()) aovs.push_back(&row.aov);
  EXPECT_FALSE(measure_layers(database, options, tracer, aovs, 0, {}, image).has_value());
  return image;
}

TEST(MeasuredLayers, HoldWhatEachCentreRayCostsAndGetsWrong) {
  const Image image = layers_of(SolverName::paper, {0, 0, 40, 30});
  ASSERT_EQ(image.layers.size(), measured_aovs().size());
  const auto value = [&](const char* layer, std::size_t pixel) { return image.layer(layer)->at(pixel, 0); };
  const std::size_t corner = 0, on_ball = 15 * 40 + 13;
  EXPECT_EQ(value("cost", corner), 0) << "no field reaches the corner";
  EXPECT_EQ(value("error", corner), 0);
  EXPECT_GT(value("cost", on_ball), 0);
  EXPECT_GT(value("solver_steps", on_ball), 0);
  EXPECT_GT(value("error", on_ball), 0);
  for (std::size_t i = 0; i < 1200; ++i) EXPECT_EQ(std::isinf(value("error", i)), value("missed", i) != 0) << i;
}

TEST(MeasuredLayers, AreThoseOfTheWindow) {
  const Image whole = layers_of(SolverName::paper, {0, 0, 40, 30});
  const Image part = layers_of(SolverName::paper, {10, 15, 14, 17});
  ASSERT_EQ(part.layer("error")->values.size(), 2u * 8);
  for (const char* layer : {"error", "cost"}) {
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(part.layer(layer)->at(i, 0), whole.layer(layer)->at(15 * 40 + 10 + i, 0)) << layer << i;
  }
}

TEST(ShadowRays, LeadFromWhatIsSeenToTheLightsBeforeIt) {
  scene::Database database = two_balls();
  database.lights.push_back({.location = {0, 9, -9}});
  database.lights.push_back({.location = {0, 0, 9}});
  database.lights.push_back({.location = {0, 9, -9}, .shadowless = true});
  const Tracer tracer(database, options_of(SolverName::exact, database));
  RecurringAngles angles;
  const std::vector<Ray> seen = {
      CameraRays(*database.camera, 40, 30).through(13, 15, angles)};  // the middle of the left ball
  const std::vector<Ray> shadows = shadow_rays(database, tracer, seen);
  ASSERT_EQ(shadows.size(), 1u) << "one light is behind the surface, one throws none";
  EXPECT_FALSE(shadows[0].start.instance == scene::kNone);
  EXPECT_NEAR((shadows[0].origin + shadows[0].direction * shadows[0].t_max - Vec3(0, 9, -9)).length(), 0, 1e-12);
}

TEST(ShadowSummaries, TellLeaksFromFalseShadows) {
  const std::vector<std::uint8_t> found{0, 1, 0, 1, 0}, truth{0, 1, 1, 0, 1};
  const ShadowSummary summary = summarise_shadows(found, truth);
  EXPECT_EQ(summary.rays, 5u);
  EXPECT_EQ(summary.leaks, 2u);
  EXPECT_EQ(summary.false_shadows, 1u);
}

TEST(Comparisons, EndWhenStopped) {
  const scene::Database database = two_balls();
  const TracerOptions exact = options_of(SolverName::exact, database);
  StopFlag stop;
  stop.set(StopReason::interrupt);
  ComparisonOptions options;
  options.run.stop = &stop;
  EXPECT_FALSE(compare(database, exact, {exact}, 0, options).complete);
}

}  // namespace
}  // namespace isl::render
