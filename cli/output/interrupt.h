// Ctrl-C as a flag that long work polls. The second Ctrl-C ends the process at once.
#pragma once

#include <atomic>

namespace isl::cli {

/// After this call SIGINT sets the flag instead of ending the process.
void catch_interrupts();

/// The flag; true after Ctrl-C. Lives as long as the process.
[[nodiscard]] const std::atomic<bool>& interrupt_flag();

}  // namespace isl::cli
