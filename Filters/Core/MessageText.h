// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers, counts and places in messages, the same in every locale.

#ifndef featurehex_MessageText_h
#define featurehex_MessageText_h

#include "Types.h"

#include <string>

namespace featurehex
{
/// Shortest text with this many significant digits: "30", "0.005".
std::string NumberText(double value, int digits = 6);

/// "1 edge", "2 edges".
std::string CountText(std::size_t count, const char* singular, const char* plural);

/// "(1, 2.5, 0)", 12 digits.
std::string PlaceText(const Vec3& p);
}

#endif
