// AMISS_WIDE: compile a kernel twice, for AVX2 and for any x86-64, and choose when the program starts. Both give the
// same bits, since nothing is fused (-ffp-contract=off). Sanitizers run before such a choice can be made.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define AMISS_WIDE __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define AMISS_WIDE
#endif
