// The complaints about a text, kept until execution reaches the text that they are about: POV-Ray never looks into a
// branch that is not taken or a macro that is not called, so a mistake there is not reported. The scanner, the token
// stream and the parser report here; nodes of the tree claim the complaints within them (parse_state.h); the evaluator
// tells those it reaches.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/complaint.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace isl::grammar {

class Complaints {
 public:
  /// Complaints live in `store`, which outlives the tree; the memory they take counts as the arena's.
  Complaints(std::deque<Complaint>& store, Arena& arena) : store_(store), arena_(arena) {}

  /// Keeps a complaint until it is claimed. Returns null if it is dropped because enough of its kind were reported
  /// since the last directive: if one of them is reported, all are, and the limit is reached.
  const Complaint* report(Diagnostic diagnostic);
  const Complaint* error(SourceSpan span, std::string message, std::string hint = {}) {
    return report({Severity::error, span, std::move(message), std::move(hint), {}, {}});
  }
  /// Keeps a complaint about the whole text, which is reported whatever is executed: an unclosed string or directive.
  void report_certain(Diagnostic diagnostic);

  /// A directive was read: a stretch of text begins that is executed as a whole or not at all.
  void begin_stretch() { errors_in_stretch_ = warnings_in_stretch_ = 0; }
  /// Tells that the text that follows stands outside all bodies of directives, and is executed.
  void set_outside(bool is_outside) { is_outside_ = is_outside; }

  /// True if there are so many errors outside all directives that reading on makes no sense.
  [[nodiscard]] bool is_full() const { return outside_.size() >= DiagnosticSink::kMaxErrors; }
  /// True if a further error here would be dropped.
  [[nodiscard]] bool has_enough_errors() const { return errors_in_stretch_ >= DiagnosticSink::kMaxErrors; }

  /// True if no complaint waits to be claimed or reported.
  [[nodiscard]] bool is_empty() const { return unclaimed_.empty() && claimed_by_nodes_.empty(); }
  /// Takes one complaint, for a node that represents it in the tree.
  void claim(const Complaint& complaint);
  /// Complaints about one part of the text, in its order.
  struct Part {
    std::vector<Complaint*> unclaimed;  ///< those that no node represents
    std::vector<Complaint*> all;
  };
  /// Takes the complaints that were reported between two places of the text, both included.
  [[nodiscard]] Part claim(SourceSpan range);
  [[nodiscard]] const std::vector<const Complaint*>& certain() const { return certain_; }
  /// The errors outside all directives, claimed or not.
  [[nodiscard]] const std::vector<const Complaint*>& outside() const { return outside_; }

 private:
  Complaint* keep(Diagnostic diagnostic);

  std::deque<Complaint>& store_;
  Arena& arena_;
  /// In the order of the text. Neither list holds complaints that a part of the text has claimed as a whole.
  std::vector<Complaint*> unclaimed_;
  std::vector<Complaint*> claimed_by_nodes_;
  std::vector<const Complaint*> certain_;
  std::vector<const Complaint*> outside_;
  bool is_outside_ = true;
  std::size_t errors_in_stretch_ = 0;
  std::size_t warnings_in_stretch_ = 0;
};

}  // namespace isl::grammar
