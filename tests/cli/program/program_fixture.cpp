#include "tests/cli/program/program_fixture.h"

#include "base/check.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace isl::test {

namespace fs = std::filesystem;

ProgramTest::ProgramTest() {
  std::string pattern = (fs::temp_directory_path() / "isl_test_XXXXXX").string();
  ISL_CHECK(mkdtemp(pattern.data()) != nullptr, "{}", pattern);
  folder_ = pattern;
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

ProcessResult ProgramTest::run(std::vector<std::string> arguments, ProcessOptions options) const {
  arguments.insert(arguments.begin(), ISL_PROGRAM);
  if (options.folder.empty()) options.folder = folder_;
  return run_process(arguments, options);
}

std::string ProgramTest::write(const std::string& name, std::string_view text) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream file(folder_ / name, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  ISL_CHECK(file.good(), "{}", name);
  return name;
}

std::string ProgramTest::read(const std::string& name) const {
  std::ifstream file(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace isl::test
