// `blob { … }`: components with POV-Ray's meaning (radius of the support), or, with a kernel in force, ordinary solids
// as skeletons (radius of the surface that each has alone).
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/blob_assembly.h"
#include "interpreter/readers/objects/blob_component.h"
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/textures/surface.h"
#include "interpreter/readers/textures/texture.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Component;
using scene::Kernel;
using scene::KernelShape;
using scene::RadiusMeaning;
namespace word = grammar::word;

/// With a larger value a component's field is a step within a hundredth of its radius.
constexpr double kMaxHardness = 500;

constexpr grammar::Symbol kOther[] = {word::kw_component, word::kw_threshold, word::kw_strength, word::kw_pigment,
                                      word::kw_texture,   word::kw_blob,      word::kw_union};

/// The words that a blob accepts, for suggestions.
const std::vector<grammar::Symbol>& known_words() {
  static const std::vector<grammar::Symbol> words = [] {
    std::vector<grammar::Symbol> all(component_words().begin(), component_words().end());
    all.insert(all.end(), std::begin(kOther), std::end(kOther));
    return all;
  }();
  return words;
}

/// The kernel in force, which a blob hands down to the parts inside it.
struct KernelInForce {
  Kernel kernel;
  scene::KernelId id{};
  bool is_ours = false;   ///< the scene named one
  bool is_known = false;  ///< `id` is the kernel's in the database

  [[nodiscard]] bool is_convolved() const { return kernel.mode == scene::FieldMode::convolution; }
};

class BlobReader {
 public:
  BlobReader(ElementStream& stream, ObjectDraft& draft) : stream_(stream), context_(stream.context()), draft_(draft) {}

  /// Reads the items up to the first modifier.
  void read_items() {
    while (!stream_.peek().is(ElementKind::end) && !draft_.has_modifiers) {
      if (!read_item()) break;
    }
    assembly_.set_threshold(usable_threshold());
  }

  /// Completes a blob that is an object of its own.
  void finish() {
    if (is_copy_) return;
    if (assembly_.blob().components.empty()) context_.warn(stream_.span(), "this blob has no components and is empty");
    assembly_.check_choices(stream_.span());
    if (assembly_.threshold() < 0) turn_inside_out();
    draft_.object.kind = scene::Object::Kind::blob;
    draft_.object.shape = static_cast<std::uint32_t>(context_.database.blobs.size());
    context_.database.blobs.push_back(assembly_.take());
  }

 private:
  /// A reader for a part of another blob.
  BlobReader(ElementStream& stream, ObjectDraft& draft, const KernelInForce& kernel)
      : stream_(stream), context_(stream.context()), draft_(draft), kernel_(kernel), is_part_(true) {}

  /// Returns false when the whole blob was copied from another.
  bool read_item() {
    const Element next = stream_.peek();
    if (next.is(ElementKind::block)) {
      if (is_component_word(next.word)) {
        stream_.drop();
        read_component(next);
        return true;
      }
      if (next.word == word::kw_blob) {
        stream_.drop();
        read_part(next, kOwnSum);
        return true;
      }
      if (next.word == word::kw_union) {
        stream_.drop();
        read_maximum(next, kOwnSum);
        return true;
      }
    } else if (next.is(ElementKind::word)) {
      if (next.word == word::kw_threshold) {
        stream_.drop();
        threshold_span_ = stream_.peek().span;
        threshold_ = read_number(stream_, "a number after `threshold`");
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
    } else if (leading_name(next) == context_.words.convolution) {
      read_convolution();
      return true;
    } else if (leading_name(next) == context_.words.skeleton) {
      if (is_part_) {
        context_.fail(next.span, "`skeleton` is not allowed in a part of a blob",
                      "write `skeleton` in the outermost blob");
      }
      stream_.drop();
      assembly_.blob().is_unblended = read_optional_truth(stream_);
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
    if (!is_blob || !assembly_.blob().components.empty()) {
      context_.fail(span, fmt::format("expected a component, found {}", describe(value)));
    }
    copy_object(stream_, value.as<ObjectValue>(), draft_);
    is_copy_ = true;
    return true;
  }

  // ---- Parts --------------------------------------------------------------------------------------------------------

  /// `blob { … }` inside a blob.
  void read_part(const Element& block, std::uint32_t branch) { read_inner(block, branch, &BlobReader::read_items); }

  /// `union { … }` inside a blob: every component, part and union in it is a branch.
  void read_maximum(const Element& block, std::uint32_t branch) {
    read_inner(block, branch, &BlobReader::read_branches);
  }

  void read_inner(const Element& block, std::uint32_t branch, void (BlobReader::*read)()) {
    ElementStream stream(context_, block);
    ObjectDraft draft;
    BlobReader inner(stream, draft, kernel_);
    (inner.*read)();
    read_object_modifiers(stream, draft);
    take_over(inner, draft, branch, block);
  }

  void read_branches() {
    std::optional<std::uint32_t> maximum;
    while (!stream_.peek().is(ElementKind::end)) {
      const Element next = stream_.peek();
      if (leading_name(next) == context_.words.kernel) {
        read_kernel();
        continue;
      }
      if (leading_name(next) == context_.words.convolution) {
        read_convolution();
        continue;
      }
      const bool is_part = next.is_block(word::kw_blob) || next.is_block(word::kw_union);
      if (!is_part && !(next.is(ElementKind::block) && is_component_word(next.word))) break;
      stream_.drop();
      const std::uint32_t branch = assembly_.add_branch(maximum);
      if (!maximum) maximum = branch;
      if (is_part) {
        next.word == word::kw_blob ? read_part(next, branch) : read_maximum(next, branch);
      } else {
        read_component(next, branch);
      }
    }
    if (!maximum) context_.warn(stream_.span(), "this `union` is empty");
  }

  void take_over(BlobReader& part, const ObjectDraft& draft, std::uint32_t branch, const Element& block) {
    const scene::Object& object = draft.object;
    const bool has_more = object.no_shadow || object.no_image || object.no_reflection || object.no_radiosity ||
                          object.double_illuminate || object.hollow || object.inverse ||
                          object.clip != scene::kNoGroup || draft.interior != scene::kNoInterior ||
                          draft.interior_texture;
    if (has_more) {
      context_.fail(block.word_span, "a part of a blob accepts only transforms and a texture",
                    "put modifiers of the whole blob after its components");
    }
    const BlobAssembly::Placement placement{object.parent_from_object, draft.texture, branch};
    if (part.is_copy_) {
      assembly_.take_copy(context_.database.blobs[object.shape], placement, block.span);
    } else {
      assembly_.take_over(std::move(part.assembly_), placement);
    }
  }

  /// `kernel "gaussian" hardness 4`
  void read_kernel() {
    stream_.drop();
    const SourceSpan span = stream_.peek().span;
    const std::string name = read_string(stream_, "a kernel's name as a string");
    const auto* const known = std::ranges::find(scene::kKernelWords, name);
    if (known == std::end(scene::kKernelWords)) {
      context_.fail(span, fmt::format("unknown kernel \"{}\"", name),
                    fmt::format("the kernels are \"{}\"", fmt::join(scene::kKernelWords, "\", \"")));
    }
    const auto shape = static_cast<KernelShape>(known - std::begin(scene::kKernelWords));
    Kernel kernel{shape, RadiusMeaning::surface, 4, kernel_.kernel.mode};
    if (leading_name(stream_.peek()) == context_.words.hardness) {
      const SourceSpan hardness_span = stream_.peek().span;
      kernel.hardness = read_contextual_number(stream_, "a number after `hardness`");
      if (!(kernel.hardness > 0 && kernel.hardness <= kMaxHardness)) {
        context_.fail(hardness_span, fmt::format("`hardness` must be above 0 and at most {:g}, found {:g}",
                                                 kMaxHardness, kernel.hardness));
      }
    }
    kernel_ = {kernel, {}, true, false};
  }

  /// `convolution on`, `convolution off`
  void read_convolution() {
    stream_.drop();
    if (!stream_.peek().is(ElementKind::value)) fail_expected(stream_, "`on` or `off` after `convolution`");
    kernel_.kernel.mode = read_optional_truth(stream_) ? scene::FieldMode::convolution : scene::FieldMode::distance;
    kernel_.is_known = false;
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

  void read_component(const Element& block, std::uint32_t branch = kOwnSum) {
    if (kernel_.is_convolved() && !kernel_.is_ours)
      context_.fail(block.word_span, "a convolution needs a kernel in force", "write `kernel \"quartic\"` before it");
    ElementStream stream(context_, block);
    static_cast<void>(read_if_finite(stream, "the component", [&] {
      Component component =
          read_component_shape(stream, block, kernel_.is_ours ? &kernel_.kernel : nullptr, assembly_.blob());
      read_strength(stream, component);
      if (stream.peek().is(ElementKind::end)) return add(component, block.span, branch);
      const scene::Turn turn = read_modifiers(stream, component);
      add(component, block.span, branch, &turn);
    }));
  }

  /// POV-Ray's components need a strength, and the word is optional; ours may have one, with the word.
  void read_strength(ElementStream& stream, Component& component) {
    const bool has_comma = stream.accept_comma();
    const bool has_word = stream.peek().is_word(word::kw_strength);
    if (has_word) stream.drop();
    if (kernel_.is_ours && !has_word) {
      if (stream.peek().is(ElementKind::value)) {
        context_.fail(stream.peek().span, "expected `strength` before the number, because a kernel is in force");
      }
      if (has_comma) fail_expected(stream, "`strength`");
      return;
    }
    const SourceSpan span = stream.peek().span;
    component.strength = read_number(stream, "a strength");
    if (!std::isfinite(component.strength))
      context_.fail_not_finite(span, fmt::format("a strength must be finite, found {:g}", component.strength));
    if (component.strength == 0) context_.warn(span, "a component of strength zero has no effect");
  }

  /// `component strength, radius, <centre>` of POV-Ray 1, without braces and modifiers.
  void read_old_component(const Element& keyword) {
    if (kernel_.is_convolved()) context_.fail(keyword.span, "a `component` has no convolution");
    Component component;
    component.strength = read_number(stream_, "a strength");
    stream_.accept_comma();
    component.radius_a = component.radius_b = read_support_radius(stream_);
    stream_.accept_comma();
    component.a = read_vector(stream_, "the centre of the component");
    add(component, keyword.span, kOwnSum);
  }

  /// Returns the rotation that was baked into the component.
  scene::Turn read_modifiers(ElementStream& stream, Component& component) {
    Surface look;
    std::optional<scene::Transform> blob_from_component;
    while (!stream.peek().is(ElementKind::end)) {
      if (read_texture_modifier(stream, look, blob_from_component.value_or(scene::Transform()))) continue;
      const SourceSpan span = stream.peek().span;
      if (const std::optional<scene::Transform> next = read_transform(stream)) {
        blob_from_component = blob_from_component ? then_placed(context_, span, *blob_from_component, *next) : *next;
      } else {
        refuse(stream, known_words());
      }
    }
    if (look.texture && blob_from_component) look.texture = moved(context_, *look.texture, *blob_from_component);
    if (look.texture) component.texture = texture_id(context_, *look.texture);
    return blob_from_component ? move(context_, component, *blob_from_component) : scene::Turn();
  }

  void add(Component& component, SourceSpan span, std::uint32_t branch, const scene::Turn* turn = nullptr) {
    const bool has_field = kernel_.is_ours || component.radius_a > 0;  // POV-Ray's with a radius of 0 have none
    if (!has_field) return;
    if (component.skeleton == scene::Skeleton::sheet) {
      Kernel over_sheet = kernel_.kernel;
      over_sheet.mode = scene::FieldMode::sheet;
      component.kernel = kernel_id(over_sheet);
    } else {
      if (!kernel_.is_known) {
        kernel_.id = kernel_id(kernel_.kernel);
        kernel_.is_known = true;
      }
      component.kernel = kernel_.id;
    }
    const std::size_t turn_bytes = turn ? sizeof(scene::Turn) : 0;
    context_.count_primitive(span, sizeof(Component) + sizeof(OriginId) + kOriginBytes + turn_bytes);
    assembly_.add(component, context_.origin(span), branch, turn);
  }

  /// At the threshold 0 the surface is the end of the fields, where they vanish together with their slopes, and no
  /// solver finds a sign. A field that falls as (1 − d²/R²)² has the value 2⁻⁴⁰ at 2⁻²¹ R before its end, which is less
  /// than a pixel of any picture.
  std::optional<double> usable_threshold() {
    if (!threshold_) return std::nullopt;
    if (!std::isfinite(*threshold_))
      context_.fail(threshold_span_, fmt::format("`threshold` must be finite, found {:g}", *threshold_));
    if (*threshold_ != 0) return threshold_;
    context_.warn(threshold_span_, "a `threshold` of 0 puts the surface where the fields end");
    double strongest = 0;
    for (const Component& component : assembly_.blob().components)
      strongest = std::max(strongest, std::abs(component.strength));
    return strongest > 0 ? 0x1p-40 * strongest : 1;
  }

  /// Below the threshold 0 everything far away is inside. Strengths and threshold with their signs changed have the
  /// same surface, and the outside and the inside exchanged.
  void turn_inside_out() {
    if (assembly_.has_maxima())
      context_.fail(threshold_span_, "the `threshold` of a blob with a `union` in it must be above 0");
    context_.warn(threshold_span_, "with a `threshold` below 0, everything outside the fields is inside the blob");
    assembly_.change_signs();
    draft_.object.inverse = !draft_.object.inverse;
  }

  ElementStream& stream_;
  Context& context_;
  ObjectDraft& draft_;
  BlobAssembly assembly_{context_};
  std::optional<double> threshold_;
  SourceSpan threshold_span_;
  KernelInForce kernel_;
  bool is_part_ = false;
  bool is_copy_ = false;  ///< the whole blob was copied: the draft has it
};

}  // namespace

void read_blob(ElementStream& stream, ObjectDraft& draft) {
  BlobReader reader(stream, draft);
  reader.read_items();
  reader.finish();
}

}  // namespace isl::interpreter
