// Statements of the world that effects declare, such as those of the air: renderer/scene/statement.h says how they are
// read.
#pragma once

#include "interpreter/element_stream.h"
#include "renderer/scene/statement.h"

namespace isl::interpreter {

/// The kind of statement that begins with the word; null if none does.
[[nodiscard]] const scene::StatementKind* statement_kind(const Context& context, grammar::Symbol word);

/// Reads the block of such a statement.
[[nodiscard]] scene::Statement read_statement(Context& context, const Element& block);
/// Reads it and adds it to the scene.
void place_statement(Context& context, const Element& block);

/// Reads a statement of `global_settings`, which may begin with a word of ours; false if the next element is none.
bool read_setting_block(ElementStream& stream);
/// The words that begin such statements.
[[nodiscard]] std::vector<grammar::Symbol> setting_words(Context& context);

}  // namespace isl::interpreter
