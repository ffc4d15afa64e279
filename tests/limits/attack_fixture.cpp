#include "tests/limits/attack_fixture.h"

#include <sys/resource.h>

namespace isl::test {
namespace {

/// Lowers this process's soft limit of memory while it lives, and a program started meanwhile inherits it. Sanitizers
/// reserve terabytes of addresses, so they run without the limit.
class AddressSpaceLimit {
 public:
  explicit AddressSpaceLimit(std::size_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_AS, &limit);
#else
    static_cast<void>(bytes);
#endif
  }
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &before_); }
  AddressSpaceLimit(const AddressSpaceLimit&) = delete;
  AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;

 private:
  rlimit before_{};
};

/// The size of twenty errors of a few lines each, and a hundred warnings.
constexpr std::size_t kMaxOutputBytes = 100'000;

}  // namespace

ProcessResult AttackTest::check_file(const std::string& name, std::vector<std::string> options) {
  std::vector<std::string> arguments{"check", name, "--max-memory", "300M"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  ProcessOptions process;
  process.limit = kTimeBound;
  const AddressSpaceLimit limit(kAddressSpaceBytes);
  ProcessResult result = run(arguments, process);
  EXPECT_LT(result.exit_code, 128) << "crashed, or took longer than " << kTimeBound.count() << " s";
  EXPECT_LT(result.out.size() + result.err.size(), kMaxOutputBytes);
  return result;
}

ProcessResult AttackTest::check(std::string_view text, std::vector<std::string> options) {
  return check_file(write("scene.isl", text), std::move(options));
}

std::string AttackTest::refusal(std::string_view text, std::vector<std::string> options) {
  const ProcessResult result = check(text, std::move(options));
  EXPECT_EQ(result.exit_code, 1) << result.err;
  return result.err;
}

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace isl::test
