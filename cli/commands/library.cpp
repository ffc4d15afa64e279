// `isl library`: what the standard library has, by the comments of its files. It reads no scene.
#include "cli/commands/commands.h"
#include "cli/library/catalogue.h"
#include "cli/library/listing.h"
#include "cli/output/console.h"
#include "cli/session/report.h"
#include "cli/session/search_path.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace isl::cli {
namespace {

/// An error of the command line, as options.cpp prints those that it finds.
ExitCode report_unknown_name(const Catalogue& catalogue, const std::string& name) {
  const std::optional<std::string> similar = catalogue.similar(name);
  const std::string hint =
      similar ? fmt::format("did you mean `{}`?", *similar) : "`isl library` lists the files and the names";
  print(Stream::error, fmt::format("isl: error: the standard library has no file, macro or declaration `{}`\n"
                                   "  hint: {}\n",
                                   visible_name(name), visible_name(hint)));
  return ExitCode::command_line_error;
}

void print_overview(const Catalogue& catalogue, OutputFormat format) {
  if (format == OutputFormat::text) {
    print(Stream::output, overview_text(catalogue));
    return;
  }
  auto libraries = nlohmann::ordered_json::array();
  for (const LibraryFile& file : catalogue.files()) libraries.push_back(library_json(file, file.entries));
  print_document({{"libraries", std::move(libraries)}});
}

void print_match(const LibraryMatch& match, OutputFormat format) {
  const auto& [file, entry] = match;
  if (format == OutputFormat::text) {
    print(Stream::output, entry == nullptr ? library_text(file) : entry_text(file, *entry));
    return;
  }
  auto libraries = nlohmann::ordered_json::array();
  libraries.push_back(library_json(file, entry == nullptr ? file.entries : std::vector{*entry}));
  print_document({{"libraries", std::move(libraries)}});
}

}  // namespace

ExitCode run(const LibraryCommand& command) {
  const std::filesystem::path folder = stdlib_folder();
  if (folder.empty()) {
    print_error("the standard library is missing: there is no folder share/isl beside the program's folder");
    return ExitCode::file_error;
  }
  const Catalogue catalogue(folder);
  if (!catalogue.trouble().empty()) {
    print_error(catalogue.trouble());
    return ExitCode::file_error;
  }
  if (command.name.empty()) {
    print_overview(catalogue, command.format);
    return ExitCode::done;
  }
  const std::optional<LibraryMatch> match = catalogue.find(command.name);
  if (!match) return report_unknown_name(catalogue, command.name);
  print_match(*match, command.format);
  return ExitCode::done;
}

}  // namespace isl::cli
