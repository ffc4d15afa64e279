// prism: an outline in the plane of x and z, swept along y.
#include "renderer/solids/swept.h"

namespace isl::render {

constinit const SolidType kinds::prism = Swept<SweptAxes{.u = 0, .v = 2, .height = 1}>::type();

}  // namespace isl::render
