// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFeatureFilter
 * @brief Checks that a surface bounds a body, repairs what needs no guessing, orients it.
 *
 * Merges points of equal coordinates, drops unused points, collapsed and duplicate triangles, flips
 * triangles with collinear corners away, and orients each component outward, or inward where its
 * nesting makes it a cavity. Anything else is an error that says what is wrong and where.
 *
 * <b>Input 0:</b> vtkPolyData: triangles, strips or polygons (these are triangulated).
 *
 * <b>Input 1 (optional):</b> vtkPolyData, annotation of sharp features. Not used yet: a warning
 * says so.
 *
 * <b>Output 0:</b> vtkPolyData, triangles, points in double precision in the order of the input.
 * Cells: PatchId (int, 0 and up: the component, in the order of their first triangles). Field data,
 * one value each: NumberOfComponents, NumberOfCavities, Genus (sum), Volume (of the material),
 * Diagonal (of the bounding box), MergedPoints, UnusedPoints, CollapsedTriangles,
 * DuplicateTriangles, FlippedEdges, ReorientedTriangles (double), SurfaceRepairs (string, in
 * words).
 *
 * <b>Output 1:</b> vtkPolyData, the feature graph. Empty without features.
 *
 * <b>Guarantees:</b> output 0 is a closed, oriented manifold without self-intersections (exact
 * tests). The shape is not changed.
 *
 * <b>Errors:</b> an empty surface, ids out of range, coordinates that are not finite, open or
 * non-manifold edges, non-manifold vertices, a surface that can't be oriented, zero volume,
 * self-intersections. Repair the surface in the program it comes from; the message names the first
 * places. Repairs other than merging give a warning.
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> n log n; 0.5 s for 100,000 triangles on one core.
 *
 * @sa vtkSurfaceOctreeFilter vtkFeatureHexMesher
 */

#ifndef vtkSurfaceFeatureFilter_h
#define vtkSurfaceFeatureFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkSurfaceFeatureFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkSurfaceFeatureFilter* New();
  vtkTypeMacro(vtkSurfaceFeatureFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceFeatureFilter();
  ~vtkSurfaceFeatureFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkSurfaceFeatureFilter(const vtkSurfaceFeatureFilter&) = delete;
  void operator=(const vtkSurfaceFeatureFilter&) = delete;
};

#endif
