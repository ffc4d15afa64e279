// Sign changes of polynomials whose roots are known: products of exact linear factors in 200 bits, or hard by
// construction.
#include "renderer/numerics/polynomial_roots.h"
#include "tests/renderer/solids/solid_oracle.h"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

namespace isl::render::test {
namespace {

using Big =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2>>;

/// Π (u − rᵢ) in Bernstein form, rounded once; the band is that rounding.
struct Made {
  Bernstein p;
  double band = 0;
};
Made with_roots(const std::vector<double>& roots, double scale = 1) {
  std::vector<Big> c{Big(scale)};  // coefficients of (1−u)ᵏ⁻ⁱ uⁱ
  for (const double root : roots) {
    std::vector<Big> next(c.size() + 1, Big(0));
    for (std::size_t i = 0; i < c.size(); ++i) {
      next[i] -= c[i] * Big(root);
      next[i + 1] += c[i] * (1 - Big(root));
    }
    c = next;
  }
  Made made;
  made.p.degree = static_cast<int>(roots.size());
  double largest = 0;
  for (int i = 0; i <= made.p.degree; ++i) {
    made.p[i] = static_cast<double>(Big(c[static_cast<std::size_t>(i)] / binomial(made.p.degree, i)));
    largest = std::max(largest, std::abs(made.p[i]));
  }
  made.band = rounding_of_order(made.p.degree) * largest;
  return made;
}

std::vector<double> changes(const Made& made) {
  std::vector<double> found;
  SignFollower follower(0);
  follower.follow(made.p, made.band, [&](double u) { found.push_back(u); });
  return found;
}

void expect_roots(const std::vector<double>& roots, double tolerance, double scale = 1) {
  const std::vector<double> found = changes(with_roots(roots, scale));
  std::vector<double> expected;
  for (const double root : roots) {
    if (root > 0 && root < 1) expected.push_back(root);
  }
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

TEST(SignChanges, of_wilkinsons_kind) {
  expect_roots({0.1, 0.2, 0.3, 0.4}, 1e-14);
  std::vector<double> ten;
  for (int i = 1; i <= 10; ++i) ten.push_back(i / 11.0);
  expect_roots(ten, 1e-9);
}

TEST(SignChanges, of_every_degree_up_to_ten_at_random) {
  Random random(51);
  int lost = 0, all = 0;
  for (int turn = 0; turn < 5000; ++turn) {
    std::vector<double> roots(1 + static_cast<std::size_t>(random.uniform(0, 10)));
    for (double& root : roots) root = random.uniform(-0.5, 1.5);
    const std::vector<double> found = changes(with_roots(roots));
    std::vector<double> expected;
    for (const double root : roots) {
      if (root > 0 && root < 1) expected.push_back(root);
    }
    std::sort(expected.begin(), expected.end());
    ++all;
    // Roots too close to one another for the band are dropped in pairs, never singly.
    ASSERT_EQ((expected.size() - found.size()) % 2, 0u);
    ASSERT_LE(found.size(), expected.size());
    if (found.size() < expected.size()) {
      ++lost;
      continue;
    }
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-4);
  }
  EXPECT_LT(lost, all / 50);
}

TEST(SignChanges, do_not_count_a_touch) {
  EXPECT_TRUE(changes(with_roots({0.5, 0.5})).empty());
  EXPECT_TRUE(changes(with_roots({0.3, 0.3, 0.7, 0.7})).empty());
  const std::vector<double> found = changes(with_roots({0.4, 0.4, 0.8}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 0.8, 1e-12);
  const std::vector<double> triple = changes(with_roots({0.25, 0.25, 0.25}));
  ASSERT_EQ(triple.size(), 1u);
  EXPECT_NEAR(triple[0], 0.25, 1e-4);
}

TEST(SignChanges, of_close_pairs_are_found_or_dropped_together) {
  for (double gap = 1e-2; gap > 1e-13; gap /= 10) {
    const std::vector<double> found = changes(with_roots({0.5, 0.5 + gap, 0.9}));
    ASSERT_TRUE(found.size() == 3 || found.size() == 1) << gap;
    // Between the roots the polynomial is gap²/10, which is above the band of some 1e-15 from here on.
    if (gap > 2e-7) {
      EXPECT_EQ(found.size(), 3u) << gap;
    }
    EXPECT_NEAR(found.back(), 0.9, 1e-12);
  }
}

TEST(SignChanges, at_places_where_intervals_are_halved_count_once) {
  expect_roots({0.5}, 0);
  expect_roots({0.25, 0.5, 0.75}, 1e-15);
  expect_roots({0.125, 0.5 + 0x1p-40}, 1e-12);
}

TEST(SignChanges, do_not_depend_on_the_scale) {
  expect_roots({0.1, 0.2, 0.3, 0.4}, 1e-14, 1e-200);
  expect_roots({0.1, 0.2, 0.3, 0.4}, 1e-14, 1e200);
}

TEST(SignChanges, of_nothing_and_of_no_number_are_none) {
  Made zero = with_roots({0.5, 0.2});
  for (int i = 0; i <= 2; ++i) zero.p[i] = 0;
  EXPECT_TRUE(changes(zero).empty());
  for (int i = 0; i <= 2; ++i) zero.p[i] = std::nan("");
  EXPECT_TRUE(changes(zero).empty());
}

TEST(SignChanges, after_a_known_root_are_those_of_the_quotient) {
  Made made = with_roots({0, 0.25, 0.75});
  made.p[0] = 0;
  SignFollower follower(0);
  std::vector<double> found;
  follower.follow(over_u(made.p), 3 * made.band, [&](double u) { found.push_back(u); });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.25, 1e-14);
  EXPECT_NEAR(found[1], 0.75, 1e-14);
  EXPECT_EQ(follower.sign(), 1);
}

TEST(SignChanges, of_two_pieces_join_at_a_root_between_them) {
  // u − 1, then u: the root is where the pieces meet.
  SignFollower follower(0);
  int count = 0;
  Made left = with_roots({1.0}), right = with_roots({0.0});
  follower.follow(left.p, left.band, [&](double) { ++count; });
  follower.follow(right.p, right.band, [&](double u) {
    ++count;
    EXPECT_EQ(u, 0);
  });
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace isl::render::test
