// How much of their bound of steps the rays of a picture take (rays/ray_steps.h). A ray that takes all of it takes some
// milliseconds, and a picture of such rays hours. So rays take a tenth at first. A batch in which that is not enough
// for one of them is traced again with the whole bound, unless the picture is hard, because too many of its rays take
// much of the bound and stay undecided: then all rays make do with a tenth.
//
// Only the scene and the size of the whole picture decide this. So a pixel is the same with any number of threads, and
// in a part of the picture.
#pragma once

#include "renderer/integrator/integrator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace isl::render {

[[nodiscard]] constexpr std::uint64_t tenth_of(std::uint64_t bound) { return bound / 10 + 1; }

/// The integrator of a picture whose rays take their whole bound. It is made, and the picture judged, when a ray first
/// needs more than a tenth.
class WholeBound {
 public:
  explicit WholeBound(std::function<std::unique_ptr<const Integrator>()> make) : make_(std::move(make)) {}

  /// Null if the picture is hard: is_hard(integrator) is asked once, by one thread, while others wait.
  template <class IsHard>
  [[nodiscard]] const Integrator* integrator(const IsHard& is_hard) const {
    std::call_once(once_, [&] {
      integrator_ = make_();
      is_hard_ = is_hard(*integrator_);
    });
    return is_hard_ ? nullptr : integrator_.get();
  }
  /// Why the rendering cannot go on, if such an integrator has found out.
  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const {
    static const std::optional<scene::Refusal> kNone;
    return integrator_ ? integrator_->refusal() : kNone;
  }

 private:
  std::function<std::unique_ptr<const Integrator>()> make_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Integrator> integrator_;
  mutable bool is_hard_ = false;
};

}  // namespace isl::render
