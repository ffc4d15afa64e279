// `blob { … }`: components with POV-Ray's meaning (radius of the support), or, with a kernel in force, ordinary solids
// as skeletons (radius of the surface that each has alone).
#include "interpreter/expressions.h"
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/blob_component.h"
#include "interpreter/readers/objects.h"
#include "interpreter/readers/surface.h"
#include "interpreter/readers/texture.h"
#include "interpreter/readers/transform.h"
#include "interpreter/transforms.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Component;
using scene::Kernel;
using scene::KernelShape;
using scene::RadiusMeaning;
using scene::Skeleton;
using scene::Vec3;
namespace word = grammar::word;

/// Beyond it a component's field is a step within a hundredth of its radius.
constexpr double kMaxHardness = 500;

constexpr grammar::Symbol kOther[] = {word::kw_component, word::kw_threshold, word::kw_strength, word::kw_pigment,
                                      word::kw_texture};

/// What may stand in a blob, for suggestions.
const std::vector<grammar::Symbol>& known_words() {
  static const std::vector<grammar::Symbol> words = [] {
    std::vector<grammar::Symbol> all(component_words().begin(), component_words().end());
    all.insert(all.end(), std::begin(kOther), std::end(kOther));
    return all;
  }();
  return words;
}

class BlobReader {
 public:
  BlobReader(ElementStream& stream, ObjectDraft& draft) : stream_(stream), context_(stream.context()), draft_(draft) {}

  void read() {
    while (!stream_.peek().is(ElementKind::end) && !draft_.has_modifiers) {
      if (!read_item()) return;
    }
    if (blob_.components.empty()) context_.warn(stream_.span(), "a blob without components is empty");
    check_threshold();
    draft_.object.kind = scene::Object::Kind::blob;
    draft_.object.shape = static_cast<std::uint32_t>(context_.database.blobs.size());
    context_.database.blobs.push_back(std::move(blob_));
  }

 private:
  /// False when the whole blob was copied from another.
  bool read_item() {
    const Element next = stream_.peek();
    if (next.is(ElementKind::block)) {
      if (is_component_word(next.word)) {
        stream_.drop();
        read_component(next);
        return true;
      }
    } else if (next.is(ElementKind::word)) {
      if (next.word == word::kw_threshold) {
        stream_.drop();
        threshold_span_ = stream_.peek().span;
        blob_.threshold = read_number(stream_, "a number after `threshold`");
        return true;
      }
      if (next.word == word::kw_component) {
        stream_.drop();
        read_old_component(next);
        return true;
      }
      if (next.word == word::kw_sturm || next.word == word::kw_hierarchy) {
        stream_.drop();
        static_cast<void>(read_optional_truth(stream_));
        return true;
      }
    } else if (leading_name(next) == context_.words.kernel) {
      read_kernel();
      return true;
    } else if (next.is(ElementKind::value)) {
      return !read_copy();
    }
    if (!read_object_modifier(stream_, draft_)) refuse(stream_, known_words());
    return true;
  }

  bool read_copy() {
    const SourceSpan span = stream_.peek().span;
    const Value value = stream_.take_value();
    const bool is_blob = value.kind() == ValueKind::object && value.as<ObjectValue>().word == word::kw_blob;
    if (!is_blob || !blob_.components.empty()) {
      context_.fail(span, fmt::format("expected a component, found {}", describe(value)));
    }
    copy_object(stream_, value.as<ObjectValue>(), draft_);
    return true;
  }

  /// `kernel "gaussian" hardness 4`
  void read_kernel() {
    stream_.drop();
    const SourceSpan span = stream_.peek().span;
    const std::string name = read_string(stream_, "a kernel's name as a string");
    const auto* const known = std::ranges::find(scene::kKernelWords, name);
    if (known == std::end(scene::kKernelWords)) {
      context_.fail(span, fmt::format("there is no kernel \"{}\"", name),
                    fmt::format("there are \"{}\"", fmt::join(scene::kKernelWords, "\", \"")));
    }
    const auto shape = static_cast<KernelShape>(known - std::begin(scene::kKernelWords));
    Kernel kernel{shape, RadiusMeaning::surface, 4};
    if (leading_name(stream_.peek()) == context_.words.hardness) {
      const SourceSpan hardness_span = stream_.peek().span;
      kernel.hardness = read_contextual_number(stream_, "a number after `hardness`");
      if (!(kernel.hardness > 0 && kernel.hardness <= kMaxHardness)) {
        context_.fail(hardness_span,
                      fmt::format("`hardness` is above 0 and at most {:g}, found {:g}", kMaxHardness, kernel.hardness));
      }
    }
    kernel_ = kernel_id(kernel);
    is_ours_ = true;
  }

  scene::KernelId kernel_id(const Kernel& kernel) {
    auto& kernels = context_.database.kernels;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      if (kernels[i] == kernel) return scene::KernelId{static_cast<std::uint16_t>(i)};
    }
    if (kernels.size() == 0xFFFF) context_.stop(stream_.span(), "a scene has at most 65535 kernels");
    kernels.push_back(kernel);
    return scene::KernelId{static_cast<std::uint16_t>(kernels.size() - 1)};
  }

  // ---- Components ---------------------------------------------------------------------------------------------------

  void read_component(const Element& block) {
    ElementStream stream(context_, block);
    Component component = read_component_shape(stream, block, is_ours_, blob_);
    read_strength(stream, component);
    finish(stream, component, block.span);
  }

  /// POV-Ray's components need a strength, the word is optional; ours may have one, with the word.
  void read_strength(ElementStream& stream, Component& component) {
    const bool has_comma = stream.accept_comma();
    const bool has_word = stream.peek().is_word(word::kw_strength);
    if (has_word) stream.drop();
    if (is_ours_ && !has_word) {
      if (stream.peek().is(ElementKind::value)) {
        context_.fail(stream.peek().span, "with a kernel in force a strength is written `strength s`");
      }
      if (has_comma) fail_expected(stream, "`strength`");
      return;
    }
    const SourceSpan span = stream.peek().span;
    component.strength = read_number(stream, "a strength");
    if (!std::isfinite(component.strength))
      context_.fail(span, fmt::format("a strength is finite, found {:g}", component.strength));
    if (component.strength == 0) context_.warn(span, "a component of strength zero changes nothing");
  }

  /// `component strength, radius, <centre>` of POV-Ray 1, without braces and modifiers.
  void read_old_component(const Element& keyword) {
    Component component;
    component.strength = read_number(stream_, "a strength");
    stream_.accept_comma();
    component.radius_a = component.radius_b = read_positive(stream_, "a radius");
    stream_.accept_comma();
    component.a = read_vector(stream_, "the centre of the component");
    add(component, keyword.span);
  }

  void finish(ElementStream& stream, Component& component, SourceSpan span) {
    if (!stream.peek().is(ElementKind::end)) read_modifiers(stream, component);
    add(component, span);
  }

  void read_modifiers(ElementStream& stream, Component& component) {
    std::optional<scene::Texture> texture;
    std::optional<scene::Transform> blob_from_component;
    while (!stream.peek().is(ElementKind::end)) {
      if (read_texture_modifier(stream, texture, blob_from_component.value_or(scene::Transform()))) continue;
      if (const std::optional<scene::Transform> next = read_transform(stream)) {
        blob_from_component = blob_from_component ? scene::then(*blob_from_component, *next) : *next;
      } else {
        refuse(stream, known_words());
      }
    }
    if (texture && blob_from_component) {
      texture = moved(context_, *texture, *blob_from_component, Move::with_object);
    }
    if (texture) component.texture = texture_id(context_, *texture);
    if (blob_from_component) move(component, *blob_from_component);
  }

  /// A similarity keeps a point, segment or cone what it is; any other map, and of any other skeleton, stays beside the
  /// component.
  void move(Component& component, const scene::Transform& blob_from_component) {
    const bool has_ends = component.skeleton == Skeleton::segment || component.skeleton == Skeleton::cone;
    const double factor =
        has_ends || component.skeleton == Skeleton::point ? similarity_factor(blob_from_component.matrix) : 0;
    if (factor > 0) {
      component.a = blob_from_component.point(component.a);
      component.b = component.skeleton == Skeleton::point ? Vec3(0) : blob_from_component.point(component.b);
      component.radius_a *= factor;
      component.radius_b *= factor;
    } else {
      component.transform = scene::TransformId{static_cast<std::uint32_t>(context_.database.transforms.size())};
      context_.database.transforms.push_back(blob_from_component);
    }
  }

  void add(Component& component, SourceSpan span) {
    if (!has_kernel_) {
      if (!is_ours_) kernel_ = kernel_id(Kernel{});
      has_kernel_ = true;
    }
    component.kernel = kernel_;
    context_.count_primitive(span, sizeof(Component) + sizeof(OriginId) + kOriginBytes);
    blob_.components.push_back(component);
    blob_.origins.push_back(context_.origin(span));
  }

  /// The surface of threshold zero is where the fields end: no surface at all.
  void check_threshold() {
    if (blob_.threshold > 0 && std::isfinite(blob_.threshold)) return;
    context_.fail(threshold_span_, fmt::format("`threshold` is above 0, found {:g}", blob_.threshold));
  }

  ElementStream& stream_;
  Context& context_;
  ObjectDraft& draft_;
  scene::Blob blob_;
  SourceSpan threshold_span_;
  scene::KernelId kernel_{};
  bool is_ours_ = false;     ///< a kernel is in force
  bool has_kernel_ = false;  ///< kernel_ is one of the database
};

}  // namespace

void read_blob(ElementStream& stream, ObjectDraft& draft) { BlobReader(stream, draft).read(); }

}  // namespace isl::interpreter
