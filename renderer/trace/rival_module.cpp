#include "renderer/trace/rival_module.h"

#include "base/program_module.h"
#include "renderer/trace/header_stamp.h"

#include <cstring>

namespace isl::render {
namespace {

using Stamp = const char* (*)();
using Loops = const TraceLoops* (*)(const char*);

struct Rivals {
  Loops loops = nullptr;
  std::string error;
};

Rivals load() {
  ProgramModule module = load_program_module("isl_rivals.so");
  if (!module.error.empty()) return {.error = module.error};
  const auto stamp = module.function<Stamp>("isl_rivals_stamp");
  const auto loops = module.function<Loops>("isl_rivals_loops");
  if (stamp == nullptr || loops == nullptr || std::strcmp(stamp(), kHeaderStamp) != 0) module.fail_as_foreign();
  return {loops, module.error};
}

}  // namespace

RivalLoops rival_loops(const std::string& target) {
  static const Rivals rivals = load();
  RivalLoops answer;
  answer.error = rivals.error;
  if (answer.error.empty()) answer.loops = rivals.loops(target.c_str());
  return answer;
}

}  // namespace isl::render
