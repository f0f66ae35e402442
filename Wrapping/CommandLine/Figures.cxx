// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include <vtkDataArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cstdio>

namespace featurehex
{
namespace
{
std::string Count(vtkTable* table, const char* name)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", FigureOf(table, name));
  return text;
}

std::string Decimal(vtkTable* table, const char* name, double factor = 1.0)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", factor * FigureOf(table, name));
  return text;
}

std::string Row(vtkTable* table, const char* promise, const char* name, const std::string& detail)
{
  std::string row = promise;
  row.resize(31, ' ');
  row += FigureOf(table, name) != 0.0 ? "yes  " : "NO   ";
  return row + detail + "\n";
}
/// "8 of 8 corners, 12 of 12 curves, 6 of 6 patches"
std::string FeatureCounts(vtkTable* table)
{
  std::string text;
  for (const char* kind : { "Corners", "Curves", "Patches" })
  {
    const std::string name = kind;
    text += (text.empty() ? "" : ", ") + Count(table, (name + "Captured").c_str()) + " of " +
            Count(table, (name + "Enforced").c_str()) + " " +
            static_cast<char>(name[0] - 'A' + 'a') + name.substr(1);
  }
  return text;
}
} // namespace

std::vector<std::pair<std::string, double>> FiguresOf(vtkTable* table)
{
  std::vector<std::pair<std::string, double>> figures;
  for (vtkIdType i = 0; table->GetNumberOfRows() > 0 && i < table->GetNumberOfColumns(); ++i)
  {
    if (auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i)))
    {
      figures.emplace_back(column->GetName(), column->GetComponent(0, 0));
    }
  }
  return figures;
}

double FigureOf(vtkTable* table, const char* name)
{
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  return column && column->GetNumberOfTuples() > 0 ? column->GetComponent(0, 0) : 0.0;
}

std::string TextOf(vtkTable* table, const char* name)
{
  auto* column = vtkStringArray::SafeDownCast(table->GetColumnByName(name));
  return column && column->GetNumberOfValues() > 0 ? std::string(column->GetValue(0))
                                                   : std::string();
}

std::string PromiseTable(vtkTable* f)
{
  std::string text = Count(f, "NumberOfHexes") + " hexes, " + Count(f, "NumberOfPoints") +
                     " points, " + Count(f, "NumberOfBoundaryQuads") + " boundary quads, volume " +
                     Decimal(f, "Volume") + "\n\n";
  text += Row(f, "all hexes, conforming", "PureConforming",
    Count(f, "OverusedFaces") + " overused and " + Count(f, "TwistedFaces") + " twisted faces, " +
      Count(f, "DuplicatePoints") + " duplicate points");
  text += Row(f, "every corner positive", "PositiveCorners",
    "scaled Jacobian: min " + Decimal(f, "MinimumScaledJacobian") + ", mean " +
      Decimal(f, "MeanScaledJacobian"));
  text += Row(f, "valid in the whole element", "CertifiedPositive",
    Count(f, "CertifiedValidHexes") + " proven, " + Count(f, "CertifiedInvalidHexes") +
      " refuted, " + Count(f, "UndecidedHexes") + " undecided");
  text += Row(f, "boundary is a closed manifold", "Manifold",
    Count(f, "OpenEdges") + " open and " + Count(f, "NonManifoldEdges") + " non-manifold edges, " +
      Count(f, "NonManifoldVertices") + " non-manifold vertices");
  text += Row(f, "boundary doesn't meet itself", "FreeOfSelfIntersections",
    Count(f, "SelfIntersections") + " intersections");
  if (f->GetColumnByName("WithinTolerance"))
  {
    text += Row(f, "topology of the surface", "TopologyMatches",
      Count(f, "Bodies") + " bodies, " + Count(f, "Cavities") + " cavities, Euler characteristic " +
        Count(f, "EulerCharacteristic"));
    text += Row(f, "within the tolerance", "WithinTolerance",
      "Hausdorff distance " + Decimal(f, "HausdorffLower", 100) + " to " +
        Decimal(f, "HausdorffUpper", 100) + " % of the diagonal, allowed " +
        Decimal(f, "Tolerance", 100) + " %");
    text += Row(f, "volume of the surface", "VolumeFits", "as far as the distance allows");
  }
  if (f->GetColumnByName("FeaturesCaptured"))
  {
    text += Row(f, "sharp features one to one", "FeaturesCaptured",
      FeatureCounts(f) + "; points off by " + Decimal(f, "CornerDeviationMaximum") + " and " +
        Decimal(f, "CurveVertexDeviationMaximum") + " of the diagonal");
  }
  return text;
}

std::string SummaryLine(vtkTable* f)
{
  return Count(f, "NumberOfHexes") +
         " hexes, scaled Jacobian >= " + Decimal(f, "MinimumScaledJacobian") + " (mean " +
         Decimal(f, "MeanScaledJacobian") +
         "), Hausdorff distance <= " + Decimal(f, "HausdorffUpper", 100) + " % of the diagonal" +
         (f->GetColumnByName("FeaturesCaptured") ? ", features: " + FeatureCounts(f) : "");
}
} // namespace featurehex
