#include "renderer/queries/inside.h"

#include "base/check.h"
#include "renderer/fields/component_table.h"
#include "renderer/queries/box_indexes.h"
#include "renderer/queries/set_logic.h"
#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace isl::render {

using scene::Component;
using scene::Database;
using scene::Object;
using scene::Solid;

namespace {

/// Components of a blob that are evaluated in the time of a step.
constexpr std::size_t kComponentsOfStep = 64;

/// The field of a blob whose components blend.
double blended_field(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
                     const Vec3& point) {
  std::vector<double> sums(std::max<std::size_t>(blob.branches.size(), 1));
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    const Component& c = blob.components[i];
    sums[blob.branches.empty() ? 0 : blob.branch_of[i]] += field_at(database, blob, c, kernels[index(c.kernel)], point);
  }
  BranchTree({blob.branches.begin(), blob.branches.end()}).add_up(sums);
  return sums[0];
}

/// A database with its kernels, asked about insides. `is_inverse`: the outside is asked for; open surfaces have
/// neither, so that a negation is handed down to the leaves. The operations that are being evaluated are a list instead
/// of recursion, so that depth costs no stack.
class Membership {
 public:
  Membership(const Database& database, const std::vector<KernelConstants>& kernels, BoxIndexes* indexes,
             StepCounter& steps)
      : database_(database), kernels_(kernels), indexes_(indexes), steps_(steps) {}

  /// `point` is in the space that the object is placed into.
  [[nodiscard]] bool holds(const Object& object, bool is_inverse, const Vec3& point) {
    ask(object, is_inverse, point);
    while (!open_.empty()) {
      if (steps_.is_spent()) return false;
      Operator& innermost = open_.back();
      if (answer_ == innermost.wants_all && innermost.next == innermost.end) search(innermost);
      if (answer_ != innermost.wants_all || innermost.next == innermost.end) {
        found_.resize(innermost.first_found);
        open_.pop_back();
      } else {
        ask_next(innermost);
      }
    }
    return answer_;
  }

  /// The field of a blob; 0 if there are no steps for it.
  [[nodiscard]] double field(std::uint32_t number, const Vec3& point) {
    const scene::Blob& blob = database_.blobs[number];
    const BoxIndexes::OfBlob* const index = indexes_ ? indexes_->of_blob(number) : nullptr;
    if (index && !blob.is_unblended) {
      return ask_near(*index, blob, point, 0.0,
                      [&](std::span<std::uint32_t> near) { return field_by(*index, blob, near, point); });
    }
    if (!steps_.take(blob.components.size() / kComponentsOfStep)) return 0;
    if (!blob.is_unblended) return blended_field(database_, kernels_, blob, point);
    double greatest = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < blob.components.size(); ++i) greatest = std::max(greatest, field_of(blob, i, point));
    return greatest;
  }

 private:
  /// `wants_all`: true for "and", false for "or". The answer of an operand that differs from it is the operator's, and
  /// if there is none, the last operand's is.
  struct Operator {
    const Object* clipped;  ///< its shape and its clip are the operands; null: the group's children are
    const scene::Group* group;
    bool is_inverse;
    bool wants_all;
    Vec3 point;
    std::size_t end;           ///< number of operands
    const BoxIndex* index;     ///< of the children: those that are everywhere are the operands, then those found
    std::size_t first_found;   ///< place in found_
    bool is_searched = false;  ///< the children in the index have been found
    std::size_t next = 0;

    [[nodiscard]] std::size_t child(std::size_t operand, std::span<const std::uint32_t> found) const {
      if (!index) return operand;
      const std::span<const std::uint32_t> everywhere = index->everywhere();
      return operand < everywhere.size() ? everywhere[operand] : found[first_found + operand - everywhere.size()];
    }
  };

  void open(const Operator& operation) {
    answer_ = operation.wants_all;
    open_.push_back(operation);
  }

  /// Adds the operands that an index finds, once those that are everywhere have not decided.
  void search(Operator& innermost) {
    if (!innermost.index || innermost.is_searched) return;
    innermost.is_searched = true;
    innermost.index->append_around(innermost.point, found_);
    innermost.end += found_.size() - innermost.first_found;
  }

  void ask_next(Operator& innermost) {
    const Operator asked = innermost;  // a copy, because opening an operand moves the list
    ++innermost.next;
    if (asked.clipped && asked.next == 0)
      return ask_shape(*asked.clipped, asked.is_inverse != asked.clipped->inverse, asked.point);
    if (asked.clipped) return ask_group(index(asked.clipped->clip), asked.is_inverse, asked.point);
    const std::size_t child = asked.child(asked.next, found_);
    ask(asked.group->children[child], is_asked_inverse(*asked.group, child, asked.is_inverse), asked.point);
  }

  void ask(const Object& object, bool is_inverse, const Vec3& point) {
    if (!steps_.take()) return;
    const Vec3 p = object.parent_from_object.inverse_point(point);
    if (object.clip == scene::kNoGroup) return ask_shape(object, is_inverse != object.inverse, p);
    // The outside of a clipped object is outside the shape or outside the clip.
    open({&object, nullptr, is_inverse, !is_inverse, p, 2, nullptr, found_.size()});
  }

  void ask_group(std::uint32_t number, bool is_inverse, const Vec3& point) {
    const scene::Group& group = database_.groups[number];
    if (group.children.empty()) {
      answer_ = is_inverse;
      return;
    }
    const BoxIndex* const index = indexes_ ? indexes_->of_group(number, is_inverse) : nullptr;
    const std::size_t operands = index ? index->everywhere().size() : group.children.size();
    open({nullptr, &group, is_inverse, wants_all(group, is_inverse), point, operands, index, found_.size()});
  }

  void ask_shape(const Object& object, bool is_inverse, const Vec3& point) {
    switch (object.kind) {
      case Object::Kind::solid: {
        const Solid& solid = database_.solids[object.shape];
        answer_ = !is_open_surface(solid) && is_inside(database_, solid, point) != is_inverse;
        return;
      }
      case Object::Kind::blob: answer_ = is_in_blob(object.shape, point) != is_inverse; return;
      case Object::Kind::group: return ask_group(object.shape, is_inverse, point);
    }
    ISL_CHECK(false, "object kind {}", static_cast<int>(object.kind));
  }

  [[nodiscard]] bool is_in_blob(std::uint32_t number, const Vec3& point) {
    const scene::Blob& blob = database_.blobs[number];
    const BoxIndexes::OfBlob* const index = indexes_ ? indexes_->of_blob(number) : nullptr;
    if (!index) {
      return steps_.take(blob.components.size() / kComponentsOfStep) && is_inside(database_, kernels_, blob, point);
    }
    return ask_near(*index, blob, point, false, [&](std::span<std::uint32_t> near) {
      if (!blob.is_unblended) return field_by(*index, blob, near, point) >= blob.threshold;
      const bool is_beyond_any = near.size() < blob.components.size() && 0 >= blob.threshold;
      return is_beyond_any ||
             std::ranges::any_of(near, [&](auto i) { return field_of(blob, i, point) >= blob.threshold; });
    });
  }

  /// ask(the components whose fields may not be 0), or `otherwise` if there are no steps for it.
  template <class Answer, class Ask>
  [[nodiscard]] Answer ask_near(const BoxIndexes::OfBlob& index, const scene::Blob& blob, const Vec3& point,
                                Answer otherwise, const Ask& ask) {
    const std::size_t first = found_.size();
    const std::span<const std::uint32_t> everywhere = index.components->everywhere();
    found_.insert(found_.end(), everywhere.begin(), everywhere.end());
    index.components->append_around(point, found_);
    const auto near = std::span(found_).subspan(first);
    for (const std::uint32_t i : near) __builtin_prefetch(&blob.components[i]);
    const Answer answer = steps_.take(near.size() / kComponentsOfStep) ? ask(near) : otherwise;
    found_.resize(first);
    return answer;
  }

  [[nodiscard]] double field_of(const scene::Blob& blob, std::uint32_t component, const Vec3& point) const {
    const Component& c = blob.components[component];
    return field_at(database_, blob, c, kernels_[scene::index(c.kernel)], point);
  }

  /// The field from the components that may not be 0 there, if they blend. Their sums are made in the same order as
  /// those of all, and what is left out would add 0 to them, so that they are the same to the last digit.
  [[nodiscard]] double field_by(const BoxIndexes::OfBlob& index, const scene::Blob& blob, std::span<std::uint32_t> near,
                                const Vec3& point) {
    const auto branch_of = [&](std::uint32_t i) { return blob.branches.empty() ? 0 : blob.branch_of[i]; };
    std::ranges::sort(near, {}, [&](std::uint32_t i) { return std::pair(branch_of(i), i); });
    sums_.clear();
    for (const std::uint32_t i : near) {
      if (sums_.empty() || sums_.back().branch != branch_of(i)) sums_.push_back({branch_of(i), 0});
      sums_.back().value += field_of(blob, i, point);
    }
    return index.branches.field(sums_);
  }

  const Database& database_;
  const std::vector<KernelConstants>& kernels_;
  BoxIndexes* indexes_;  ///< null: every part is asked
  StepCounter& steps_;
  std::vector<Operator> open_;
  std::vector<std::uint32_t> found_;   ///< the operands of the open operations that an index found
  std::vector<BranchSums::Sum> sums_;  ///< working memory
  bool answer_ = false;                ///< of what was asked last
};

}  // namespace

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
               const Vec3& point) {
  if (!blob.is_unblended) return blended_field(database, kernels, blob, point) >= blob.threshold;
  return std::ranges::any_of(blob.components, [&](const Component& c) {
    return field_at(database, blob, c, kernels[index(c.kernel)], point) >= blob.threshold;
  });
}

double field_of(const Database& database, const std::vector<KernelConstants>& kernels, std::uint32_t blob,
                const Vec3& point, StepCounter& steps, BoxIndexes* indexes) {
  return Membership(database, kernels, indexes, steps).field(blob, point);
}

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const Object& object,
               const Vec3& point, StepCounter& steps, BoxIndexes* indexes) {
  return Membership(database, kernels, indexes, steps).holds(object, false, point);
}

}  // namespace isl::render
