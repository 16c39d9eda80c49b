/* Doubles are rounded after each operation, by any compiler under any flags: what is learnt is the same to the bit, and
 * a bound stays one. Included by every source that computes with them; what cannot be mended here is refused. */
#ifndef QUARTER_MODEL_ROUNDING_H
#define QUARTER_MODEL_ROUNDING_H

#include <float.h>

/* 16 concerns half floats, which there are none of here. */
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "Quarter's learner needs doubles that are computed as doubles: on 32-bit x86 compile with -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Quarter's learner needs doubles as IEEE 754 has them: compile it without -ffast-math and what that stands for"
#endif

/* No product is fused with a sum. gcc does not know the standard's pragma. What clang does not tell of nobody can
 * refuse: -ffp-contract=fast, which overrules the pragma, and -funsafe-math-optimizations without the rest of
 * -ffast-math. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off")
#else
#pragma STDC FP_CONTRACT OFF
#endif

#endif
