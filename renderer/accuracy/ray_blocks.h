// Hands out rays to threads in blocks as large as the batches that rendering traces.
#pragma once

#include "base/parallel.h"
#include "renderer/accuracy/ray_measures.h"
#include "renderer/film/progress.h"

#include <algorithm>
#include <cstddef>

namespace isl::render {

/// Number of rays in a task: the size of a batch (renderer/render.cpp), so that they cost what they cost there.
inline constexpr std::size_t kBlock = 1024;

/// Calls work(first, count) for blocks of at most `size` of `total` rays on all threads, until `stop` is set.
template <class Work>
void in_blocks(std::size_t total, std::size_t size, const StopFlag* stop, const TellProgress& tell, const Work& work) {
  const std::size_t blocks = (total + size - 1) / size;
  Progress progress(tell);
  progress.begin_stage(1, blocks);
  parallel_for(blocks, [&](std::size_t block) {
    if (is_set(stop)) return;
    const std::size_t first = block * size;
    work(first, std::min(size, total - first));
    progress.step();
  });
}
template <class Work>
void in_blocks(std::size_t total, const StopFlag* stop, const TellProgress& tell, const Work& work) {
  in_blocks(total, kBlock, stop, tell, work);
}

}  // namespace isl::render
