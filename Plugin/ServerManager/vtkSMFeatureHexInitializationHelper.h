// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMFeatureHexInitializationHelper
 * @brief Colour maps with meaningful ranges, and inputs that a new filter finds by itself.
 *
 * ParaView has one colour map for each array name. When the first filter of FeatureHex is created,
 * those of ScaledJacobian and DeviationOfTolerance are made, unless there are ones already: 0 to
 * 1, whatever range the data of one mesh happen to have, so that the same colour means the same in
 * all pictures; ParaView doesn't rescale them by itself. Bad hexes are violet and red, good ones
 * green and blue; deviations turn from blue to red at the tolerance.
 *
 * Nobody has to say again what a mesh was made from. adopt="surface": the inputs Surface and
 * Tolerance are those of the filter that made the mesh, through any number of FeatureHex filters
 * between them. adopt="features": the input Features is that of the Surface Feature that the input
 * comes from. What is given stays.
 *
 * In the XML of a proxy, where adopt is optional: @code <Hints><InitializationHelper
 * class="vtkSMFeatureHexInitializationHelper" adopt="surface"/></Hints> @endcode
 */

#ifndef vtkSMFeatureHexInitializationHelper_h
#define vtkSMFeatureHexInitializationHelper_h

#include "vtkFeatureHexServerManagerModule.h" // For export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKFEATUREHEXSERVERMANAGER_EXPORT vtkSMFeatureHexInitializationHelper
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMFeatureHexInitializationHelper* New();
  vtkTypeMacro(vtkSMFeatureHexInitializationHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMFeatureHexInitializationHelper();
  ~vtkSMFeatureHexInitializationHelper() override;

private:
  vtkSMFeatureHexInitializationHelper(const vtkSMFeatureHexInitializationHelper&) = delete;
  void operator=(const vtkSMFeatureHexInitializationHelper&) = delete;
};

#endif
