// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFeatureHexInitializationHelper.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionManager.h"

#include <cstring>
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

/// What an input property is connected to, nullptr without.
vtkSMProxy* InputOf(vtkSMProxy* proxy, const char* property)
{
  vtkSMPropertyHelper helper(proxy, property, true);
  return helper.GetNumberOfElements() > 0 ? helper.GetAsProxy() : nullptr;
}

/// Filters of FeatureHex leave the mesh where its surface is; others may move or cut it.
bool IsOurs(vtkSMProxy* proxy)
{
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* menu = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* category = menu ? menu->GetAttribute("category") : nullptr;
  return category && std::strcmp(category, "FeatureHex") == 0;
}

/// Surface and tolerance of a filter are those that its input was made from and with.
void AdoptSurface(vtkSMProxy* filter)
{
  vtkSMProxy* source = InputOf(filter, "Surface") ? nullptr : InputOf(filter, "Input");
  while (source && IsOurs(source))
  {
    const bool isMesher = std::strcmp(source->GetXMLName(), "FeatureHexMesher") == 0;
    const char* property = isMesher ? "Input" : "Surface";
    if (vtkSMProxy* surface = InputOf(source, property))
    {
      vtkSMPropertyHelper(filter, "Surface")
        .Set(surface, vtkSMPropertyHelper(source, property).GetOutputPort());
      if (source->GetProperty("Tolerance"))
      {
        vtkSMPropertyHelper(filter, "Tolerance")
          .Set(vtkSMPropertyHelper(source, "Tolerance").GetAsDouble());
      }
      filter->UpdateVTKObjects();
      return;
    }
    source = InputOf(source, "Input");
  }
}

/// The features of a surface that comes from Surface Feature.
void AdoptFeatures(vtkSMProxy* filter)
{
  constexpr unsigned int featurePort = 1;
  vtkSMProxy* source = InputOf(filter, "Features") ? nullptr : InputOf(filter, "Input");
  if (source && std::strcmp(source->GetXMLName(), "SurfaceFeature") == 0)
  {
    vtkSMPropertyHelper(filter, "Features").Set(source, featurePort);
    filter->UpdateVTKObjects();
  }
}
} // namespace

//------------------------------------------------------------------------------
vtkSMFeatureHexInitializationHelper::vtkSMFeatureHexInitializationHelper() = default;

//------------------------------------------------------------------------------
vtkSMFeatureHexInitializationHelper::~vtkSMFeatureHexInitializationHelper() = default;

//------------------------------------------------------------------------------
void vtkSMFeatureHexInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  for (const ColorMap& map : ColorMaps)
  {
    MakeColorMap(map, proxy->GetSessionProxyManager());
  }
  const char* adopted = xml ? xml->GetAttribute("adopt") : nullptr;
  if (adopted && std::strcmp(adopted, "surface") == 0)
  {
    AdoptSurface(proxy);
  }
  else if (adopted && std::strcmp(adopted, "features") == 0)
  {
    AdoptFeatures(proxy);
  }
}

//------------------------------------------------------------------------------
void vtkSMFeatureHexInitializationHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
