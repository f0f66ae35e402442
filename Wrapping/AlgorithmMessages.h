// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What VTK algorithms say when they fail, as the library's codes and sentences. For programs that
/// run algorithms: the command line and the Python package.

#ifndef featurehex_AlgorithmMessages_h
#define featurehex_AlgorithmMessages_h

#include "Status.h"

#include <vtkErrorCode.h>

#include <string>

namespace featurehex
{
/// "ERROR: In file.cxx, line 7\nvtkClass (0x1234): the message\n\n" -> "the message\n\n".
inline std::string MessageOf(const char* text)
{
  std::string message = text ? text : "";
  const std::size_t object = message.find("): ");
  if (message.find("In ") != std::string::npos && object != std::string::npos)
  {
    message.erase(0, object + 3);
  }
  return message;
}

/// The code behind vtkAlgorithm::GetErrorCode(), @a otherwise where it is none of ours.
inline StatusCode CodeOf(unsigned long error, StatusCode otherwise)
{
  if (error > vtkErrorCode::UserError)
  {
    const unsigned long code = error - vtkErrorCode::UserError;
    return code <= static_cast<unsigned long>(StatusCode::Unexpected)
             ? static_cast<StatusCode>(code)
             : otherwise;
  }
  return otherwise;
}
} // namespace featurehex

#endif
