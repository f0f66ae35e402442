// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every fuzz target checks.

#ifndef featurehex_FuzzChecks_h
#define featurehex_FuzzChecks_h

#include "Status.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace featurehex
{
/// Ends the program, so that the fuzzer keeps the input.
inline void Require(bool condition, const char* promise)
{
  if (!condition)
  {
    std::fprintf(stderr, "Broken promise: %s\n", promise);
    std::abort();
  }
}

inline std::string_view BytesOf(const std::uint8_t* data, std::size_t size)
{
  return { reinterpret_cast<const char*>(data), size };
}

/// An error has a message, of one line that a terminal can print whatever the file holds.
inline void CheckStatus(const Status& status)
{
  Require(status.Ok() == status.Message.empty(), "a message exactly with an error");
  Require(status.Message.size() < 2000, "a short message");
  for (const char c : status.Message)
  {
    Require(static_cast<unsigned char>(c) >= 32 && c != 127, "a message of printable characters");
  }
}

inline void CheckId(const std::vector<Index>& ids, std::size_t count)
{
  for (const Index id : ids)
  {
    Require(id >= 0 && static_cast<std::size_t>(id) < count, "ids in range");
  }
}

template <typename Element>
void CheckIds(const std::vector<Element>& elements, std::size_t count)
{
  for (const Element& element : elements)
  {
    for (const Index id : element)
    {
      Require(id >= 0 && static_cast<std::size_t>(id) < count, "ids in range");
    }
  }
}
}

#endif
