#include "renderer/queries/inside.h"

#include "base/check.h"
#include "renderer/fields/component_table.h"
#include "renderer/solids/solid.h"

#include <cmath>
#include <vector>

namespace isl::render {

using scene::Component;
using scene::Database;
using scene::Object;
using scene::Operation;
using scene::Solid;

namespace {

/// Components of a blob that are evaluated in the time of a step.
constexpr std::size_t kComponentsOfStep = 64;

/// A database with its kernels, asked about insides. `is_inverse`: the outside is asked for; open surfaces have
/// neither, so that a negation is handed down to the leaves. The operations that are being evaluated are a list instead
/// of recursion, so that depth costs no stack.
class Membership {
 public:
  Membership(const Database& database, const std::vector<KernelConstants>& kernels, StepCounter& steps)
      : database_(database), kernels_(kernels), steps_(steps) {}

  /// `point` is in the space that the object is placed into.
  [[nodiscard]] bool holds(const Object& object, bool is_inverse, const Vec3& point) {
    ask(object, is_inverse, point);
    while (!open_.empty()) {
      if (steps_.is_spent()) return false;
      Operator& innermost = open_.back();
      if (answer_ != innermost.wants_all || innermost.next == innermost.count) {
        open_.pop_back();
      } else {
        ask_next(innermost);
      }
    }
    return answer_;
  }

 private:
  /// `wants_all`: true for "and", false for "or". The answer of an operand that differs from it is the operator's, and
  /// if there is none, the last operand's is.
  struct Operator {
    const Object* clipped;  ///< its shape and its clip are the operands; null: the group's children are
    const scene::Group* group;
    bool is_inverse;
    bool wants_all;
    std::size_t count;  ///< of operands
    Vec3 point;
    std::size_t next = 0;
  };

  void open(const Operator& operation) {
    answer_ = operation.wants_all;
    open_.push_back(operation);
  }

  void ask_next(Operator& innermost) {
    const Operator asked = innermost;  // a copy, because opening an operand moves the list
    ++innermost.next;
    if (asked.clipped && asked.next == 0)
      return ask_shape(*asked.clipped, asked.is_inverse != asked.clipped->inverse, asked.point);
    if (asked.clipped) return ask(database_.groups[index(asked.clipped->clip)], asked.is_inverse, asked.point);
    const bool is_taken_away = asked.group->operation == Operation::subtract && asked.next > 0;
    ask(asked.group->children[asked.next], asked.is_inverse != is_taken_away, asked.point);
  }

  void ask(const Object& object, bool is_inverse, const Vec3& point) {
    if (!steps_.take()) return;
    const Vec3 p = object.parent_from_object.inverse_point(point);
    if (object.clip == scene::kNoGroup) return ask_shape(object, is_inverse != object.inverse, p);
    // The outside of a clipped object is outside the shape or outside the clip.
    open({&object, nullptr, is_inverse, !is_inverse, 2, p});
  }

  void ask(const scene::Group& group, bool is_inverse, const Vec3& point) {
    if (group.children.empty()) {
      answer_ = is_inverse;
      return;
    }
    const bool is_union = group.operation == Operation::unite || group.operation == Operation::merge;
    open({nullptr, &group, is_inverse, is_union == is_inverse, group.children.size(), point});
  }

  void ask_shape(const Object& object, bool is_inverse, const Vec3& point) {
    switch (object.kind) {
      case Object::Kind::solid: {
        const Solid& solid = database_.solids[object.shape];
        answer_ = !is_open_surface(solid) && is_inside(database_, solid, point) != is_inverse;
        return;
      }
      case Object::Kind::blob:
        answer_ = steps_.take(database_.blobs[object.shape].components.size() / kComponentsOfStep) &&
                  is_inside(database_, kernels_, database_.blobs[object.shape], point) != is_inverse;
        return;
      case Object::Kind::group: return ask(database_.groups[object.shape], is_inverse, point);
    }
    ISL_CHECK(false, "object kind {}", static_cast<int>(object.kind));
  }

  const Database& database_;
  const std::vector<KernelConstants>& kernels_;
  StepCounter& steps_;
  std::vector<Operator> open_;
  bool answer_ = false;  ///< of what was asked last
};

}  // namespace

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
               const Vec3& point) {
  const auto field_of = [&](const Component& c) {
    return field_at(database, blob, c, kernels[index(c.kernel)], point);
  };
  if (blob.is_unblended) {
    return std::ranges::any_of(blob.components, [&](const Component& c) { return field_of(c) >= blob.threshold; });
  }
  std::vector<double> sums(std::max<std::size_t>(blob.branches.size(), 1));
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    sums[blob.branches.empty() ? 0 : blob.branch_of[i]] += field_of(blob.components[i]);
  }
  BranchTree({blob.branches.begin(), blob.branches.end()}).add_up(sums);
  return sums[0] >= blob.threshold;
}

bool is_inside(const Database& database, const std::vector<KernelConstants>& kernels, const Object& object,
               const Vec3& point, StepCounter& steps) {
  return Membership(database, kernels, steps).holds(object, false, point);
}

}  // namespace isl::render
