// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Order along a Z-shaped curve, which keeps neighbours in space near each other (G. Morton, 1966).

#ifndef featurehex_MortonCode_h
#define featurehex_MortonCode_h

#include <cstdint>

namespace featurehex
{
/// The lowest 21 bits, each followed by two zeros.
inline std::uint64_t SpreadBits(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

/// Of a place in a lattice of at most 2^21 places a direction.
inline std::uint64_t MortonCode(std::uint64_t x, std::uint64_t y, std::uint64_t z)
{
  return SpreadBits(x) | SpreadBits(y) << 1 | SpreadBits(z) << 2;
}
} // namespace featurehex

#endif
