// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQuadraticHexFilter
 * @brief Hexes of 20 or 27 nodes from linear ones, boundary nodes on the surface, valid with proof.
 *
 * Each edge gets a node in the middle, with 27 nodes also each face and hex. With a surface those
 * on the boundary move to its closest point, and with its feature graph those on a feature curve to
 * the closest point of this curve. A hex whose Jacobian isn't proven positive everywhere, or whose
 * ratio of smallest to largest determinant falls below a fifth of that of the linear hex, takes its
 * nodes back, by halves and in the end wholly: a hex with straight edges is as valid as the linear
 * one.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid of hexahedra, each valid. Points: FeatureKind, FeatureId
 * (needed with input 2), which vtkFeatureHexMesher makes.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, the surface: closed, without self-intersections.
 *
 * <b>Input 2 (optional):</b> vtkPolyData, the feature graph of the surface, from
 * vtkFeatureGraphReader or output 1 of vtkSurfaceFeatureFilter, as the mesh was made with. Needs
 * input 1.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid of VTK_QUADRATIC_HEXAHEDRON or VTK_TRIQUADRATIC_HEXAHEDRON:
 * points of input 0, then the added ones. Points: FeatureKind, FeatureId (of added points: patch
 * and curve where input 2 says them, else -1). Cells: all arrays of input 0. Field data: that of
 * input 0, and BoundaryNodes (added), NodesOnSurface (of these), NodesShortened (moved only part of
 * the way to keep hexes valid), NodesTooFar (left in the middle because they would have moved more
 * than a quarter of their edge), SmallestJacobianRatio (double, smallest to largest determinant,
 * the worst hex with a moved node; proven).
 *
 * <b>Guarantees:</b> every Jacobian is proven positive in the whole element. Not guaranteed: the
 * distance to the surface (that of the linear mesh; moved nodes lie on the surface) and that the
 * curved boundary doesn't cross itself.
 *
 * <b>Errors:</b> no cells, cells that are not hexahedra, ids out of range, a hex that isn't valid;
 * a surface or features that vtkHexValidationFilter wouldn't take.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> 5 microseconds for the proof of a curved hex, and closest points on the surface.
 *
 * <b>References:</b> A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical validity of curvilinear
 * finite elements", Journal of Computational Physics 233, 2013, doi:10.1016/j.jcp.2012.08.051.
 *
 * @sa vtkFeatureHexMesher vtkAbaqusMeshWriter vtkGmshMeshWriter vtkExodusMeshWriter
 */

#ifndef vtkQuadraticHexFilter_h
#define vtkQuadraticHexFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkQuadraticHexFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkQuadraticHexFilter* New();
  vtkTypeMacro(vtkQuadraticHexFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Nodes of a hex.
   */
  enum HexTypes
  {
    Nodes20 = 0, ///< corners and mid-edge nodes: VTK_QUADRATIC_HEXAHEDRON
    Nodes27 = 1  ///< also mid-face nodes and the middle: VTK_TRIQUADRATIC_HEXAHEDRON
  };

  ///@{
  /**
   * Nodes of a hex. Default: Nodes20.
   */
  vtkSetClampMacro(HexType, int, Nodes20, Nodes27);
  vtkGetMacro(HexType, int);
  void SetHexTypeToNodes20() { this->SetHexType(Nodes20); }
  void SetHexTypeToNodes27() { this->SetHexType(Nodes27); }
  ///@}

protected:
  vtkQuadraticHexFilter();
  ~vtkQuadraticHexFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkQuadraticHexFilter(const vtkQuadraticHexFilter&) = delete;
  void operator=(const vtkQuadraticHexFilter&) = delete;

  int HexType = Nodes20;
};

#endif
