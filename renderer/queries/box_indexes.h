// The indexes of a database's blobs and groups, for questions about insides. Each is built after some questions,
// when it pays, and kept: shapes are shared, so all instances of a blob have one.
#pragma once

#include "base/run_limits.h"
#include "renderer/queries/box_index.h"
#include "renderer/queries/branch_sums.h"
#include "renderer/queries/enclosures.h"
#include "renderer/scene/database.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace isl::render {

/// Serves a database that may grow. Several threads may ask at the same time, but not while it follows the database.
class BoxIndexes {
 public:
  /// The indexes charge the budget of `run`. What it has no room for is asked without them. `kernels` are those of the
  /// database.
  BoxIndexes(const scene::Database& database, const std::vector<KernelConstants>& kernels, const RunLimits& run)
      : database_(database), kernels_(kernels), run_(run), enclosures_(database, kernels) {}

  /// Called when the database may have grown.
  void follow();

  struct OfBlob {
    std::unique_ptr<const BoxIndex> components;
    BranchSums branches;
    Charge charge;  ///< of the branches
  };
  /// The components whose fields may not be 0. Null if there is no index yet.
  [[nodiscard]] const OfBlob* of_blob(std::uint32_t blob);
  /// The children that may decide whether a point is inside the group, or outside of it: all others leave the answer to
  /// these. Null if there is no index yet.
  [[nodiscard]] const BoxIndex* of_group(std::uint32_t group, bool is_inverse);

 private:
  /// An index that is not built before it pays.
  template <class Index>
  class Slot {
   public:
    /// Counts a question, and calls build() at the right one.
    template <class Build>
    [[nodiscard]] const Index* get(std::mutex& building, const Build& build);

   private:
    std::atomic<const Index*> ready_ = nullptr;
    std::atomic<std::uint32_t> questions_ = 0;  ///< since the last try
    std::unique_ptr<const Index> index_;
  };

  [[nodiscard]] std::unique_ptr<const OfBlob> build_blob(const scene::Blob& blob);
  [[nodiscard]] std::unique_ptr<const BoxIndex> build_group(const scene::Group& group, bool is_inverse);

  const scene::Database& database_;
  const std::vector<KernelConstants>& kernels_;
  RunLimits run_;
  Enclosures enclosures_;
  std::mutex building_;  ///< guards `enclosures_` and the slots' `index_`
  std::deque<Slot<OfBlob>> blobs_;
  std::deque<std::array<Slot<BoxIndex>, 2>> groups_;  ///< by whether the outside is asked for
};

}  // namespace isl::render
