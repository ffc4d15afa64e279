#include "grammar/dump.h"

#include "base/check.h"
#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/lexer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>

namespace isl::grammar {
namespace {

constexpr std::array<std::string_view, 3> kUnaryOps{"+", "-", "!"};
constexpr std::array<std::string_view, 12> kBinaryOps{"+", "-", "*", "/", "<", ">", "=", "<=", ">=", "!=", "&", "|"};
constexpr std::array<std::string_view, 3> kMessageKinds{"debug", "warning", "error"};

/// The text as a string literal on one line.
std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\n') {
      result += "\\n";
    } else if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else {
      result += c;
    }
  }
  return result + '"';
}

class TreeDump {
 public:
  explicit TreeDump(const SymbolTable& symbols) : symbols_(symbols) {}

  void items(Items nodes) {
    for (const Node* node : nodes) this->node(*node);
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void node(const Node& node);
  void expression(const Node& node);
  void element(const Node& node);
  void directive(const Node& node);
  void conditional_directive(const Node& node);

  [[nodiscard]] std::string_view text(Symbol symbol) const { return symbols_.text(symbol); }

  /// Writes a line, then the lines of `children()` indented below it.
  template <class Children>
  void tree(std::string_view line, Children children) {
    this->line(line);
    depth_ += 2;
    children();
    depth_ -= 2;
  }
  void line(std::string_view line) { fmt::format_to(std::back_inserter(text_), "{:{}}{}\n", "", depth_, line); }
  void list(std::string_view label, Items nodes) {
    tree(label, [&] { items(nodes); });
  }
  void part(std::string_view label, const Node* part) {
    if (part != nullptr) tree(label, [&] { node(*part); });
  }
  void arguments(std::span<const Argument> arguments) {
    for (const Argument& argument : arguments) list("argument", argument);
  }
  [[nodiscard]] std::string names(std::span<const Symbol> symbols) const {
    std::string joined;
    for (const Symbol symbol : symbols) joined += fmt::format("{}{}", joined.empty() ? "" : ", ", text(symbol));
    return joined;
  }

  [[nodiscard]] std::string parameters(std::span<const Parameter> parameters) const {
    std::string joined;
    for (const Parameter& parameter : parameters)
      joined += fmt::format("{}{}{}", joined.empty() ? "" : ", ", parameter.optional ? "optional " : "",
                            text(parameter.name));
    return joined;
  }

  const SymbolTable& symbols_;
  std::string text_;
  int depth_ = 0;
};

void TreeDump::expression(const Node& node) {
  switch (node.kind) {
    case NodeKind::number: return line(fmt::format("number {}", as<Number>(node).value));
    case NodeKind::string: return line("string " + quoted_text(as<String>(node).text));
    case NodeKind::constant: return line(fmt::format("constant {}", text(as<Constant>(node).word)));
    case NodeKind::name: return line(fmt::format("name {}", text(as<Name>(node).name)));
    case NodeKind::scoped_name: {
      const auto& scoped = as<ScopedName>(node);
      return line(fmt::format("name {}.{}", scoped.scope == ScopeName::local ? "local" : "global", text(scoped.name)));
    }
    case NodeKind::index:
      return tree("index", [&] {
        this->node(*as<Index>(node).base);
        this->node(*as<Index>(node).subscript);
      });
    case NodeKind::call:
      return tree("call", [&] {
        this->node(*as<Call>(node).callee);
        arguments(as<Call>(node).arguments);
      });
    case NodeKind::function_call:
      return tree(fmt::format("call {}", text(as<FunctionCall>(node).function)),
                  [&] { arguments(as<FunctionCall>(node).arguments); });
    case NodeKind::dot:
      return tree(fmt::format("dot {}", text(as<Dot>(node).item)), [&] { this->node(*as<Dot>(node).base); });
    case NodeKind::vector: return list("vector", as<Vector>(node).coordinates);
    case NodeKind::unary:
      return tree(fmt::format("unary {}", kUnaryOps[static_cast<std::size_t>(as<Unary>(node).op)]),
                  [&] { this->node(*as<Unary>(node).operand); });
    case NodeKind::binary:
      return tree(fmt::format("binary {}", kBinaryOps[static_cast<std::size_t>(as<Binary>(node).op)]), [&] {
        this->node(*as<Binary>(node).left);
        this->node(*as<Binary>(node).right);
      });
    case NodeKind::conditional:
      return tree("conditional", [&] {
        this->node(*as<Conditional>(node).condition);
        this->node(*as<Conditional>(node).yes);
        this->node(*as<Conditional>(node).no);
      });
    default: return element(node);
  }
}

void TreeDump::element(const Node& node) {
  switch (node.kind) {
    case NodeKind::word: return line(fmt::format("word {}", text(as<Word>(node).word)));
    case NodeKind::block: {
      const Block& block = as<Block>(node);
      return list(block.word == kNoSymbol ? "block" : fmt::format("block {}", text(block.word)), block.items);
    }
    case NodeKind::block_begin: return line(fmt::format("block {} begins", text(as<BlockBegin>(node).word)));
    case NodeKind::block_end: return line("block ends");
    case NodeKind::entry: return list("entry", as<Entry>(node).items);
    case NodeKind::array:
      return tree("array", [&] {
        list("dimensions", as<Array>(node).dimensions);
        if (as<Array>(node).initialised) list("items", as<Array>(node).items);
      });
    case NodeKind::function: {
      const Function& function = as<Function>(node);
      return tree(function.has_parameters ? fmt::format("function ({})", names(function.parameters)) : "function", [&] {
        if (!function.size.empty()) list("size", function.size);
        items(function.body);
      });
    }
    case NodeKind::dictionary: return list("dictionary", as<Dictionary>(node).items);
    case NodeKind::field:
      return tree("field", [&] {
        this->node(*as<DictionaryField>(node).key);
        list("value", as<DictionaryField>(node).value);
      });
    case NodeKind::tuple:
      return tree("tuple", [&] {
        for (const Items& value : as<Tuple>(node).values) list("value", value);
      });
    case NodeKind::comma: return line("comma");
    case NodeKind::semicolon: return line("semicolon");
    case NodeKind::error: {
      const Complaint* const complaint = as<Error>(node).complaint;
      if (complaint == nullptr) return line("error");
      const char* const severity = complaint->is_error() ? "error" : "warning";
      return line(fmt::format("{} {}", severity, quoted_text(complaint->diagnostic.message)));
    }
    default: return directive(node);
  }
}

void TreeDump::directive(const Node& node) {
  switch (node.kind) {
    case NodeKind::declare:
    case NodeKind::declare_newer_word:
      return tree(as<Declare>(node).local ? "local" : "declare", [&] {
        this->node(*as<Declare>(node).target);
        items(as<Declare>(node).value);
      });
    case NodeKind::declare_deprecated: {
      const auto& declare = as<Declare>(node);
      const Deprecation& deprecation = declare.deprecation;
      return tree(
          fmt::format("{} deprecated{}{}{}", declare.local ? "local" : "declare", deprecation.once ? " once" : "",
                      deprecation.remark.empty() ? "" : " ", deprecation.remark),
          [&] {
            this->node(*declare.target);
            items(declare.value);
          });
    }
    case NodeKind::declare_tuple: {
      const auto& declare = as<DeclareTuple>(node);
      return tree(declare.local ? "local tuple" : "declare tuple", [&] {
        for (const TupleField& field : declare.fields) part(field.optional ? "optional" : "field", field.target);
        list("value", declare.value);
      });
    }
    case NodeKind::undef: return part("undef", as<Undef>(node).target);
    case NodeKind::break_: return line("break");
    case NodeKind::macro:
      return list(fmt::format("macro {} ({})", text(as<Macro>(node).name), parameters(as<Macro>(node).parameters)),
                  as<Macro>(node).body);
    case NodeKind::include: return part("include", as<Include>(node).path);
    case NodeKind::version: return part("version", as<Version>(node).value);
    case NodeKind::default_: return list("default", as<Default>(node).items);
    case NodeKind::message:
      return part(kMessageKinds[static_cast<std::size_t>(as<Message>(node).level)], as<Message>(node).text);
    case NodeKind::fopen:
      return part(fmt::format("fopen {} {}", text(as<Fopen>(node).handle), text(as<Fopen>(node).mode)),
                  as<Fopen>(node).path);
    case NodeKind::fclose: return line(fmt::format("fclose {}", text(as<Fclose>(node).handle)));
    case NodeKind::read:
      return tree(fmt::format("read {}", text(as<Read>(node).handle)), [&] { arguments(as<Read>(node).targets); });
    case NodeKind::write:
      return tree(fmt::format("write {}", text(as<Write>(node).handle)), [&] { arguments(as<Write>(node).values); });
    default: return conditional_directive(node);
  }
}

void TreeDump::conditional_directive(const Node& node) {
  switch (node.kind) {
    case NodeKind::if_:
      return tree("if", [&] {
        part("condition", as<If>(node).condition);
        list("then", as<If>(node).then);
        if (!as<If>(node).otherwise.empty()) list("else", as<If>(node).otherwise);
      });
    case NodeKind::ifdef:
      return tree(as<Ifdef>(node).negated ? "ifndef" : "ifdef", [&] {
        part("target", as<Ifdef>(node).target);
        list("then", as<Ifdef>(node).then);
        if (!as<Ifdef>(node).otherwise.empty()) list("else", as<Ifdef>(node).otherwise);
      });
    case NodeKind::while_:
      return tree("while", [&] {
        part("condition", as<While>(node).condition);
        list("body", as<While>(node).body);
      });
    case NodeKind::for_:
      return tree(fmt::format("for {}", text(as<For>(node).variable)), [&] {
        part("start", as<For>(node).start);
        part("end", as<For>(node).end);
        part("step", as<For>(node).step);
        list("body", as<For>(node).body);
      });
    case NodeKind::switch_:
      return tree("switch", [&] {
        part("subject", as<Switch>(node).subject);
        for (const SwitchCase& choice : as<Switch>(node).cases) {
          tree(choice.high == nullptr ? "case" : "range", [&] {
            this->node(*choice.low);
            if (choice.high != nullptr) this->node(*choice.high);
            list("body", choice.body);
          });
        }
        if (as<Switch>(node).has_default) list("else", as<Switch>(node).otherwise);
      });
    default: ISL_CHECK(false, "node kind {}", static_cast<int>(node.kind));
  }
}

void TreeDump::node(const Node& node) { expression(node); }

}  // namespace

std::string dump_tree(Items items, const SymbolTable& symbols) {
  TreeDump dump(symbols);
  dump.items(items);
  return dump.take();
}

std::string dump_tokens(const SourceMap& map, SourceSpan span, SymbolTable& symbols) {
  Arena arena;
  DiagnosticSink sink;
  Lexer lexer(map.text(span), span.begin, symbols, arena, sink);
  std::string text;
  for (Token token = lexer.next(); token.kind != Parser::token::TOK_END_OF_FILE; token = lexer.next()) {
    const SourcePosition position = map.position(token.span.begin);
    const auto kind = static_cast<Parser::symbol_kind_type>(token.kind);
    const std::string_view name = Parser::symbol_name(kind);
    const std::string_view written = map.text(token.span);
    fmt::format_to(std::back_inserter(text), "{}:{} {}{}\n", position.line, position.column, name,
                   name == written ? "" : fmt::format(" {}", written));
  }
  return text;
}

}  // namespace isl::grammar
