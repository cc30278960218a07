// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// No include guard: includes the file CGAL_AREA_PROJECTION_KERNEL once for each instruction set.
//
// That file defines, in `namespace CGAL_AREA_PROJECTION_ISA`, plain functions over the lanes of
// `lanes_impl.h`. They are compiled for the instruction set, whatever the flags of the user, and
// without fused multiplication and addition, so that all give the same bits. What they call from elsewhere
// should be inline and small. Call them by CGAL_AREA_PROJECTION_DISPATCHED.

#include <CGAL/Area_projection_transform/internal/simd/instruction_set.h>

#if defined(__x86_64__) || defined(_M_X64)
#include <immintrin.h>
#endif

#include <cstdint>
#include <cstring>

// The flags of a function follow it when it is a template, too, with both compilers.
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC optimize("fp-contract=off")
#endif

#define CGAL_AREA_PROJECTION_ISA portable
#define CGAL_AREA_PROJECTION_LANES 4
#include <CGAL/Area_projection_transform/internal/simd/lanes_impl.h>
#include CGAL_AREA_PROJECTION_KERNEL
#undef CGAL_AREA_PROJECTION_LANES
#undef CGAL_AREA_PROJECTION_ISA

#if CGAL_AREA_PROJECTION_DISPATCH

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define CGAL_AREA_PROJECTION_ISA avx2
#define CGAL_AREA_PROJECTION_LANES 8
#include <CGAL/Area_projection_transform/internal/simd/lanes_impl.h>
#include CGAL_AREA_PROJECTION_KERNEL
#undef CGAL_AREA_PROJECTION_LANES
#undef CGAL_AREA_PROJECTION_ISA
#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq")
#endif
#define CGAL_AREA_PROJECTION_ISA avx512
#define CGAL_AREA_PROJECTION_LANES 16
#include <CGAL/Area_projection_transform/internal/simd/lanes_impl.h>
#include CGAL_AREA_PROJECTION_KERNEL
#undef CGAL_AREA_PROJECTION_LANES
#undef CGAL_AREA_PROJECTION_ISA
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#endif // CGAL_AREA_PROJECTION_DISPATCH

#if defined(__clang__)
#pragma clang fp contract(on)
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#undef CGAL_AREA_PROJECTION_KERNEL
