// Each effect has one record: when a scene calls for it, what it adds, and what leaving it out means. The plan, `isl
// plan`, `--without`, the statistics and the refusals all come from these records; effects.def lists them.
#pragma once

#include "renderer/effects/scene_use.h"
#include "renderer/effects/stages.h"
#include "renderer/scene/statement.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isl::render {

/// A kind of statement that calls for an effect: its name in the language, where the first one stands, and how many
/// there are.
struct Request {
  std::string what;
  OriginId origin;     ///< the offending word, if it is known; else the place of what uses it
  OriginId used_by{};  ///< an object or the name of a texture, if `origin` may be in another file; 0: the same
  std::uint64_t count = 1;
};

/// Collects statements, each kind once.
class Requests {
 public:
  /// `word` may be unknown; `user` is the object or name through which the scene uses the statement.
  void add(std::string_view what, OriginId word, OriginId user);
  void add(std::string_view what, OriginId origin) { add(what, {}, origin); }
  [[nodiscard]] bool empty() const { return requests_.empty(); }
  [[nodiscard]] std::vector<Request> take() { return std::move(requests_); }

 private:
  std::vector<Request> requests_;
};

struct Effect {
  std::string_view name;                            ///< its name for `--without` and `isl plan`
  std::string_view summary;                         ///< one line for `isl plan`: what it adds to a picture
  std::string_view rays = {};                       ///< name in statistics of the rays that it spawns, if it does
  int from_quality = 0;                             ///< the lowest `--quality` that has it, as POV-Ray's +Q
  int to_quality = 11;                              ///< the highest `--quality` that has it
  bool is_soft = false;                             ///< a mean over a pixel's samples, which has noise
  std::string_view replaces = {};                   ///< an effect whose stages do not run beside it
  const scene::StatementKind* statement = nullptr;  ///< a statement that no other effect knows
  /// Adds the statements that call for it. If there is none, `reason` may be set to why not.
  std::function<void(const SceneUse&, Requests&, std::string_view& reason)> find;
  StageMakers stages = {};
  bool is_rendered = true;                        ///< if not, a scene that calls for it is refused
  std::string_view lack = "is not rendered yet";  ///< what a refusal says of it
  /// Changes the scene so that it does not call for it. Needed if the effect is not rendered, or changes more than
  /// stages.
  std::function<void(scene::Database&)> leave_out = {};
};

/// Calls visit(record, origin) with each of the scene's statements of that kind, whose records are of type Record.
template <class Record, class Visit>
void for_each_statement(const scene::Database& database, const scene::StatementKind& kind, Visit&& visit) {
  for (const scene::Statement& statement : database.statements) {
    if (statement.kind == &kind) visit(statement.as<Record>(), statement.origin);
  }
}

/// All effects. Stages of one kind run in this order.
[[nodiscard]] std::span<const Effect> all_effects();

}  // namespace isl::render
