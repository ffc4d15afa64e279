#include "interpreter/functions/pattern_use.h"

#include "renderer/patterns/kinds/pattern_kind.h"

#include <algorithm>
#include <unordered_map>

namespace isl::interpreter {
namespace {

/// "function { image_map }" by kind: the names that functions keep of patterns that cannot be evaluated.
constexpr std::string_view kFunctionOf[] = {
    "",
#define ISL_PATTERN(name, frequency) std::string_view("function { " #name " }"),
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

/// Visits each pigment once, however many maps name it.
class Walk {
 public:
  Walk(Context& context, SourceSpan span) : context_(context), span_(span) {}

  PatternUse of(const scene::Pattern& pattern, std::uint32_t outer) {
    check(outer);
    PatternUse use{1, missing_of(pattern)};
    if (const auto* const pigment = std::get_if<scene::PigmentOperands>(&pattern.operands))
      add(use, of(scene::Pigment{.pattern = pigment->pigment}, outer + 1));
    const auto* const function = std::get_if<scene::FunctionOperands>(&pattern.operands);
    if (function && function->function != scene::kNoFunction) {
      const scene::Function& callee = *context_.database.functions[index(function->function)];
      add(use, {callee.pattern_depth, callee.missing});
    }
    check(use.depth);
    return use;
  }

  PatternUse of(const scene::Pigment& pigment, std::uint32_t outer) {
    check(outer);
    if (pigment.is_plain()) return {};
    const auto known = known_.find(index(pigment.pattern));
    if (known != known_.end()) return known->second;
    const scene::PatternedPigment& record = context_.database.pigments[index(pigment.pattern)];
    PatternUse use = of(record.pattern, outer);
    if (record.map != scene::kNoPigmentMap) {
      for (const scene::PigmentEntry& entry : context_.database.pigment_maps[index(record.map)])
        add(use, of(entry.pigment, outer + 1));
    }
    check(use.depth);
    known_.emplace(index(pigment.pattern), use);
    return use;
  }

 private:
  [[nodiscard]] std::string_view missing_of(const scene::Pattern& pattern) const {
    const bool lacks_images = std::holds_alternative<scene::ImageId>(pattern.operands) && !context_.options.images;
    const bool asks_objects = std::holds_alternative<scene::ObjectOperands>(pattern.operands);
    const bool is_known = render::info_of(pattern.kind).lack == render::PatternLack::nothing;
    if (is_known && !lacks_images && (!asks_objects || context_.options.queries)) return {};
    return kFunctionOf[static_cast<std::size_t>(pattern.kind)];
  }

  static void add(PatternUse& use, const PatternUse& inner) {
    use.depth = std::max(use.depth, inner.depth + 1);
    if (use.missing.empty()) use.missing = inner.missing;
  }

  void check(std::uint32_t depth) const { context_.check_value_depth(span_, depth); }

  Context& context_;
  SourceSpan span_;
  std::unordered_map<std::uint32_t, PatternUse> known_;
};

}  // namespace

PatternUse use_of(Context& context, const scene::Pattern& pattern, SourceSpan span) {
  return Walk(context, span).of(pattern, 1);
}

PatternUse use_of(Context& context, const scene::Pigment& pigment, SourceSpan span) {
  return Walk(context, span).of(pigment, 1);
}

}  // namespace isl::interpreter
