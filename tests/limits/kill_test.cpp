// A run that is killed, at whatever moment, leaves each of its outputs whole: as it was, or new. The next run removes
// what the killed one left. Thirty kills, nine of them while files are written; ISL_KILLS=200 makes it the long form.
#include "tests/cli/program/program_fixture.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <random>
#include <thread>

namespace isl::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::microseconds;

constexpr std::array kSignals{SIGKILL, SIGTERM, SIGINT, SIGHUP};
const std::vector<std::string> kOutputs{"a.exr", "a.png", "s.json", "x.txt"};

int number_of_kills() {
  const char* const asked = std::getenv("ISL_KILLS");
  return asked == nullptr ? 30 : std::atoi(asked);
}

bool has_ended(int pid) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid;
}

class Kills : public ProgramTest {
 protected:
  Kills() {
    write("scene.isl",
          std::string(kSmallScene) + "#fopen F \"out/x.txt\" write #for (I, 1, 20000) #write (F, I, \"\\n\") #end\n");
    fs::create_directory(folder() / "out");
  }

  [[nodiscard]] ProcessResult render(ProcessOptions options = {}) const {
    return run({"render", "scene.isl", "-s", "640x480", "--samples", "1", "-o", "out/a.exr", "-o", "out/a.png",
                "--stats", "out/s.json", "--allow-write", "out", "-q"},
               std::move(options));
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder() / "out"))
      result.push_back(entry.path().filename());
    std::sort(result.begin(), result.end());
    return result;
  }

  [[nodiscard]] std::ptrdiff_t temporary_files() const {
    const std::vector<std::string> found = names();
    return std::count_if(found.begin(), found.end(), [](const std::string& name) { return name.ends_with(".tmp"); });
  }

  /// True from the first picture to the last renaming. The file of the scene is there since it was read.
  [[nodiscard]] bool is_writing() const { return temporary_files() > 1; }

  void put_old_files() const {
    for (const std::string& name : kOutputs) write("out/" + name, "old " + name);
  }

  /// Statistics hold times, so that two of them never are the same bytes.
  [[nodiscard]] bool is_whole(const std::string& name) const {
    const std::string content = read("out/" + name);
    if (content == "old " + name || content == new_.at(name)) return true;
    return name == "s.json" && content.ends_with("}\n") && nlohmann::json::accept(content);
  }

  std::map<std::string, std::string> new_;  ///< the contents that a run makes
};

TEST_F(Kills, LeaveEveryOutputWhole) {
  // The process's own name for temporary files is seen only by the next run, which is another process.
  const ProcessResult first = render();
  ASSERT_EQ(first.exit_code, 0) << first.err;
  ASSERT_EQ(names(), kOutputs);
  for (const std::string& name : kOutputs) new_[name] = read("out/" + name);

  std::mt19937 random(14);
  auto whole_run = std::chrono::duration_cast<microseconds>(first.seconds);
  const int kills = number_of_kills();
  int killed = 0, while_writing = 0, left_behind = 0, left_for_good = 0, not_whole = 0, replaced = 0;
  for (int turn = 0; turn < kills; ++turn) {
    put_old_files();
    const int signal = kSignals[static_cast<std::size_t>(turn) % kSignals.size()];
    const bool is_aimed = turn % 10 < 3;
    // Files take about a tenth of a run.
    const auto longest = is_aimed ? whole_run / 10 : whole_run;
    const microseconds delay(std::uniform_int_distribution<long>(0, longest.count())(random));
    const ProcessResult result = render({.when_marked = [&](int pid) {
      while (is_aimed && !is_writing() && !has_ended(pid)) {
      }
      std::this_thread::sleep_for(delay);
      while_writing += is_writing() ? 1 : 0;
      kill(pid, signal);
    }});
    killed += result.exit_code != 0 ? 1 : 0;
    for (const std::string& name : kOutputs) {
      if (!is_whole(name)) {
        ++not_whole;
        ADD_FAILURE() << name << " is not whole after signal " << signal << " in turn " << turn;
      }
      replaced += read("out/" + name) != "old " + name ? 1 : 0;
    }
    if (fs::exists(folder() / "out/a.partial.png")) {
      EXPECT_THAT(read("out/a.partial.png"), testing::HasSubstr("IEND"));
    }
    left_behind += temporary_files() > 0 ? 1 : 0;
    const ProcessResult next = render();
    ASSERT_EQ(next.exit_code, 0) << next.err;
    whole_run = std::chrono::duration_cast<microseconds>(next.seconds);  // a busy machine changes its pace
    for (const char* const partial : {"out/a.partial.png", "out/a.partial.exr"}) fs::remove(folder() / partial);
    left_for_good += names() != kOutputs ? 1 : 0;
    for (const std::string& name : kOutputs)
      EXPECT_TRUE(is_whole(name) && read("out/" + name) != "old " + name) << name;
  }
  fmt::print(
      "{} runs, {} killed, {} of them while pictures were written; {} left temporary files, {} of them for good; "
      "of {} outputs {} were new, {} not whole\n",
      kills, killed, while_writing, left_behind, left_for_good, static_cast<std::size_t>(kills) * kOutputs.size(),
      replaced, not_whole);
  EXPECT_EQ(left_for_good, 0) << "the next run did not remove them";
  EXPECT_GT(killed, kills / 3) << "the kills came too late";
  EXPECT_GT(while_writing, kills / 10) << "the kills missed the writing";
}

}  // namespace
}  // namespace isl::test
