// Making, copying and destroying a database: a hundred instances of templates, compiled here for all.
#include "renderer/scene/database.h"

namespace isl::scene {

Database::Database() = default;
Database::Database(const Database&) = default;
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(const Database&) = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

}  // namespace isl::scene
