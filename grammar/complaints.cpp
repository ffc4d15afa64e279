#include "grammar/complaints.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace isl::grammar {
namespace {

using List = std::vector<Complaint*>;

std::uint32_t place(const Complaint* complaint) { return complaint->diagnostic.span.begin; }

/// Lists are in the order of the text. The newest complaint is nearly always the last.
void insert(List& list, Complaint* complaint) {
  const auto is_before = [](std::uint32_t at, const Complaint* other) { return at < place(other); };
  list.insert(std::upper_bound(list.begin(), list.end(), place(complaint), is_before), complaint);
}

/// Takes the complaints in `range` out of the list.
List extract(List& list, SourceSpan range) {
  const auto first = std::partition_point(list.begin(), list.end(),
                                          [&](const Complaint* complaint) { return place(complaint) < range.begin; });
  const auto last = std::partition_point(first, list.end(),
                                         [&](const Complaint* complaint) { return place(complaint) <= range.end; });
  List taken(first, last);
  list.erase(first, last);
  return taken;
}

}  // namespace

Complaint* Complaints::keep(Diagnostic diagnostic) {
  arena_.charge(sizeof(Complaint) + diagnostic.message.size() + diagnostic.hint.size());
  return &store_.emplace_back(Complaint{std::move(diagnostic)});
}

const Complaint* Complaints::report(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity == Severity::error;
  if (is_error) {
    if (has_enough_errors()) return nullptr;
    ++errors_in_stretch_;
  } else if (++warnings_in_stretch_ > DiagnosticSink::kMaxWarnings + 1) {
    return nullptr;
  }
  Complaint* const complaint = keep(std::move(diagnostic));
  insert(unclaimed_, complaint);
  if (is_error && is_outside_) outside_.push_back(complaint);
  return complaint;
}

void Complaints::report_certain(Diagnostic diagnostic) { certain_.push_back(keep(std::move(diagnostic))); }

void Complaints::claim(const Complaint& complaint) {
  const auto at = std::find(unclaimed_.rbegin(), unclaimed_.rend(), &complaint);
  if (at == unclaimed_.rend()) return;
  insert(claimed_by_nodes_, *at);
  unclaimed_.erase(std::next(at).base());
}

Complaints::Part Complaints::claim(SourceSpan range) {
  if (is_empty()) return {};
  Part part;
  part.unclaimed = extract(unclaimed_, range);
  part.all = part.unclaimed;
  for (Complaint* complaint : extract(claimed_by_nodes_, range)) insert(part.all, complaint);
  return part;
}

}  // namespace isl::grammar
