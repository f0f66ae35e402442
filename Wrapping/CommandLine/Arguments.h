// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What was asked for on the command line.

#ifndef featurehex_Arguments_h
#define featurehex_Arguments_h

#include <string>

namespace featurehex
{
/// Where the sharp features come from.
struct FeatureArguments
{
  std::string File;      ///< .fgraph; empty: none
  bool ByAngle = false;
  double Angle = 0.0;    ///< degrees
  bool EnforceAll = false;
};

struct MeshArguments
{
  std::string Input;
  std::string Output;
  std::string Report; ///< empty: none
  FeatureArguments Features;
  int Threads = 0;    ///< 0: all cores
  int NodesPerHex = 8; ///< 8, 20 or 27

  // Defaults and ranges are those of vtkFeatureHexMesher.
  double Tolerance = 0.0;
  double EdgeLength = 0.0;
  std::string EdgeLengthArray; ///< empty: none
  int MaximumLevel = 0;
  long long MaximumNumberOfCells = 0;
  int MaximumRounds = 0;
  double MinimumScaledJacobian = 0.0;
  bool Align = false;
  double TimeLimit = 0.0;
};

struct CheckArguments
{
  std::string Mesh;
  std::string Surface; ///< empty: only what can be told without one
  std::string Report;  ///< empty: none
  FeatureArguments Features;
  int Threads = 0; ///< 0: all cores
  double Tolerance = 0.0;
};
} // namespace featurehex

#endif
