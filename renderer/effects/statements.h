// The statements that single effects declare (renderer/scene/statement.h), for whoever reads scenes.
#pragma once

#include "renderer/scene/statement.h"

#include <span>

namespace isl::render {

[[nodiscard]] std::span<const scene::StatementKind* const> statement_kinds();

}  // namespace isl::render
