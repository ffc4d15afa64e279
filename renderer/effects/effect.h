// One record an effect: when a scene calls for it, what it adds, what leaving it out means. The plan, `isl plan`, `--without`, the
// statistics and the refusals all come from these records; effects.def lists them.
#pragma once

#include "renderer/effects/scene_use.h"
#include "renderer/effects/stages.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isl::render {

/// A kind of statement that calls for an effect: as the language calls it, where the first stands, and how many there are.
struct Request {
  std::string what;
  OriginId origin;      ///< the offending word, where that is known; else what the scene makes use of it by
  OriginId used_by{};   ///< an object or the name of a texture, where `origin` may be in another file; 0: the same
  std::uint64_t count = 1;
};

/// Collects statements, each kind once.
class Requests {
 public:
  /// `word` may be unknown; `user` is what the scene makes use of the statement by.
  void add(std::string_view what, OriginId word, OriginId user);
  void add(std::string_view what, OriginId origin) { add(what, {}, origin); }
  [[nodiscard]] bool empty() const { return requests_.empty(); }
  [[nodiscard]] std::vector<Request> take() { return std::move(requests_); }

 private:
  std::vector<Request> requests_;
};

struct Effect {
  std::string_view name;     ///< what `--without` and `isl plan` call it
  std::string_view summary;  ///< what it adds to a picture, for `isl plan`
  std::string_view rays = {};  ///< what statistics call the rays that it spawns, if it does
  int from_quality = 0;      ///< the least `--quality` that has it, as POV-Ray's +Q …
  int to_quality = 11;       ///< … and the greatest
  /// Adds the statements that call for it. Where there is none, `reason` may be set to why not.
  std::function<void(const SceneUse&, Requests&, std::string_view& reason)> find;
  StageMakers stages = {};
  bool is_rendered = true;  ///< if not, a scene that calls for it is refused
  /// Makes the scene one that does not call for it: needed where that is not rendered, or changes more than stages.
  std::function<void(scene::Database&)> leave_out = {};
};

/// All of them; stages of one kind run in this order.
[[nodiscard]] std::span<const Effect> all_effects();

}  // namespace isl::render
