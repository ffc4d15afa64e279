#include "grammar/parted_braces.h"

#include "grammar/nesting.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace isl::grammar {
namespace {

using Kind = Parser::token;
using Places = std::vector<std::uint32_t>;

/// A token that opens, divides or closes something.
struct Mark {
  TokenKind kind;
  std::uint32_t place;
  bool is_block;  ///< of a brace that opens: it is a block's
};

/// True for the tokens that may stand before the brace of a block. Those of arrays, functions and `#default` cannot be
/// parted.
bool names_block(TokenKind kind) {
  return kind == Kind::TOK_KEYWORD || kind == Kind::TOK_TEXTURE || kind == Kind::TOK_COLOUR_WORD ||
         kind == Kind::TOK_IDENTIFIER;
}

/// The braces and directives of the text. Misspelt directives within others are passed over, as by TokenStream.
std::vector<Mark> read_marks(Lexer& lexer) {
  std::vector<Mark> marks;
  TokenKind before = Kind::TOK_END_OF_FILE;
  std::size_t depth = 0;
  for (Token token = lexer.next(); token.kind != Kind::TOK_END_OF_FILE; token = lexer.next()) {
    const bool is_brace = token.kind == Kind::TOK_LEFT_BRACE || token.kind == Kind::TOK_RIGHT_BRACE;
    const bool is_structure = shapes_directive(token.kind) && !(token.misspelt && depth > 0);
    if (is_brace || is_structure) marks.push_back({token.kind, token.span.begin, names_block(before)});
    if (is_structure && opens_directive(token.kind)) ++depth;
    if (is_structure && token.kind == Kind::TOK_END && depth > 0) --depth;
    before = token.kind;
  }
  return marks;
}

/// Braces of which one is executed: a single one, or one of each branch of a directive.
struct Brace {
  Places places;
  bool is_parted = false;  ///< they stand in branches
  bool is_block = true;
};

/// The braces of a text that have no partner in it: those that close a block come first, then those that open one,
/// outermost first.
struct Rest {
  std::vector<Brace> closed;
  std::vector<Brace> open;

  [[nodiscard]] bool empty() const { return closed.empty() && open.empty(); }
};

void add(Places& places, const Places& more) { places.insert(places.end(), more.begin(), more.end()); }

/// The branches of a directive do the same.
void unite(std::vector<Brace>& braces, const std::vector<Brace>& of_branch) {
  braces.resize(std::max(braces.size(), of_branch.size()), {{}, true, true});
  for (std::size_t i = 0; i < of_branch.size(); ++i) {
    add(braces[i].places, of_branch[i].places);
    braces[i].is_block = braces[i].is_block && of_branch[i].is_block;
  }
}

class Finder {
 public:
  /// With `only_even`, directives count whose branches all open and close as much.
  Finder(const std::vector<Mark>& marks, std::size_t max_nesting, bool only_even)
      : marks_(marks), max_nesting_(max_nesting), only_even_(only_even) {}

  Places find() {
    const Rest rest = read(0);
    if (!rest.empty() || failed_) return {};
    std::sort(parted_.begin(), parted_.end());
    return std::move(parted_);
  }

 private:
  /// Reads up to the token of a directive that ends the text, which is `end_` then: an `#else`, an `#end`, the end of
  /// the file.
  Rest read(std::size_t depth) {
    Rest rest;
    while (!failed_ && next_ < marks_.size()) {
      const Mark& mark = marks_[next_++];
      if (mark.kind == Kind::TOK_LEFT_BRACE) {
        rest.open.push_back({{mark.place}, false, mark.is_block});
      } else if (mark.kind == Kind::TOK_RIGHT_BRACE) {
        close(rest, {{mark.place}});
      } else if (opens_directive(mark.kind)) {
        read_directive(mark.kind, rest, depth);
      } else {
        failed_ |= depth == 0;
        end_ = mark.kind;
        return rest;
      }
    }
    failed_ |= depth > 0;
    return rest;
  }

  void read_directive(TokenKind kind, Rest& around, std::size_t depth) {
    if (depth == max_nesting_) failed_ = true;
    std::vector<Rest> branches;
    bool has_else = false;
    do {
      branches.push_back(read(depth + 1));
      has_else |= end_ == Kind::TOK_ELSE;
    } while (!failed_ && end_ != Kind::TOK_END);
    const bool has_branches = kind != Kind::TOK_WHILE && kind != Kind::TOK_FOR && kind != Kind::TOK_MACRO;
    if (!has_branches || failed_) return;
    // The text of a `#switch` before its first `#case` is never executed.
    if (kind == Kind::TOK_SWITCH) branches.erase(branches.begin());
    if (only_even_ && !(has_else && std::ranges::all_of(branches, [&](const Rest& branch) {
                          return branch.closed.size() == branches[0].closed.size() &&
                                 branch.open.size() == branches[0].open.size();
                        })))
      return;
    Rest all;
    for (const Rest& branch : branches) {
      unite(all.closed, branch.closed);
      unite(all.open, branch.open);
    }
    for (const Brace& brace : all.closed) close(around, brace);
    std::move(all.open.begin(), all.open.end(), std::back_inserter(around.open));
  }

  void close(Rest& rest, const Brace& closer) {
    if (rest.open.empty()) {
      rest.closed.push_back(closer);
      return;
    }
    const Brace& opener = rest.open.back();
    if (closer.is_parted || opener.is_parted) {
      failed_ |= !opener.is_block;
      add(parted_, closer.places);
      add(parted_, opener.places);
    }
    rest.open.pop_back();
  }

  const std::vector<Mark>& marks_;
  std::size_t max_nesting_;
  bool only_even_;
  std::size_t next_ = 0;
  TokenKind end_ = Kind::TOK_END;
  bool failed_ = false;
  Places parted_;
};

}  // namespace

std::vector<std::uint32_t> find_parted_braces(Lexer& lexer, std::size_t max_nesting) {
  const std::vector<Mark> marks = read_marks(lexer);
  Places places = Finder(marks, max_nesting, false).find();
  // Text that is never executed may leave braces open that nothing closes.
  return places.empty() ? Finder(marks, max_nesting, true).find() : places;
}

}  // namespace isl::grammar
