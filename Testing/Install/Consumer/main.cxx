// SPDX-License-Identifier: BSD-3-Clause
// Prints the version of FeatureHex, and measures a box with the plain structs of its core.
#include "Types.h"
#include "vtkFeatureHexVersion.h"

#include <iostream>

int main()
{
  featurehex::Box box;
  box.Extend(featurehex::Vec3(0, 0, 0));
  box.Extend(featurehex::Vec3(1, 2, 2));
  std::cout << "FeatureHex " << vtkFeatureHexVersion::GetVersion() << ", diagonal "
            << box.Diagonal() << "\n";
  return box.Diagonal() == 3.0 ? 0 : 1;
}
