#include "cli/memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <limits>

#include "analysis/run_all.h"

namespace mixity::cli {

void keep_freed_memory(const std::vector<FitRequest>& requests) {
  if (std::all_of(requests.begin(), requests.end(), has_small_files)) return;
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_ARENA_MAX, 1);  // a thread's own heap would keep what the others need
#endif
}

}  // namespace mixity::cli
