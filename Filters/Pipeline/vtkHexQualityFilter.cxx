// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexQualityFilter.h"

#include "ArrayNames.h"
#include "CertifiedDistance.h"
#include "DataConversion.h"
#include "HexQuality.h"
#include "MeshTopology.h"
#include "QualityHistogram.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkHexQualityFilter);

namespace
{
using namespace featurehex;

void AddColumn(vtkTable* table, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  column->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), column->GetPointer(0));
  table->AddColumn(column);
}

void TableFromHistogram(const ValueHistogram& histogram, const char* counted, vtkTable* table)
{
  AddColumn(table, ArrayNames::BinMiddles, histogram.Middles);
  AddColumn(table, counted, histogram.Counts);
}
} // namespace

//------------------------------------------------------------------------------
vtkHexQualityFilter::vtkHexQualityFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
vtkHexQualityFilter::~vtkHexQualityFilter() = default;

//------------------------------------------------------------------------------
int vtkHexQualityFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexQualityFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkTable", "vtkTable", "vtkUnstructuredGrid", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexQualityFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  this->SmallestScaledJacobian = this->MeanScaledJacobian = this->LargestDeviation = 0.0;
  monitor.BeginPhase("measuring the hexes", 0.0, 0.2);
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkPolyData* surfaceData = vtkPolyData::GetData(inputs[1]);
  HexMesh mesh;
  Status status = MeshFromGrid(input, surfaceData ? MeshCheck::Conforming : MeshCheck::Ids, mesh);
  SurfaceMesh surface;
  if (status.Ok() && surfaceData)
  {
    status = CheckedSurface(surfaceData, surface, monitor);
  }
  if (!status.Ok())
  {
    return status;
  }
  const std::vector<double> quality = ScaledJacobians(mesh);
  const QualityStatistics statistics = SummarizeQuality(quality);
  this->SmallestScaledJacobian = statistics.Minimum;
  this->MeanScaledJacobian = statistics.Mean;
  TableFromHistogram(MakeHistogram(quality, this->NumberOfBins, -1.0, 1.0), ArrayNames::Hexes,
    vtkTable::GetData(outputs, 0));

  const std::vector<Index> worst = SmallestValues(quality, this->NumberOfWorstHexes);
  std::vector<double> qualityOfWorst;
  for (Index hex : worst)
  {
    qualityOfWorst.push_back(quality[hex]);
  }
  vtkUnstructuredGrid* worstHexes = vtkUnstructuredGrid::GetData(outputs, 2);
  GridFromHexes(mesh, worst, input, worstHexes);
  AddArray(worstHexes->GetCellData(), ArrayNames::ScaledJacobian, qualityOfWorst);
  AddArray(worstHexes->GetCellData(), ArrayNames::OriginalCellId, worst);
  worstHexes->GetCellData()->SetActiveScalars(ArrayNames::ScaledJacobian);

  if (surfaceData)
  {
    this->MeasureDeviation(mesh, surface, outputs, monitor);
  }
  return monitor.StopStatus();
}

//------------------------------------------------------------------------------
void vtkHexQualityFilter::MeasureDeviation(const featurehex::HexMesh& mesh,
  const featurehex::SurfaceMesh& surface, vtkInformationVector* outputs,
  featurehex::Monitor& monitor)
{
  monitor.BeginPhase("measuring the deviation", 0.2, 1.0);
  const std::vector<Quad> quads = ExtractBoundary(mesh).Quads;
  const CertifiedDistance distance(surface);
  const double tolerance = this->Tolerance * distance.Diagonal();
  const std::vector<double> deviation =
    distance.Measure(mesh.Points, quads, tolerance, monitor).DeviationFound;
  std::vector<double> ofTolerance;
  ofTolerance.reserve(deviation.size());
  for (double length : deviation)
  {
    ofTolerance.push_back(length / tolerance);
    this->LargestDeviation = std::max(this->LargestDeviation, ofTolerance.back());
  }
  TableFromHistogram(MakeHistogram(ofTolerance, this->NumberOfBins, 0.0, 2.0), ArrayNames::Quads,
    vtkTable::GetData(outputs, 1));
  vtkPolyData* boundary = vtkPolyData::GetData(outputs, 3);
  PolyDataFromQuads(mesh.Points, quads, boundary);
  AddArray(boundary->GetCellData(), ArrayNames::Deviation, deviation);
  AddArray(boundary->GetCellData(), ArrayNames::DeviationOfTolerance, ofTolerance);
  boundary->GetCellData()->SetActiveScalars(ArrayNames::DeviationOfTolerance);
}

//------------------------------------------------------------------------------
void vtkHexQualityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "NumberOfWorstHexes: " << this->NumberOfWorstHexes << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "SmallestScaledJacobian: " << this->SmallestScaledJacobian << "\n";
  os << indent << "MeanScaledJacobian: " << this->MeanScaledJacobian << "\n";
  os << indent << "LargestDeviation: " << this->LargestDeviation << "\n";
}
