#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace isl {
namespace {

TEST(Parallel, EachIndexHasItsCall) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> calls(1000);
    with_threads(threads, [&] { parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; }); });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads << " threads";
  }
}

TEST(Parallel, ALoopOfNothingEnds) {
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(Parallel, LoopsMayNest) {
  std::vector<std::vector<int>> calls(20, std::vector<int>(30));
  with_threads(2, [&] {
    parallel_for(calls.size(),
                 [&](std::size_t i) { parallel_for(calls[i].size(), [&, i](std::size_t j) { ++calls[i][j]; }); });
  });
  EXPECT_EQ(calls, std::vector(20, std::vector<int>(30, 1)));
}

TEST(Parallel, WhatACallThrowsIsThrown) {
  const auto fail = [](std::size_t i) {
    if (i == 17) throw std::runtime_error("seventeen");
  };
  for (const int threads : {1, 2})
    EXPECT_THROW(with_threads(threads, [&] { parallel_for(100, fail); }), std::runtime_error) << threads << " threads";
}

TEST(Parallel, OneThreadIsTheOneThatCalls) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  with_threads(1, [&] {
    parallel_for(5, [&](std::size_t i) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      order.push_back(i);
    });
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Parallel, EachThreadKeepsItsOwn) {
  PerThread<std::size_t> sums;
  with_threads(3, [&] { parallel_for(1001, [&](std::size_t i) { sums.local() += i; }); });
  std::size_t total = 0;
  sums.for_each([&](std::size_t sum) { total += sum; });
  EXPECT_EQ(total, 1000u * 1001u / 2);
}

}  // namespace
}  // namespace isl
