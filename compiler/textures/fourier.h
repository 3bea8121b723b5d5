// SPDX-License-Identifier: Apache-2.0
// The discrete Fourier transform of two-dimensional fields, in place, by KISS FFT.
#pragma once

#include <complex>
#include <cstdint>
#include <span>

namespace texgraph::textures {

// `values` has `width` x `height` numbers, x fastest; after a forward transform number (x, y) is
// that of the frequency (x, y), or (x - width, y - height) from the middle on. Forward and then
// inverse multiplies by width x height. Quick where both are products of small primes.
void FourierTransform(std::span<std::complex<double>> values, uint32_t width, uint32_t height,
                      bool inverse);

}  // namespace texgraph::textures
