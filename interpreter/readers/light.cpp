// `light_source { <location>, colour … }`: point lights.
#include "interpreter/readers/arguments.h"
#include "interpreter/readers/colour.h"
#include "interpreter/readers/objects.h"

namespace isl::interpreter {

namespace word = grammar::word;

void read_light_source(ElementStream& stream, ObjectDraft& draft) {
  Context& context = stream.context();
  if (!stream.peek().is(ElementKind::value)) fail_expected(stream, "the location of the light");
  const SourceSpan span = stream.peek().span;
  const Value first = stream.take_value();
  if (first.kind() == ValueKind::object) {
    copy_object(stream, first.as<ObjectValue>(), draft);
  } else {
    scene::Light light{.location = to_vector(stream, first, span, "the location of the light"),
                       .origin = draft.object.origin};
    stream.accept_comma();
    light.colour = read_colour(stream);
    context.count_primitive(stream.span(), sizeof(scene::Light) + kOriginBytes);
    draft.lights.push_back(light);
  }
  while (!stream.peek().is(ElementKind::end)) {
    if (stream.peek().is_word(word::kw_shadowless)) {
      stream.drop();
      for (scene::Light& light : draft.lights) light.shadowless = true;
    } else if (stream.peek().is_word(word::kw_media_attenuation) || stream.peek().is_word(word::kw_media_interaction)) {
      stream.drop();
      static_cast<void>(read_optional_truth(stream));  // there is no media to interact with
    } else if (!read_object_modifier(stream, draft)) {
      static constexpr grammar::Symbol kKnown[] = {word::kw_shadowless, word::kw_translate, word::kw_rotate};
      refuse(stream, kKnown);
    }
  }
}

}  // namespace isl::interpreter
