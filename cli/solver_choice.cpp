#include "cli/solver_choice.h"

#include "grammar/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace isl::cli {
namespace {

using render::PaperSwitch;
using render::PaperSwitches;
using render::SolverName;

struct NamedSolver {
  std::string_view word;
  SolverName name;
};
constexpr NamedSolver kSolvers[] = {{"hermite", SolverName::hermite},
                                    {"paper", SolverName::paper},
                                    {"iso", SolverName::iso},
                                    {"exact", SolverName::exact}};

constexpr std::string_view kPlain = "plain";
/// More interpolants a field than this is slower than the certified solver and no more exact.
constexpr int kMaxInterpolants = 64;

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  const auto similar = grammar::closest(word, candidates);
  return similar ? fmt::format(", did you mean `{}`?", *similar) : ";";
}

Parsed<SolverChoice> unknown_solver(std::string_view text, std::string_view word) {
  std::vector<std::string_view> words;
  for (const NamedSolver& solver : kSolvers) words.push_back(solver.word);
  return Parsed<SolverChoice>::error(fmt::format(
      "unknown solver `{}`{} there are hermite, paper, paper:K, iso and exact", text, did_you_mean(word, words)));
}

Parsed<SolverChoice> unknown_switch(std::string_view word) {
  std::vector<std::string_view> words = {kPlain};
  for (const PaperSwitch& s : render::kPaperSwitches) words.insert(words.end(), {s.on, s.off});
  return Parsed<SolverChoice>::error(fmt::format("unknown switch `{}` of the solver{} there are {}", word,
                                                 did_you_mean(word, words), solver_switches_text()));
}

/// Whether there is such a switch.
bool turn(PaperSwitches& switches, std::string_view word) {
  if (word == kPlain) {
    switches = render::kPlainPaper;
    return true;
  }
  for (const PaperSwitch& s : render::kPaperSwitches) {
    if (word != s.on && word != s.off) continue;
    switches.*s.is_on = word == s.on;
    return true;
  }
  return false;
}

/// The text up to the next `mark`, which with what it ends is taken off.
std::string_view take_until(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

/// The words that make `wanted` of `from`.
std::vector<std::string_view> words_between(const PaperSwitches& from, const PaperSwitches& wanted) {
  std::vector<std::string_view> words;
  for (const PaperSwitch& s : render::kPaperSwitches) {
    if (from.*s.is_on != wanted.*s.is_on) words.push_back(wanted.*s.is_on ? s.on : s.off);
  }
  return words;
}

}  // namespace

Parsed<SolverChoice> parse_solver(std::string_view text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  std::string_view switches = text.substr(std::min(comma + 1, text.size()));
  std::string_view count = text.substr(0, comma);
  const bool has_count = count.find(':') != std::string_view::npos;
  const std::string_view word = take_until(count, ':');
  const auto solver =
      std::find_if(std::begin(kSolvers), std::end(kSolvers), [&](const auto& s) { return s.word == word; });
  if (solver == std::end(kSolvers) || (has_count && solver->name != SolverName::paper))
    return unknown_solver(text, word);
  SolverChoice choice{solver->name, 2, {}};
  if (has_count) {
    const auto k = parse_integer(count, 1, kMaxInterpolants);
    if (!k.ok()) {
      return Parsed<SolverChoice>::error(
          fmt::format("expected paper:K with K interpolants from 1 to {}, found `{}`", kMaxInterpolants, text));
    }
    choice.interpolants = static_cast<int>(k.value());
  }
  if (comma == text.size()) return choice;
  if (!render::is_published(choice.name)) {
    return Parsed<SolverChoice>::error(
        fmt::format("the solver {} has no switches, found `{}`", word, text.substr(comma)));
  }
  for (bool is_last = false; !is_last;) {
    is_last = switches.find(',') == std::string_view::npos;
    const std::string_view next = take_until(switches, ',');
    if (!turn(choice.paper, next)) return unknown_switch(next);
  }
  return choice;
}

std::string to_text(const SolverChoice& solver) {
  const auto named =
      std::find_if(std::begin(kSolvers), std::end(kSolvers), [&](const auto& s) { return s.name == solver.name; });
  std::string text(named->word);
  if (solver.name == SolverName::paper) text += fmt::format(":{}", solver.interpolants);
  if (!render::is_published(solver.name)) return text;
  const std::vector<std::string_view> from_default = words_between({}, solver.paper);
  std::vector<std::string_view> from_plain = words_between(render::kPlainPaper, solver.paper);
  from_plain.insert(from_plain.begin(), kPlain);
  for (const std::string_view word : from_plain.size() < from_default.size() ? from_plain : from_default) {
    text += fmt::format(",{}", word);
  }
  return text;
}

std::string solver_switches_text() {
  std::string text(kPlain);
  for (const PaperSwitch& s : render::kPaperSwitches) {
    text += fmt::format(" {}", s.on);
    if (!s.off.starts_with("no-")) text += fmt::format("|{}", s.off);
  }
  return text + ", off by no-…";
}

}  // namespace isl::cli
