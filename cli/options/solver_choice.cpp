#include "cli/options/solver_choice.h"

#include "grammar/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace isl::cli {
namespace {

using render::kSolvers;
using render::NamedSolver;
using render::PaperSwitch;
using render::PaperSwitches;
using render::SolverName;
using Argument = render::SolverArgument;

constexpr std::string_view kPlain = "plain";
constexpr std::string_view kOctree = "octree";
constexpr std::string_view kSingle = "single", kDigits = "digits";
/// More interpolants a field than this have a smaller error than rounding.
constexpr int kMaxInterpolants = 128;

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  const auto similar = grammar::closest(word, candidates);
  return similar ? fmt::format("; did you mean `{}`?", *similar) : ";";
}

Parsed<SolverChoice> unknown_solver(std::string_view text, std::string_view word) {
  std::vector<std::string_view> words;
  for (const NamedSolver& solver : kSolvers) words.push_back(solver.word);
  return Parsed<SolverChoice>::error(
      fmt::format("unknown solver `{}`{} the solvers are {}", text, did_you_mean(word, words), solvers_text()));
}

Parsed<SolverChoice> unknown_switch(std::string_view word) {
  std::vector<std::string_view> words = {kPlain};
  for (const PaperSwitch& s : render::kPaperSwitches) words.insert(words.end(), {s.on, s.off});
  return Parsed<SolverChoice>::error(fmt::format("unknown switch `{}` of the solver{} the switches are {}", word,
                                                 did_you_mean(word, words), solver_switches_text()));
}

/// Turns a switch; returns false if there is none with that name.
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

/// The text up to the next `mark`; removes both from `text`.
std::string_view take_until(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

/// The words that turn `from` into `wanted`.
std::vector<std::string_view> words_between(const PaperSwitches& from, const PaperSwitches& wanted) {
  std::vector<std::string_view> words;
  for (const PaperSwitch& s : render::kPaperSwitches) {
    if (from.*s.is_on != wanted.*s.is_on) words.push_back(wanted.*s.is_on ? s.on : s.off);
  }
  return words;
}

std::string_view word_of(Argument argument) {
  switch (argument) {
    case Argument::none: return "";
    case Argument::interpolants: return "K";
    case Argument::step: return "STEP";
    case Argument::relaxation: return "OMEGA";
    case Argument::octree: return kOctree;
    case Argument::way: return "single|digits";
  }
  return "";
}

/// Reads the text after the colon into the choice; returns the error, or "".
std::string read_argument(Argument argument, std::string_view text, SolverChoice& choice) {
  switch (argument) {
    case Argument::none: break;
    case Argument::interpolants: {
      const auto k = parse_integer(text, 1, kMaxInterpolants);
      if (!k.ok()) return fmt::format("paper:K with K interpolants from 1 to {}", kMaxInterpolants);
      choice.interpolants = static_cast<int>(k.value());
      break;
    }
    case Argument::step: {
      const auto step = parse_tolerance(text);
      if (!step.ok()) return "a STEP above zero in pixels (0.5px) or scene units (1e-3)";
      choice.step = step.value();
      break;
    }
    case Argument::relaxation: {
      const auto omega = parse_number(text, 1, 2);
      if (!omega.ok() || omega.value() == 2) return "sphere:OMEGA with OMEGA at least 1 and below 2";
      choice.relaxation = omega.value();
      break;
    }
    case Argument::octree:
      if (text != kOctree) return "lg or lg:octree";
      choice.octree = true;
      break;
    case Argument::way:
      choice.single = text == kSingle;
      choice.digits = text == kDigits;
      if (!choice.single && !choice.digits) return "`:single` or `:digits` behind hermite or exact";
      break;
  }
  return "";
}

}  // namespace

Parsed<SolverChoice> parse_solver(std::string_view text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  std::string_view switches = text.substr(std::min(comma + 1, text.size()));
  std::string_view argument = text.substr(0, comma);
  const bool has_argument = argument.find(':') != std::string_view::npos;
  const std::string_view word = take_until(argument, ':');
  const auto solver =
      std::find_if(std::begin(kSolvers), std::end(kSolvers), [&](const auto& s) { return s.word == word; });
  if (solver == std::end(kSolvers) || (has_argument && solver->argument == Argument::none)) {
    return unknown_solver(text, word);
  }
  SolverChoice choice;
  choice.name = solver->name;
  if (has_argument) {
    const std::string expected = read_argument(solver->argument, argument, choice);
    if (!expected.empty()) return Parsed<SolverChoice>::error(fmt::format("expected {}, found `{}`", expected, text));
  }
  if (comma == text.size()) return choice;
  if (!render::is_published(choice.name)) {
    return Parsed<SolverChoice>::error(
        fmt::format("the solver {} takes no switches, found `{}`", word, text.substr(comma)));
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
  if (named->argument == Argument::interpolants) text += fmt::format(":{}", solver.interpolants);
  if (named->argument == Argument::step) text += fmt::format(":{}", to_text(solver.step));
  if (solver.octree) text += fmt::format(":{}", kOctree);
  if (solver.single) text += fmt::format(":{}", kSingle);
  if (solver.digits) text += fmt::format(":{}", kDigits);
  if (named->argument == Argument::relaxation && solver.relaxation != 1) text += fmt::format(":{}", solver.relaxation);
  if (!render::is_published(solver.name)) return text;
  const std::vector<std::string_view> from_default = words_between({}, solver.paper);
  std::vector<std::string_view> from_plain = words_between(render::kPlainPaper, solver.paper);
  from_plain.insert(from_plain.begin(), kPlain);
  for (const std::string_view word : from_plain.size() < from_default.size() ? from_plain : from_default) {
    text += fmt::format(",{}", word);
  }
  return text;
}

std::string solvers_text() {
  std::string text;
  for (const NamedSolver& solver : kSolvers) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", solver.word);
    if (solver.argument != Argument::none) text += fmt::format("[:{}]", word_of(solver.argument));
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
