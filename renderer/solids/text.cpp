// text: the outlines of letters in the plane of x and y, swept along z.
#include "renderer/solids/swept.h"

namespace isl::render {

constinit const SolidType kinds::text = Swept<SweptAxes{.u = 0, .v = 1, .height = 2}>::type();

}  // namespace isl::render
