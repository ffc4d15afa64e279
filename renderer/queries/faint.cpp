#include "renderer/queries/faint.h"

#include "renderer/fields/component_table.h"

#include <vector>

namespace isl::render {

std::optional<FaintComponents> faint_components(const scene::Database& database) {
  std::vector<KernelConstants> kernels;
  for (const scene::Kernel& kernel : database.kernels) kernels.push_back(kernel_constants(kernel));
  std::optional<FaintComponents> found;
  for (const scene::Blob& blob : database.blobs) {
    for (std::size_t i = 0; i < blob.components.size(); ++i) {
      const scene::Component& c = blob.components[i];
      const KernelConstants& kernel = kernels[index(c.kernel)];
      if (!kernel.is_convolved || !(c.strength > 0)) continue;
      const double greatest = peak_of(database, blob, c, kernel) / blob.threshold;
      if (greatest >= 1 || greatest == 0) continue;  // without any length: its reader has told
      if (!found) found = {blob.origins[i], c.skeleton, greatest, 0};
      ++found->count;
    }
  }
  return found;
}

}  // namespace isl::render
