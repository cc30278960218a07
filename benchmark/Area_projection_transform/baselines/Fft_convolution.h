// Copyright (c) 2026 The Area Projection Transform authors.
//
// This file is part of the Area_projection_transform package.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_FFT_CONVOLUTION_H
#define CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_FFT_CONVOLUTION_H

#include <CGAL/Area_projection_transform/Grid_3.h>
#include <CGAL/Area_projection_transform/internal/Nested_disks.h>

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>

namespace baselines {

/// \brief sums over balls as products of Fourier transforms, by FFTW, with floats.
///
/// The spectrum of the ball and the plans are computed once. The grid is extended by the radius of the
/// ball, as what leaves on one side returns on the other, and on to a size of small factors.
class Fft_convolution
{
public:
  /// \param threads must be 1 without the threads of FFTW
  Fft_convolution(const CGAL::Area_projection::Grid_3& grid, int squared_radius, int threads)
      : m_size(grid.size())
  {
    const int reach = CGAL::Area_projection::internal::floor_of_root(squared_radius);
    for(int axis = 0; axis < 3; ++axis)
      m_extended[axis] = smooth_size(m_size[axis] + reach);
    m_complex_row = std::size_t(m_extended[0] / 2 + 1);
    m_number = m_complex_row * std::size_t(m_extended[1]) * std::size_t(m_extended[2]);
    m_data.reset(fftwf_alloc_real(2 * m_number));
    m_kernel.reset(fftwf_alloc_real(2 * m_number));
#ifdef AREA_PROJECTION_TRANSFORM_FFTW_THREADS
    fftwf_init_threads();
    fftwf_plan_with_nthreads(threads);
#else
    static_cast<void>(threads);
#endif
    m_forward.reset(fftwf_plan_dft_r2c_3d(m_extended[2], m_extended[1], m_extended[0], m_data.get(),
                                          complex(m_data), FFTW_MEASURE));
    m_backward.reset(fftwf_plan_dft_c2r_3d(m_extended[2], m_extended[1], m_extended[0],
                                           complex(m_data), m_data.get(), FFTW_MEASURE));
    compute_kernel(reach, squared_radius);
  }

  /// \param votes, sums the values of all voxels, x fastest
  void operator()(const float* votes, float* sums)
  {
    std::fill_n(m_data.get(), 2 * m_number, 0.f);
    const std::size_t bytes = sizeof(float) * std::size_t(m_size[0]);
    for(int k = 0; k < m_size[2]; ++k)
      for(int j = 0; j < m_size[1]; ++j, votes += m_size[0])
        std::memcpy(row(j, k), votes, bytes);
    fftwf_execute(m_forward.get());
    multiply();
    fftwf_execute(m_backward.get());
    for(int k = 0; k < m_size[2]; ++k)
      for(int j = 0; j < m_size[1]; ++j, sums += m_size[0])
        std::memcpy(sums, row(j, k), bytes);
  }

private:
  struct Free
  {
    void operator()(float* floats) const { fftwf_free(floats); }
    void operator()(fftwf_plan plan) const { fftwf_destroy_plan(plan); }
  };
  using Floats = std::unique_ptr<float[], Free>;
  using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, Free>;

  static fftwf_complex* complex(const Floats& floats)
  {
    return reinterpret_cast<fftwf_complex*>(floats.get());
  }

  /// the next size without a prime factor above 7.
  static int smooth_size(int size)
  {
    for(;; ++size) {
      int rest = size;
      for(const int prime : {2, 3, 5, 7})
        while(rest % prime == 0)
          rest /= prime;
      if(rest == 1)
        return size;
    }
  }

  float* row(int j, int k)
  {
    return m_data.get() +
           2 * m_complex_row * (std::size_t(j) + std::size_t(m_extended[1]) * std::size_t(k));
  }

  void compute_kernel(int reach, int squared_radius)
  {
    const auto wrapped = [this](int i, int axis) { return i < 0 ? i + m_extended[axis] : i; };
    std::fill_n(m_data.get(), 2 * m_number, 0.f);
    const float one =
        1 / (float(m_extended[0]) * float(m_extended[1]) * float(m_extended[2])); // not normalised
    for(int k = -reach; k <= reach; ++k)
      for(int j = -reach; j <= reach; ++j)
        for(int i = -reach; i <= reach; ++i)
          if(i * i + j * j + k * k <= squared_radius)
            row(wrapped(j, 1), wrapped(k, 2))[wrapped(i, 0)] = one;
    fftwf_execute(m_forward.get());
    std::copy_n(m_data.get(), 2 * m_number, m_kernel.get());
  }

  void multiply()
  {
    float* const a = m_data.get();
    const float* const b = m_kernel.get();
    for(std::size_t i = 0; i < 2 * m_number; i += 2) {
      const float real = a[i] * b[i] - a[i + 1] * b[i + 1];
      a[i + 1] = a[i] * b[i + 1] + a[i + 1] * b[i];
      a[i] = real;
    }
  }

  std::array<int, 3> m_size, m_extended;
  std::size_t m_complex_row, m_number;
  Floats m_data, m_kernel;
  Plan m_forward, m_backward;
};

} // namespace baselines

#endif // CGAL_AREA_PROJECTION_TRANSFORM_BENCHMARK_FFT_CONVOLUTION_H
