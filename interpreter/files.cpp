#include "interpreter/files.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/file_output.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Datum;
using grammar::Node;
using grammar::NodeKind;
namespace word = grammar::word;

/// Byte limit of a file that is read to be appended to.
constexpr std::size_t kMaxAppendedBytes = std::size_t{256} << 20;

/// The text between the quotes without escapes: in a file's name, a backslash is an ordinary character.
std::string name_of_file(Context& context, const Node& path) {
  if (path.kind == NodeKind::string) return std::string(as<grammar::String>(path).raw);
  Value keep;
  return evaluate_string(context, path, keep).text;
}

// ---- Closing --------------------------------------------------------------------------------------------------------

/// The text stays in memory, which counts it, until the scene has been read.
void write_out(Context& context, FileValue& file) {
  grammar::FileAccess& access = context.loader.access();
  context.memory.remove(file.written.size() + access.written_bytes());
  access.write(file.place, file.name, std::move(file.written), file.opened_at);
  context.memory.add(access.written_bytes());
}

void close(Context& context, FileValue& file) {
  if (!file.is_open) return;
  file.is_open = false;
  auto& files = context.files.files;
  files.erase(std::find_if(files.begin(), files.end(), [&](const auto& open) { return open.get() == &file; }));
  if (!file.is_reader()) write_out(context, file);
  file.reader.reset();
  file.place = {};
}

/// Forgets the file under every name that it was passed on by.
void forget_handle(Context& context, grammar::Symbol handle) {
  Slot* const slot = context.scopes.find(handle);
  if (!slot) return;
  slot->value.reset();
  context.scopes.undef(handle);
}

/// The value to read or write may come from a macro that closes the file.
void check_open(Context& context, const FileValue& file, SourceSpan span) {
  if (!file.is_open)
    context.fail(span,
                 fmt::format("`{}` was closed while the statement was evaluated", grammar::shown_name(file.name)));
}

// ---- Opening --------------------------------------------------------------------------------------------------------

void open_to_read(Context& context, const grammar::Fopen& node, FileValue& file) {
  grammar::AccessProblem problem;
  file.reader = context.loader.open_data(file.name, context.current_unit(), problem);
  if (!file.reader) context.fail(node.path->span, problem.message, problem.hint);
}

/// Counts a place to write that the scene has not used before. It is remembered to the end, with its names and its
/// entry among the files of the run.
void count_place(Context& context, SourceSpan span, std::size_t places_before) {
  constexpr std::size_t kPlaceBytes = 1024;
  const std::size_t places = context.loader.access().places_count(), limit = context.options.limits.max_files;
  if (places == places_before) return;
  if (places > limit) {
    context.stop(span, fmt::format("the scene writes more than {} files", limit),
                 "possible infinite loop; `--max-files` raises the limit");
  }
  context.check_memory(span, kPlaceBytes);
  context.memory.add(kPlaceBytes);
}

void open_to_write(Context& context, const grammar::Fopen& node, FileValue& file) {
  grammar::FileAccess& access = context.loader.access();
  const std::size_t places_before = access.places_count();
  if (access.may_write()) {
    file.place = access.find_writable(file.name);
  } else if (context.options.lenient) {
    file.place = access.in_memory(file.name);
    context.warn(node.path->span,
                 fmt::format("`{}` is kept in memory only, because no `--allow-write` folder covers it",
                             grammar::shown_name(file.name)),
                 "`--allow-write DIR` lets a scene write below DIR");
  } else {
    context.fail(
        node.path->span,
        fmt::format("`{}` may not be written: no `--allow-write` folder covers it", grammar::shown_name(file.name)),
        "`--allow-write DIR` lets it write below DIR");
  }
  if (file.place.problem.error != grammar::AccessError::none) {
    context.fail(node.path->span, file.place.problem.message, file.place.problem.hint);
  }
  count_place(context, node.span, places_before);
  if (node.mode != word::kw_append) return;
  grammar::TextFile existing = access.read_existing(file.place, kMaxAppendedBytes);
  if (!existing.trouble.empty() && existing.exists) {
    context.fail(node.path->span,
                 fmt::format("cannot append to `{}`: {}", grammar::shown_name(file.name), existing.trouble));
  }
  context.check_memory(node.span, existing.text.size());
  context.memory.add(existing.text.size());
  file.written = std::move(existing.text);
}

// ---- Reading --------------------------------------------------------------------------------------------------------

FileValue* file_of(Context& context, grammar::Symbol handle, SourceSpan span) {
  const Slot* const slot = context.scopes.find(handle);
  if (!slot || slot->value.kind() == ValueKind::none) {
    context.fail(span, fmt::format("`{}` is not an open file", context.text(handle)),
                 slot ? "" : context.suggest_declared(handle));
  }
  if (slot->value.kind() == ValueKind::poison) throw Failed{};
  if (slot->value.kind() != ValueKind::file) {
    context.fail(span, fmt::format("`{}` is {}, not an open file", context.text(handle), describe(slot->value)));
  }
  FileValue& file = slot->value.as<FileValue>();
  if (!file.is_open) context.fail(span, fmt::format("`{}` is closed", grammar::shown_name(file.name)));
  return &file;
}

Datum next_datum(Context& context, FileValue& file) {
  try {
    Datum datum = file.reader->next();
    if (datum.kind == Datum::Kind::mistake) {
      context.fail(datum.span, fmt::format("`#read`: {}", datum.text));
    }
    return datum;
  } catch (const grammar::ScannerFailure& failure) {
    context.fail(file.opened_at, fmt::format("cannot read `{}`: {}", file.name, failure.what()));
  }
}

Value value_of(Context& context, const Datum& datum) {
  switch (datum.kind) {
    case Datum::Kind::number: return Value(datum.terms[0]);
    case Datum::Kind::vector: return {datum.count, datum.terms};
    default: return make_string(context, datum.text, datum.span);
  }
}

/// The slot that `#declare target` would write to.
Slot& target_slot(Context& context, const Node& target) {
  if (grammar::is_place(target)) return used(context, slot_to_write(context, target, false), target.span);
  context.fail(target.span, "expected an identifier or an array element to read into");
}

std::vector<const Node*> targets_of(const grammar::Read& node) {
  std::vector<const Node*> targets;  // the commas between them may be missing
  for (const grammar::Argument& argument : node.targets) {
    targets.insert(targets.end(), argument.begin(), argument.end());
  }
  return targets;
}

}  // namespace

void open_file(Context& context, const grammar::Fopen& node) {
  const Slot* const slot = context.scopes.find(node.handle);
  if (slot && slot->value.kind() > ValueKind::poison) {
    context.fail(node.span,
                 fmt::format("`{}` is already {}; choose another name for the file", context.text(node.handle),
                             describe(slot->value)),
                 slot->value.kind() == ValueKind::file ? "close it first with `#fclose`" : "");
  }
  if (node.mode != word::kw_read && node.mode != word::kw_write && node.mode != word::kw_append) {
    context.fail(node.span, fmt::format("expected `read`, `write` or `append`, found `{}`", context.text(node.mode)));
  }
  if (context.files.files.size() == OpenFiles::kMaxOpen) {
    context.fail(node.span, fmt::format("more than {} files are open at once", OpenFiles::kMaxOpen),
                 "close finished files with `#fclose`");
  }
  try {
    Ref<FileValue> file = make_shared_value<FileValue>();
    file->name = name_of_file(context, *node.path);
    file->opened_at = node.path->span;
    if (node.mode == word::kw_read) {
      open_to_read(context, node, *file);
    } else {
      open_to_write(context, node, *file);
    }
    context.files.files.push_back(file);
    context.scopes.declare(node.handle).value = Value(ValueKind::file, file);
  } catch (const Failed&) {
    context.scopes.declare(node.handle).value = Value::poison();
  }
}

void close_file(Context& context, const grammar::Fclose& node) {
  const Slot* const slot = context.scopes.find(node.handle);
  if (!slot) return;
  if (slot->value.kind() == ValueKind::file) {
    const Value keep = slot->value;
    close(context, keep.as<FileValue>());
  } else if (slot->value.kind() > ValueKind::poison) {
    context.warn(node.span,
                 fmt::format("`{}` is {}, not an open file", context.text(node.handle), describe(slot->value)));
    return;
  }
  forget_handle(context, node.handle);
}

void read_file(Context& context, const grammar::Read& node) {
  const Ref<FileValue> file(file_of(context, node.handle, node.span));
  if (!file->is_reader()) {
    context.fail(node.span, fmt::format("`{}` was not opened for reading", grammar::shown_name(file->name)));
  }
  for (const Node* target : targets_of(node)) {
    if (file->reader->is_at_end()) break;
    const Datum datum = next_datum(context, *file);
    if (datum.kind == Datum::Kind::end) break;
    Value value = value_of(context, datum);
    target_slot(context, *target).value = std::move(value);
    check_open(context, *file, node.span);
  }
  if (!file->reader->is_at_end()) return;
  close(context, *file);
  forget_handle(context, node.handle);
}

void write_file(Context& context, const grammar::Write& node) {
  const Ref<FileValue> file(file_of(context, node.handle, node.span));
  if (file->is_reader()) {
    context.fail(node.span, fmt::format("`{}` was not opened for writing", grammar::shown_name(file->name)));
  }
  for (const grammar::Argument& argument : node.values) {
    ElementStream stream(context, argument, node.span);
    while (!stream.peek().is(ElementKind::end)) {
      const std::string bytes = read_output(stream);
      check_open(context, *file, node.span);
      // All bytes that a run writes count, not only those of open files: disks are finite too.
      context.check_memory(node.span, context.files.bytes_written + bytes.size());
      context.files.bytes_written += bytes.size();
      context.memory.add(bytes.size());
      file->written += bytes;
      stream.accept_comma();
    }
  }
}

void close_all_files(Context& context) {
  while (!context.files.files.empty()) {
    const Ref<FileValue> file = context.files.files.back();
    close(context, *file);
  }
}

void stage_written_files(Context& context) {
  for (const grammar::WriteFailure& failure : context.loader.access().stage_written()) {
    context.error(failure.opened_at,
                  fmt::format("cannot write `{}`: {}", grammar::shown_name(failure.name), failure.reason));
  }
}

bool file_exists(const Context& context, const std::string& name) {
  return context.loader.exists(name, context.current_unit());
}

}  // namespace isl::interpreter
