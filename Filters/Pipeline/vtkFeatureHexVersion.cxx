// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureHexVersion.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFeatureHexVersion);

//------------------------------------------------------------------------------
const char* vtkFeatureHexVersion::GetVersion()
{
  return FEATUREHEX_VERSION;
}

//------------------------------------------------------------------------------
void vtkFeatureHexVersion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Version: " << vtkFeatureHexVersion::GetVersion() << "\n";
}
