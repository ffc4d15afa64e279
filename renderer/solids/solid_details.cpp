#include "renderer/solids/solid_details.h"

#include "renderer/scene/database.h"

namespace isl::render {

SolidDetails prepare_details(const scene::Database& database) {
  SolidDetails details;
#define ISL_SOLID_DETAIL(word, Type, column)      \
  details.column.reserve(database.column.size()); \
  for (const scene::Type& detail : database.column) details.column.push_back(prepare(detail));
#include "renderer/scene/solids.def"
  return details;
}

}  // namespace isl::render
