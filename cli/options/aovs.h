// Every output variable that `--aov` takes, in the order in which they are listed and written.
#pragma once

#include "renderer/image/aov.h"

namespace isl::cli {

[[nodiscard]] const render::Aovs& all_aovs();

}  // namespace isl::cli
