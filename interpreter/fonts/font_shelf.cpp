#include "interpreter/fonts/font_shelf.h"

#include "grammar/text_file.h"
#include "interpreter/context.h"

#include <fmt/format.h>

#include <fcntl.h>

namespace isl::interpreter {
namespace {

namespace fs = std::filesystem;

/// The font's bytes stay in memory until the scene has been read.
std::unique_ptr<Font> opened(Context& context, std::string bytes, const std::string& shown, SourceSpan where) {
  context.check_memory(where, bytes.size());
  context.memory.add(bytes.size());
  std::string problem;
  std::unique_ptr<Font> font = Font::open(std::move(bytes), problem);
  if (!font) context.fail(where, fmt::format("cannot read the font `{}`: {}", shown, problem));
  return font;
}

}  // namespace

std::unique_ptr<Font> FontShelf::open_file(Context& context, const std::string& name, SourceSpan where,
                                           grammar::AccessProblem& problem) {
  const std::shared_ptr<const std::string> bytes = context.loader.use_file(name, context.current_unit(), problem);
  return bytes ? opened(context, *bytes, grammar::shown_name(name), where) : nullptr;
}

std::unique_ptr<Font> FontShelf::open_installed(Context& context, const fs::path& file, SourceSpan where) {
  std::error_code error;
  const fs::path place = fs::canonical(file, error);
  grammar::TextFile content = grammar::read_bytes_at(AT_FDCWD, place.string(), context.loader.max_file_bytes());
  if (!content.trouble.empty())
    context.fail(where, fmt::format("cannot read the font `{}`: {}", file.string(), content.trouble), content.hint);
  return opened(context, std::move(content.text), file.string(), where);
}

const Font& FontShelf::find(Context& context, const std::string& name, SourceSpan where) {
  std::unique_ptr<Font>& font = fonts_[{context.current_unit().file.parent_path(), name}];
  if (font) return *font;
  grammar::AccessProblem problem;
  font = open_file(context, name, where, problem);
  if (!font && problem.error == grammar::AccessError::not_found && !fs::path(name).has_extension())
    font = open_file(context, name + ".ttf", where, problem);
  if (font) return *font;
  // Libraries often hold a link to an installed font, which a scene may use though it may not follow the link.
  if (const fs::path installed = system_.find(fs::path(name).filename().string()); !installed.empty()) {
    font = open_installed(context, installed, where);
    return *font;
  }
  if (problem.error != grammar::AccessError::not_found) context.fail(where, problem.message, problem.hint);
  const fs::path substitute = system_.substitute_for(name);
  if (substitute.empty()) {
    context.fail(
        where, fmt::format("there is no font `{}`, and the system has none to use instead", grammar::shown_name(name)),
        "install fonts, such as the package fonts-liberation, or name a font's file");
  }
  font = open_installed(context, substitute, where);
  context.warn(where, fmt::format("there is no font `{}`; `{}` takes its place", grammar::shown_name(name),
                                  substitute.filename().string()));
  return *font;
}

}  // namespace isl::interpreter
