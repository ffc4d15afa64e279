#include "renderer/patterns/kinds/code_meaning.h"

#include "renderer/numerics/power.h"

#include <algorithm>

namespace isl::render {
namespace {

double light_from_srgb(double code) { return code <= 0.04045 ? code / 12.92 : power((code + 0.055) / 1.055, 2.4); }
double srgb_from_light(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * power(light, 1 / 2.4) - 0.055;
}

}  // namespace

CodeMeaning::CodeMeaning(const scene::Image& image, const Texels& texels, const WorkingGamma& working)
    : working_(working), transfer_(texels.transfer), gamma_(texels.gamma) {
  const bool is_named = image.gamma_srgb || image.gamma;
  if (image.gamma_srgb) transfer_ = Transfer::srgb;
  if (image.gamma) {
    transfer_ = Transfer::power;
    gamma_ = *image.gamma;
  }
  const bool is_converted = working.converts == WorkingGamma::Converts::all ||
                            (working.converts == WorkingGamma::Converts::stating && texels.states_transfer);
  keeps_codes_ = !is_named && (image.holds_numbers || transfer_ == Transfer::working || !is_converted);
}

double CodeMeaning::operator()(double code) const noexcept {
  if (keeps_codes_) return code;
  const double light = transfer_ == Transfer::srgb    ? light_from_srgb(code)
                       : transfer_ == Transfer::power ? power(std::max(code, 0.0), gamma_)
                                                      : code;
  switch (working_.kind) {
    case WorkingGamma::Kind::linear: return light;
    case WorkingGamma::Kind::srgb: return srgb_from_light(light);
    case WorkingGamma::Kind::power: return power(std::max(light, 0.0), 1 / working_.gamma);
  }
  return light;
}

}  // namespace isl::render
