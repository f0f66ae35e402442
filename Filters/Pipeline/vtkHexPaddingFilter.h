// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexPaddingFilter
 * @brief Keeps the hexes of the bodies and puts one layer of hexes under their boundary.
 *
 * After it, every boundary hex has exactly one quad on the boundary (at a convex crease one of each
 * side), so that it can be fitted without flattening a corner. Interface vertices stay where they
 * are and become the boundary; their inner copies move into the body.
 *
 * With features of vtkHexFeatureMappingFilter each group of patches gets its own layer; layers
 * cross at convex creases, so that one hex instead of two has the angle of the crease. A group gets
 * no layer where the hexes meet as in a grid already: two along each edge inside its patches and
 * three to five quads round each vertex there, and along its creases and at its corners as many
 * hexes and quads as right angles fit best. Flat faces along the axes of the octree are like that,
 * also between others that have layers; stairs are not. Where a quad still has two consecutive
 * edges on one curve, its corner would get a straight angle: local padding surrounds such quads
 * with a ring of hexes, and puts a second layer below them.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, hex mesh of vtkHexDomainFilter or
 * vtkHexFeatureMappingFilter. Cells: Region (0 outside, 1 and up: body), with a manifold interface.
 * Points FeatureKind, FeatureId and field data FeatureQuads, FeatureEdges (optional): its features.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, the surface (triangles, strips or polygons). Only for
 * local padding.
 *
 * <b>Input 2 (optional):</b> vtkPolyData, the feature graph that vtkHexFeatureMappingFilter had.
 * Only for local padding: without it features are carried, and a warning says so.
 *
 * <b>Output:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON: bodies only, in a space-filling order.
 * Point and cell arrays of the input are copied from the vertex or hex that each one comes from
 * (layer hexes: the hex they cover). Cells: PaddingLayer (int, 1: hex of the layer). Field data of
 * the input. With features: FeatureKind, FeatureId, FeatureQuads, FeatureEdges of the new mesh;
 * field data, one double each: DegenerateQuads (found by local padding), LocalPaddingHexes (added
 * by it).
 *
 * <b>Guarantees:</b> connectivity is valid. Some hexes may be inverted: vtkHexUntangleFilter.
 *
 * <b>Errors:</b> no array Region, no hex in a body, bodies that touch along an edge or in a point
 * (regions edited by hand), a mesh that is not conforming; a feature graph without surface;
 * features of the mesh that are not those of the graph; what vtkSurfaceFeatureFilter reports.
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
 * @sa vtkHexDomainFilter vtkHexFeatureMappingFilter vtkHexUntangleFilter
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

  ///@{
  /**
   * Layers follow the features: they cross at convex creases, which get one hex instead of two, and
   * there are more hexes where a feature would give the corner of a quad a straight angle. Needs
   * inputs 1 and 2. Default: on.
   */
  vtkSetMacro(LocalPadding, bool);
  vtkGetMacro(LocalPadding, bool);
  vtkBooleanMacro(LocalPadding, bool);
  ///@}

  ///@{
  /**
   * Layers also under patches that the hexes follow as a grid does. They make room for untangling
   * and fitting, and more hexes that are flatter. Without features, or with
   * LocalPadding off, there is one layer under the whole boundary anyway. Default: off.
   */
  vtkSetMacro(PadEveryPatch, bool);
  vtkGetMacro(PadEveryPatch, bool);
  vtkBooleanMacro(PadEveryPatch, bool);
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
  bool LocalPadding = true;
  bool PadEveryPatch = false;
};

#endif
