#include "cli/session/used_files.h"

#include "cli/output/printable_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace isl::cli {

std::string files_text(std::span<const grammar::UsedFile> files) {
  std::string text;
  for (const grammar::UsedFile& file : files) {
    text += fmt::format("{}{:016x} {}", text.empty() ? "" : "\n", file.hash, file.name);
  }
  return text;
}

std::string files_table(std::span<const grammar::UsedFile> files) {
  std::string text;
  for (const grammar::UsedFile& file : files) {
    text += fmt::format("  {:016x} {}", file.hash, visible_name(file.name));
    if (file.shown != file.name) text += fmt::format(" ({})", visible_name(file.shown.string()));
    text += '\n';
  }
  return text;
}

nlohmann::ordered_json files_json(std::span<const grammar::UsedFile> files) {
  auto result = nlohmann::ordered_json::array();
  for (const grammar::UsedFile& file : files) {
    result.push_back({{"name", file.name}, {"hash", fmt::format("{:016x}", file.hash)}, {"path", file.shown.string()}});
  }
  return result;
}

}  // namespace isl::cli
