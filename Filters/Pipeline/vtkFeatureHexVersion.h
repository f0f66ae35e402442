// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureHexVersion
 * @brief Version of the FeatureHex library that is loaded.
 *
 * For reports and for programs that must know which release they run with.
 */

#ifndef vtkFeatureHexVersion_h
#define vtkFeatureHexVersion_h

#include "vtkFeatureHexPipelineModule.h" // For export macro
#include "vtkObject.h"

class VTKFEATUREHEXPIPELINE_EXPORT vtkFeatureHexVersion : public vtkObject
{
public:
  static vtkFeatureHexVersion* New();
  vtkTypeMacro(vtkFeatureHexVersion, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * "major.minor.patch".
   */
  static const char* GetVersion();

protected:
  vtkFeatureHexVersion() = default;
  ~vtkFeatureHexVersion() override = default;

private:
  vtkFeatureHexVersion(const vtkFeatureHexVersion&) = delete;
  void operator=(const vtkFeatureHexVersion&) = delete;
};

#endif
