// The origin of each primitive: the block's place in the text, and the macro calls and includes that led there. The
// database carries only the opaque number; cli resolves it here for messages to the user. Chains share their tails, so
// a component made by a macro costs a few words.
#pragma once

#include "base/diagnostic.h"
#include "base/growing_array.h"
#include "base/source_span.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace isl::interpreter {

struct Origin {
  SourceSpan span;
  std::vector<ExpansionFrame> chain;  ///< innermost first
};

class OriginTable {
 public:
  /// A chain in the table; 0 is the empty one.
  using Chain = std::uint32_t;

  /// Adds a call on top of `outer`; `name` comes from keep_name().
  [[nodiscard]] Chain extend(Chain outer, ExpansionFrame::Kind kind, std::uint32_t name, SourceSpan call);
  /// Stores a macro's or file's name, once for any number of calls; the number goes to extend().
  [[nodiscard]] std::uint32_t keep_name(std::string name);
  [[nodiscard]] const std::string& name(std::uint32_t number) const { return names_[number]; }
  [[nodiscard]] OriginId add(SourceSpan span, Chain chain);

  /// The default OriginId (0) gives an empty span and chain.
  [[nodiscard]] Origin resolve(OriginId id) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Link {
    Chain outer;
    std::uint32_t name;
    SourceSpan call;
    ExpansionFrame::Kind kind;
  };
  struct Record {
    SourceSpan span;
    Chain chain;
  };

  GrowingArray<Link> links_;
  GrowingArray<Record> records_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> numbers_;  ///< name → index in names_
};

}  // namespace isl::interpreter
