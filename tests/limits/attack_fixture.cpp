#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

/// The size of twenty errors of a few lines each, and a hundred warnings.
constexpr std::size_t kMaxOutputBytes = 100'000;

}  // namespace

ProcessResult AttackTest::attack(const std::filesystem::path& where, std::vector<std::string> command,
                                 const std::string& name, const std::vector<std::string>& options) {
  const std::string as = command.front();
  command.insert(command.end(), {name, "--max-memory", fmt::format("{}M", kMaxMemoryMegabytes)});
  command.insert(command.end(), options.begin(), options.end());
  ProcessOptions process;
  process.folder = where;
  process.limit = time_bound_;
  ProcessResult result = run(command, process);
  EXPECT_LT(result.exit_code, 128) << as << ": crashed, or took longer than " << time_bound_.count() << " s";
  // A rendering's standard output is the picture.
  EXPECT_LT(result.err.size() + (as == "render" ? 0 : result.out.size()), kMaxOutputBytes) << as;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their own memory is a multiple of the program's
  EXPECT_LT(result.peak_bytes, (kMaxMemoryMegabytes + kBeyondMegabytes) << 20) << as << "\n" << result.err;
#endif
  return result;
}

ProcessResult AttackTest::check_file(const std::string& name, std::vector<std::string> options) {
  // A scene may write files, so the rendering gets a copy of the folder as it is now.
  const std::filesystem::path copy = folder().string() + ".rendered";
  EXPECT_EQ(run_process({"/bin/cp", "-a", folder().string(), copy.string()}).exit_code, 0);
  rendered_exit_code_ = attack(copy, {"render", "-s", "16x12", "-q", "-o", "ppm:-"}, name, options).exit_code;
  std::filesystem::remove_all(copy);
  return attack(folder(), {"check"}, name, options);
}

ProcessResult AttackTest::check(std::string_view text, std::vector<std::string> options) {
  return check_file(write("scene.isl", text), std::move(options));
}

std::string AttackTest::refusal(std::string_view text, std::vector<std::string> options) {
  const ProcessResult result = check(text, std::move(options));
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(rendered_exit_code_, 1) << "rendered";
  return result.err;
}

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace isl::test
