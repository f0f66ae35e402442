// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexPaddingFilter
 * @brief Keeps the hexes of the bodies and puts one layer of hexes under their whole boundary.
 *
 * After it, every boundary hex has exactly one quad on the boundary, so that it can be fitted
 * without flattening a corner. Interface vertices stay where they are and become the boundary;
 * their inner copies move into the body.
 *
 * <b>Input:</b> vtkUnstructuredGrid, hex mesh of vtkHexDomainFilter. Cells: Region (0 outside, 1
 * and up: body), with a manifold interface.
 *
 * <b>Output:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON: bodies only, in a space-filling order.
 * Point and cell arrays of the input are copied from the vertex or hex that each one comes from
 * (layer hexes: the hex they cover). Cells: PaddingLayer (int, 1: hex of the layer). Field data of
 * the input.
 *
 * <b>Guarantees:</b> connectivity is valid. Some hexes may be inverted: vtkHexUntangleFilter.
 *
 * <b>Errors:</b> no array Region, no hex in a body, bodies that touch along an edge or in a point
 * (regions edited by hand), a mesh that is not conforming.
 *
 * <b>Units:</b> thickness in local cell sizes.
 *
 * <b>Threads and determinism:</b> sequential.
 *
 * <b>Cost:</b> linear, 1 microsecond a hex.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkHexDomainFilter vtkHexUntangleFilter
 */

#ifndef vtkHexPaddingFilter_h
#define vtkHexPaddingFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexPaddingFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexPaddingFilter* New();
  vtkTypeMacro(vtkHexPaddingFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Of the layer, in local cell sizes. Thicker layers invert more hexes; thinner ones have less
   * room to untangle. Default: 0.1. Range: 0.01 to 0.4.
   */
  vtkSetClampMacro(Thickness, double, 0.01, 0.4);
  vtkGetMacro(Thickness, double);
  ///@}

protected:
  vtkHexPaddingFilter();
  ~vtkHexPaddingFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexPaddingFilter(const vtkHexPaddingFilter&) = delete;
  void operator=(const vtkHexPaddingFilter&) = delete;

  double Thickness = 0.1;
};

#endif
