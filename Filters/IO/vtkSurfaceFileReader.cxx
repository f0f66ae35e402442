// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFileReader.h"

#include "FileAccess.h"
#include "GuardedVTKFiles.h"
#include "SurfaceReader.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkSurfaceFileReader);

namespace
{
bool IsVTKFile(const std::string& path)
{
  const std::string extension = featurehex::FileExtension(path);
  return extension == ".vtp" || extension == ".vtk";
}

void ToPolyData(const featurehex::SurfaceMesh& surface, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.Points.size()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(static_cast<vtkIdType>(3 * surface.Triangles.size()));
  vtkIdType* id = ids->GetPointer(0);
  for (const featurehex::Triangle& t : surface.Triangles)
  {
    id = std::copy(t.begin(), t.end(), id);
  }
  vtkNew<vtkCellArray> polys;
  polys->SetData(3, ids);
  output->SetPoints(points);
  output->SetPolys(polys);
}

featurehex::Status ReadVTKSurface(const std::string& path, vtkPolyData* output)
{
  featurehex::Status status = featurehex::ReadVTKFile(path, output);
  if (status.Ok() && output->GetNumberOfPolys() + output->GetNumberOfStrips() == 0)
  {
    status = featurehex::Status(featurehex::StatusCode::EmptySurface,
      featurehex::FileBaseName(path) + ": the file has no polygons, triangles or strips.");
  }
  return status;
}

featurehex::Status ReadInto(const char* fileName, vtkPolyData* output)
{
  if (IsVTKFile(fileName))
  {
    return ReadVTKSurface(fileName, output);
  }
  featurehex::SurfaceMesh surface;
  featurehex::Status status = featurehex::ReadSurface(fileName, surface);
  if (status.Ok())
  {
    ToPolyData(surface, output);
  }
  return status;
}
} // namespace

vtkSurfaceFileReader::vtkSurfaceFileReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkSurfaceFileReader::~vtkSurfaceFileReader()
{
  this->SetFileName(nullptr);
}

int vtkSurfaceFileReader::CanReadFile(const char* name)
{
  std::string head;
  if (!name || !featurehex::ReadFileHead(name, head))
  {
    return 0;
  }
  return IsVTKFile(name) ||
         featurehex::DetectSurfaceFormat(name, head) != featurehex::SurfaceFormat::Unknown;
}

int vtkSurfaceFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const featurehex::Status status =
    featurehex::Guarded(this->FileName, [&] { return ReadInto(this->FileName, output); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    output->Initialize();
    vtkErrorMacro(<< status.Message);
    return 0;
  }
  return 1;
}

void vtkSurfaceFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
