// Marks a loop over pixels of which wide instructions may do many at once; which ones is chosen when the program
// starts. The results are the same bits: no expression is fused or reordered. Sanitizers run before such a choice can
// be made.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define AMISS_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define AMISS_WIDE
#endif
