#include "cli/output/console.h"

#include "cli/output/standard_output.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>

namespace isl::cli {
namespace {

/// Results are written in pieces of this size: few calls, and little memory.
constexpr std::size_t kBufferBytes = 1 << 16;

/// Standard output as text; there is one for the process.
struct Output {
  std::string buffer;
  std::string problem;  ///< the first error; nothing is written after it

  void flush() {
    const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(buffer.data()), buffer.size());
    if (problem.empty()) problem = write_standard_output(bytes);
    buffer.clear();
  }
};

Output& output() {
  static Output instance;
  return instance;
}

int descriptor_of(Stream stream) { return stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO; }

void write(Stream stream, std::string_view bytes) {
  if (stream == Stream::error) {
    write_standard_error({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
    return;
  }
  output().buffer += bytes;
  if (output().buffer.size() >= kBufferBytes) output().flush();
}

bool goes_to_file(Stream stream) {
  struct stat status {};
  return ::fstat(descriptor_of(stream), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

void print(Stream stream, const SafeText& text) { write(stream, text.text()); }

void print(Stream stream, std::string_view any) { print(stream, SafeText(any)); }

void print_content(Stream stream, std::string_view content) {
  static const bool kOutputIsFile = goes_to_file(Stream::output), kErrorIsFile = goes_to_file(Stream::error);
  if (stream == Stream::output ? kOutputIsFile : kErrorIsFile) {
    write(stream, content);
  } else {
    print(stream, content);
  }
}

void print_json(std::string_view document) { write(Stream::output, json_with_visible_controls(document)); }

bool wants_colour(Stream stream) {
  const char* const no_colour = std::getenv("NO_COLOR");  // https://no-color.org
  return isatty(descriptor_of(stream)) != 0 && (no_colour == nullptr || *no_colour == '\0');
}

std::string finish_standard_output() {
  output().flush();
  return std::exchange(output().problem, {});
}

}  // namespace isl::cli
