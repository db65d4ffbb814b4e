#pragma once

//! Marks code that runs on the host and, when compiled by a CUDA compiler, on the device.
#if defined(__CUDACC__)
#define DEMENS_FUNCTION __host__ __device__
#else
#define DEMENS_FUNCTION
#endif

//! Before a template of DEMENS_FUNCTION that calls what it is given: it runs where that runs.
#if defined(__CUDACC__)
#define DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES _Pragma("nv_exec_check_disable")
#else
#define DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES
#endif

//! Forces inlining of small formulas into the vectorised loops that call them.
#if defined(__CUDACC__)
#define DEMENS_INLINE __forceinline__
#else
#define DEMENS_INLINE __attribute__((always_inline)) inline
#endif

//! One copy of a hot loop per instruction set, the best one chosen when the program starts. Results are the
//! same on all of them, since the build forbids contraction of products and sums.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__) &&               \
    !defined(__SANITIZE_ADDRESS__)
#define DEMENS_MULTIVERSION                                                                                  \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"), flatten))
#else
#define DEMENS_MULTIVERSION
#endif
