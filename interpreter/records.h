// Appends records to the database and counts them against the scene's limit of memory: they stay until the end, even if
// the values that named them are gone.
#pragma once

#include "interpreter/context.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace isl::interpreter {

/// A column that grows holds its records twice while they move.
inline constexpr std::size_t kHeldWhileMoving = 2;

/// Called before an element is appended to a list that grows while a block is read, and is counted when the block ends:
/// makes room for the moment at which the list holds its elements in their old places and their new ones.
template <class T>
void make_room_to_append(Context& context, SourceSpan span, const std::vector<T>& list) {
  if (list.size() == list.capacity()) [[unlikely]]
    context.check_memory(span, 3 * list.capacity() * sizeof(T));
}

/// The number of the record. The reader of a block calls Context::check_memory for the size of its records.
template <class Id, class Record>
[[nodiscard]] Id add_record(Context& context, std::vector<Record>& column, Record record) {
  context.memory.add(kHeldWhileMoving * sizeof(Record));
  context.depths.append<Id>(record, column.size());
  column.push_back(std::move(record));
  return Id{static_cast<std::uint32_t>(column.size() - 1)};
}

/// The same for a map, a record of entries.
template <class Id, class Entry>
[[nodiscard]] Id add_map(Context& context, std::vector<std::vector<Entry>>& column, std::vector<Entry> map) {
  context.memory.add(map.size() * sizeof(Entry));
  return add_record<Id>(context, column, std::move(map));
}

/// The number of an equal record; a new one is appended if there is none.
template <class Id, class Record>
[[nodiscard]] Id share_record(Context& context, RecordTable<Record>& table, std::vector<Record>& column,
                              const Record& record) {
  const std::size_t size = column.size();
  const std::uint32_t i = table.find_or_add(record, column);
  if (column.size() > size) {
    context.memory.add(kHeldWhileMoving * sizeof(Record));
    context.depths.append<Id>(record, size);
  }
  return Id{i};
}

}  // namespace isl::interpreter
