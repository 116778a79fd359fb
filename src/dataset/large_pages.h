// Memory in large pages, where the system has them.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace mixity {

/// Asks for large pages behind this memory, which has not been written to yet: handed out in pages of 4 kB, the points
/// of a large file cost more time than reading them. Changes nothing else, and nothing at all outside Linux.
inline void prefer_large_pages(const void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const auto last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / kPage * kPage;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);  // advice: failing is no loss
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

}  // namespace mixity
