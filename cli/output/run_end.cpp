#include "cli/output/run_end.h"

#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>

namespace isl::cli {
namespace {

// A signal handler can only reach globals.
StopFlag flag;

extern "C" void on_signal(int signal) {
  const bool is_first = flag.set(signal == SIGINT    ? StopReason::interrupt
                                 : signal == SIGALRM ? StopReason::time_over
                                                     : StopReason::ended);
  // Queues and terminals send SIGTERM and SIGHUP twice, to a process and to its group; only a user who presses Ctrl-C
  // again cannot wait.
  if (!is_first && signal == SIGINT) _exit(static_cast<int>(ExitCode::interrupted));
}

void catch_signal(int signal) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) catch_signal(signal);
  }
}

void end_after(double seconds) {
  if (!(seconds > 0)) {
    flag.set(StopReason::time_over);
    return;
  }
  catch_signal(SIGALRM);
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &alarm, nullptr);  // whoever started the program may have blocked it
  constexpr double kLongest = 1e9;            // thirty years fit into every system's time
  constexpr double kShortest = 1e-6;          // less would be no time, which is no alarm
  const double limited = std::clamp(seconds, kShortest, kLongest);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(limited);
  timer.it_value.tv_usec = static_cast<suseconds_t>((limited - std::floor(limited)) * 1e6);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

const StopFlag& stop_flag() { return flag; }

ExitCode exit_code_of(StopReason reason) {
  return reason == StopReason::interrupt ? ExitCode::interrupted : ExitCode::ended;
}

std::string_view text_of(StopReason reason) {
  switch (reason) {
    case StopReason::none: break;
    case StopReason::interrupt: return "interrupted";
    case StopReason::ended: return "ended by a signal";
    case StopReason::time_over: return "the time of `--max-time` is over";
  }
  return "";
}

}  // namespace isl::cli
