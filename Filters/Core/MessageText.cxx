// SPDX-License-Identifier: BSD-3-Clause
#include "MessageText.h"

#include <locale>
#include <sstream>

namespace featurehex
{
std::string NumberText(double value, int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}

std::string CountText(std::size_t count, const char* singular, const char* plural)
{
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

std::string PlaceText(const Vec3& p)
{
  constexpr int digits = 12;
  return "(" + NumberText(p[0], digits) + ", " + NumberText(p[1], digits) + ", " +
    NumberText(p[2], digits) + ")";
}
}
