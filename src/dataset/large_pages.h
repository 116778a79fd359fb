// Memory in large pages, where the system has them.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <memory>

namespace mixity {

/// Asks for large pages behind this memory, which has not been written to yet: handed out in pages of 4 kB, the points
/// of a large file may cost more time than reading them. Changes nothing else, and nothing at all outside Linux.
inline void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kPage = std::size_t{1} << 21;
  // It is advice: where it fails nothing is lost.
  if (std::align(kPage, kPage, begin, bytes)) madvise(begin, bytes / kPage * kPage, MADV_HUGEPAGE);
#endif
}

}  // namespace mixity
