// The complaints about a text, kept until execution reaches what they are about: POV-Ray never looks into a branch that
// is not taken or a macro that is not called, so a mistake there is none. The scanner, the token stream and the parser
// report here; nodes of the tree claim what lies in them (parse_state.h); the evaluator tells what it reaches.
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

  /// Keeps a complaint for whoever claims it. Null where it is dropped, because there are enough of its kind since the
  /// last directive: if one of them is told, all are, and the limit is reached.
  const Complaint* report(Diagnostic diagnostic);
  const Complaint* error(SourceSpan span, std::string message, std::string hint = {}) {
    return report({Severity::error, span, std::move(message), std::move(hint), {}, {}});
  }
  /// Keeps a complaint about the whole text, which holds whatever is executed: a string or directive without its end.
  void report_certain(Diagnostic diagnostic);

  /// A directive was read; text that is executed or not as a whole begins.
  void begin_stretch() { errors_in_stretch_ = warnings_in_stretch_ = 0; }
  /// What follows stands outside of all bodies of directives, and is executed.
  void set_outside(bool is_outside) { is_outside_ = is_outside; }

  /// So many errors stand outside of all directives that reading on makes no sense.
  [[nodiscard]] bool is_full() const { return outside_.size() >= DiagnosticSink::kMaxErrors; }
  /// A further error here would be dropped.
  [[nodiscard]] bool has_enough_errors() const { return errors_in_stretch_ >= DiagnosticSink::kMaxErrors; }

  /// None waits for what it is about.
  [[nodiscard]] bool is_empty() const { return unclaimed_.empty() && claimed_by_nodes_.empty(); }
  /// Takes one complaint, for a node that stands for it in the tree.
  void claim(const Complaint& complaint);
  /// Complaints about one part of the text, in its order.
  struct Part {
    std::vector<Complaint*> unclaimed;  ///< those for which no node stands
    std::vector<Complaint*> all;
  };
  /// Takes what was reported between two places of the text, both included.
  [[nodiscard]] Part claim(SourceSpan range);
  [[nodiscard]] const std::vector<const Complaint*>& certain() const { return certain_; }
  /// The errors outside of all directives, claimed or not.
  [[nodiscard]] const std::vector<const Complaint*>& outside() const { return outside_; }

 private:
  Complaint* keep(Diagnostic diagnostic);

  std::deque<Complaint>& store_;
  Arena& arena_;
  /// In the order of the text. Neither holds what a part of the text has claimed as a whole.
  std::vector<Complaint*> unclaimed_;
  std::vector<Complaint*> claimed_by_nodes_;
  std::vector<const Complaint*> certain_;
  std::vector<const Complaint*> outside_;
  bool is_outside_ = true;
  std::size_t errors_in_stretch_ = 0;
  std::size_t warnings_in_stretch_ = 0;
};

}  // namespace isl::grammar
