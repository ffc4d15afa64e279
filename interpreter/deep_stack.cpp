#include "interpreter/deep_stack.h"

#include <pthread.h>

namespace isl::interpreter {

bool run_on_stack(std::size_t bytes, const std::function<void()>& function) {
  // POSIX threads, because std::thread takes no stack size. Pages are committed when they are touched.
  constexpr std::size_t kPage = 65536;
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  pthread_t thread{};
  const auto entry = [](void* argument) -> void* {
    (*static_cast<const std::function<void()>*>(argument))();
    return nullptr;
  };
  auto* const argument = const_cast<std::function<void()>*>(&function);
  const bool started = pthread_attr_setstacksize(&attributes, (bytes + kPage - 1) / kPage * kPage) == 0 &&
                       pthread_create(&thread, &attributes, entry, argument) == 0;
  pthread_attr_destroy(&attributes);
  if (started) pthread_join(thread, nullptr);
  return started;
}

}  // namespace isl::interpreter
