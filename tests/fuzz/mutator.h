// Scenes with tokens exchanged. Each is a copy of a real scene with one to four mistakes, as a tired user or a broken
// generator makes them. Half of the scenes keep their brackets and the class of every token (a word for a word, a
// number for a number), so that the interpreter and the renderer meet the mistakes and not the parser. The same seed
// gives the same scenes on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

/// The scene's tokens, each with the space before it; comments count as space.
using TokenList = std::vector<std::string>;

[[nodiscard]] TokenList tokens_of(std::string_view text);

class Mutator {
 public:
  Mutator(std::vector<TokenList> scenes, std::uint64_t seed) : scenes_(std::move(scenes)), state_(seed) {}

  /// The next scene.
  [[nodiscard]] std::string next();
  /// The index of the scene from which the last one was made.
  [[nodiscard]] std::size_t origin() const { return origin_; }

 private:
  [[nodiscard]] std::uint64_t draw();
  template <std::size_t count>
  [[nodiscard]] std::string pick(const std::string_view (&list)[count]) {
    return std::string(list[below(count)]);
  }
  [[nodiscard]] std::size_t below(std::size_t bound) { return static_cast<std::size_t>(draw() % bound); }
  void change(TokenList& tokens);
  void change_gently(TokenList& tokens);
  void replace_by_its_like(std::string& token);
  void splice(TokenList& tokens);
  [[nodiscard]] std::string foreign_token();

  std::vector<TokenList> scenes_;
  std::uint64_t state_;
  std::size_t origin_ = 0;
};

}  // namespace isl::test
