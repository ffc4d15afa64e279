#include "interpreter/origin_table.h"

#include "base/check.h"

namespace isl::interpreter {

OriginTable::Chain OriginTable::extend(Chain outer, ExpansionFrame::Kind kind, std::uint32_t name, SourceSpan call) {
  ISL_DCHECK(outer <= links_.size() && name < names_.size());
  links_.push_back({outer, name, call, kind});
  return static_cast<Chain>(links_.size());
}

std::uint32_t OriginTable::keep_name(std::string name) {
  const auto [entry, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (is_new) names_.push_back(std::move(name));
  return entry->second;
}

OriginId OriginTable::add(SourceSpan span, Chain chain) {
  records_.push_back({span, chain});
  return OriginId{static_cast<std::uint32_t>(records_.size())};
}

Origin OriginTable::resolve(OriginId id) const {
  if (id.value == 0) return {};
  ISL_CHECK(id.value <= records_.size(), "origin {} of {}", id.value, records_.size());
  const Record& record = records_[id.value - 1];
  Origin origin{record.span, {}};
  for (Chain chain = record.chain; chain != 0;) {
    const Link& link = links_[chain - 1];
    origin.chain.push_back({link.kind, names_[link.name], link.call});
    chain = link.outer;
  }
  return origin;
}

std::size_t OriginTable::memory_bytes() const {
  return links_.capacity() * sizeof(Link) + records_.capacity() * sizeof(Record);
}

}  // namespace isl::interpreter
