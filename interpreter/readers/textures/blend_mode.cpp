#include "interpreter/readers/textures/blend_mode.h"

#include "interpreter/newer_words.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::Colour;

/// The parts that an interval between two entries is cut into. A component that goes from 0 to 1 along t^G differs from
/// its chords by at most G (G − 1)/(8 n²): with G = 2.5 by 7·10⁻⁶, half a step of 16 bits.
constexpr int kParts = 256;

/// The red, green, blue, filter and transmit of a colour. As in POV-Ray 3.8, all five are made linear.
using Terms = std::array<double, 5>;

/// A power that is 0 for what is not above 0.
double power_of(double base, double exponent) { return base > 0 ? std::pow(base, exponent) : 0; }

double brightness(const Terms& c) { return 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2]; }  // POV-Ray's weights

class Mixer {
 public:
  Mixer(const Context& context, const BlendMode& blend)
      : blend_(blend), working_(context.database.settings.assumed_gamma.value_or(1)) {}

  /// The colour at a share `t` of the way from one to the other.
  [[nodiscard]] Colour operator()(const Colour& from, const Colour& to, double t) const {
    const Terms a = linear(from), b = linear(to);
    Terms mixed;
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      const bool is_encoded = blend_.mode == 2 && i < 3;
      mixed[i] = is_encoded ? in_gamma(a[i], b[i], t) : a[i] + (b[i] - a[i]) * t;
    }
    if (blend_.mode == 3) {
      const double plain = brightness(mixed), wanted = in_gamma(brightness(a), brightness(b), t);
      for (std::size_t i = 0; i < 3; ++i) mixed[i] *= plain != 0 ? wanted / plain : 1;
    }
    for (double& term : mixed) term = working_ == 1 ? term : power_of(term, 1 / working_);
    return {mixed[0], mixed[1], mixed[2], mixed[3], mixed[4]};
  }

 private:
  [[nodiscard]] Terms linear(const Colour& c) const {
    Terms terms{c.red, c.green, c.blue, c.filter, c.transmit};
    for (double& term : terms) term = working_ == 1 ? term : power_of(term, working_);
    return terms;
  }
  [[nodiscard]] double in_gamma(double a, double b, double t) const {
    const double from = power_of(a, 1 / blend_.gamma), to = power_of(b, 1 / blend_.gamma);
    return power_of(from + (to - from) * t, blend_.gamma);
  }

  BlendMode blend_;
  double working_;  ///< gamma of the working space
};

/// True if the mode's space is the working space.
bool is_plain(const Context& context, const BlendMode& blend) {
  return blend.mode == 0 || (blend.mode == 1 && context.database.settings.assumed_gamma.value_or(1) == 1);
}

}  // namespace

BlendMode read_blend_mode(ElementStream& stream) {
  Context& context = stream.context();
  BlendMode blend;
  while (true) {
    const grammar::Symbol word = leading_name(stream.peek());
    if (word == grammar::newer_word::kw_blend_mode) {
      note_newer_word(context, word, stream.peek().span);
      const SourceSpan span = stream.peek().span;
      const double mode = read_contextual_number(stream, "a number after `blend_mode`");
      if (!(mode >= 0 && mode <= 3))
        context.fail(span, fmt::format("`blend_mode` must be 0, 1, 2 or 3, found {:g}", mode));
      blend.mode = static_cast<int>(mode);
    } else if (word == grammar::newer_word::kw_blend_gamma) {
      note_newer_word(context, word, stream.peek().span);
      const SourceSpan span = stream.peek().span;
      blend.gamma = read_contextual_number(stream, "a number after `blend_gamma`");
      if (!(blend.gamma > 0 && std::isfinite(blend.gamma)))
        context.fail(span, fmt::format("`blend_gamma` must be above 0, found {:g}", blend.gamma));
    } else {
      return blend;
    }
  }
}

void apply_blend_mode(Context& context, const Element& block, const BlendMode& blend, scene::PigmentMap& map) {
  if (is_plain(context, blend)) return;
  if (!std::ranges::all_of(map, [](const scene::PigmentEntry& entry) { return entry.pigment.is_plain(); })) {
    context.fail(block.word_span, fmt::format("`blend_mode` {} needs plain colours as entries of a map", blend.mode),
                 "pigments with patterns are mixed in the working space, with `blend_mode 0`");
  }
  context.check_memory(block.span, map.size() * kParts * sizeof(scene::PigmentEntry));
  std::ranges::stable_sort(map, {}, &scene::PigmentEntry::value);
  const Mixer mix(context, blend);
  scene::PigmentMap mixed;
  for (std::size_t i = 0; i < map.size(); ++i) {
    mixed.push_back(map[i]);
    if (i + 1 == map.size() || !(map[i + 1].value > map[i].value)) continue;
    const double width = map[i + 1].value - map[i].value;
    for (int part = 1; part < kParts; ++part) {
      const double t = static_cast<double>(part) / kParts;
      scene::Pigment pigment = map[i].pigment;
      pigment.colour = mix(map[i].pigment.colour, map[i + 1].pigment.colour, t);
      mixed.push_back({map[i].value + width * t, pigment});
    }
  }
  map = std::move(mixed);
}

}  // namespace isl::interpreter
