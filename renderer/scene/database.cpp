// Constructors, assignments and destructor of the database. They instantiate some hundred templates, which are compiled
// only here.
#include "renderer/scene/database.h"

namespace isl::scene {

Database::Database() = default;
Database::Database(const Database&) = default;
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(const Database&) = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

}  // namespace isl::scene
