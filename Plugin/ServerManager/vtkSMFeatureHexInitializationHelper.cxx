// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFeatureHexInitializationHelper.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionManager.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMFeatureHexInitializationHelper);

namespace
{
/// A colour map over 0 to 1.
struct ColorMap
{
  const char* Array;
  bool MarkAbove;             ///< values above 1 have a colour of their own
  std::vector<double> Points; ///< value, red, green, blue
};

const ColorMap ColorMaps[] = {
  // As in featurehex/picture.py.
  { "ScaledJacobian", false,
    { 0.0, 0.40, 0.00, 0.40, 1.0 / 7, 0.75, 0.05, 0.15, 2.0 / 7, 0.90, 0.40, 0.10, 3.0 / 7, 0.98,
      0.80, 0.25, 4.0 / 7, 0.75, 0.88, 0.45, 5.0 / 7, 0.40, 0.76, 0.60, 6.0 / 7, 0.25, 0.60, 0.80,
      1.0, 0.20, 0.40, 0.75 } },
  { "DeviationOfTolerance", true,
    { 0.0, 0.20, 0.40, 0.75, 0.25, 0.40, 0.76, 0.60, 0.5, 0.98, 0.92, 0.55, 0.75, 0.95, 0.55, 0.20,
      1.0, 0.75, 0.05, 0.15 } },
};

/// What is beyond the tolerance.
const double BeyondColor[] = { 0.40, 0.00, 0.40 };
/// AutomaticRescaleRangeMode: ParaView leaves the range as it is.
constexpr int Never = -1;

void MakeColorMap(const ColorMap& map, vtkSMSessionProxyManager* manager)
{
  // The name vtkSMTransferFunctionManager gives it.
  const std::string name = std::string(map.Array) + ".PVLookupTable";
  if (manager->GetProxy("lookup_tables", name.c_str()))
  {
    return;
  }
  vtkNew<vtkSMTransferFunctionManager> functions;
  vtkSMProxy* colors = functions->GetColorTransferFunction(map.Array, manager);
  if (!colors)
  {
    return;
  }
  const unsigned int size = static_cast<unsigned int>(map.Points.size());
  vtkSMPropertyHelper(colors, "RGBPoints").Set(map.Points.data(), size);
  vtkSMPropertyHelper(colors, "ColorSpace").Set("RGB");
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode").Set(Never);
  vtkSMPropertyHelper(colors, "ScalarRangeInitialized").Set(1);
  vtkSMPropertyHelper(colors, "UseAboveRangeColor").Set(map.MarkAbove);
  vtkSMPropertyHelper(colors, "AboveRangeColor").Set(BeyondColor, 3);
  colors->UpdateVTKObjects();
}
} // namespace

//------------------------------------------------------------------------------
vtkSMFeatureHexInitializationHelper::vtkSMFeatureHexInitializationHelper() = default;

//------------------------------------------------------------------------------
vtkSMFeatureHexInitializationHelper::~vtkSMFeatureHexInitializationHelper() = default;

//------------------------------------------------------------------------------
void vtkSMFeatureHexInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType)
{
  for (const ColorMap& map : ColorMaps)
  {
    MakeColorMap(map, proxy->GetSessionProxyManager());
  }
}

//------------------------------------------------------------------------------
void vtkSMFeatureHexInitializationHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
