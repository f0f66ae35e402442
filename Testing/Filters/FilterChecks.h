// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of all filters share: inputs, counted errors, and assertions that hold for each
/// filter.

#ifndef FilterChecks_h
#define FilterChecks_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace FilterChecks
{
//--- inputs ---------------------------------------------------------------------------------------
/// Radius 0.5, closed.
inline vtkSmartPointer<vtkPolyData> Sphere(double x = 0.0, int resolution = 24)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetCenter(x, 0, 0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// Around z, radii 1 and @a tube, quads.
inline vtkSmartPointer<vtkPolyData> Torus(double tube = 0.4, int n = 48, int m = 24)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  const double pi = std::acos(-1.0);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m;
      const double r = 1 + tube * std::cos(v);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
      const vtkIdType i1 = (i + 1) % n, j1 = (j + 1) % m;
      const vtkIdType quad[] = { i * m + j, i1 * m + j, i1 * m + j1, i * m + j1 };
      quads->InsertNextCell(4, quad);
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(quads);
  return surface;
}

/// A sphere with one triangle missing.
inline vtkSmartPointer<vtkPolyData> OpenSphere()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(Sphere());
  surface->BuildCells();
  surface->DeleteCell(10);
  surface->RemoveDeletedCells();
  return surface;
}

/// The first point is NaN.
template <typename DataSet>
vtkSmartPointer<DataSet> WithNaN(DataSet* input)
{
  auto copy = vtkSmartPointer<DataSet>::New();
  copy->DeepCopy(input);
  copy->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  return copy;
}

//--- events ---------------------------------------------------------------------------------------
/// Counts the errors and warnings that a user of @a algorithm would see, and keeps them off the
/// console.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto* messages = static_cast<Messages*>(self);
        (event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings)
          .emplace_back(static_cast<const char*>(text));
      });
    for (vtkObject* object :
      { static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive()) })
    {
      object->AddObserver(vtkCommand::ErrorEvent, this->Command);
      object->AddObserver(vtkCommand::WarningEvent, this->Command);
    }
  }
  ~Messages()
  {
    this->Algorithm->RemoveObserver(this->Command);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Command);
  }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> Command;
};

/// Counts how often an algorithm starts.
class Executions
{
public:
  explicit Executions(vtkAlgorithm* algorithm)
  {
    this->Command->SetClientData(&this->Count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    algorithm->AddObserver(vtkCommand::StartEvent, this->Command);
  }
  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
};

//--- comparing data -------------------------------------------------------------------------------
inline std::vector<std::string> ArrayList(vtkFieldData* data)
{
  std::vector<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(data->GetArrayName(i) ? data->GetArrayName(i) : "");
  }
  return names;
}

inline void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(ArrayList(a), ArrayList(b));
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* x = a->GetAbstractArray(i);
    vtkAbstractArray* y = b->GetAbstractArray(i);
    ASSERT_EQ(x->GetNumberOfValues(), y->GetNumberOfValues()) << x->GetName();
    for (vtkIdType v = 0; v < x->GetNumberOfValues(); ++v)
    {
      ASSERT_TRUE(x->GetVariantValue(v) == y->GetVariantValue(v)) << x->GetName() << " " << v;
    }
  }
}

/// The same bits: points, cells, point and cell arrays. (Field data hold timings.)
inline void ExpectSameData(vtkDataObject* first, vtkDataObject* second)
{
  auto* a = vtkPointSet::SafeDownCast(first);
  auto* b = vtkPointSet::SafeDownCast(second);
  ASSERT_EQ(a == nullptr, b == nullptr);
  if (!a)
  {
    return;
  }
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
  {
    double x[3], y[3];
    a->GetPoint(p, x);
    b->GetPoint(p, y);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(x[k], y[k]) << "point " << p;
    }
  }
  vtkNew<vtkIdList> s, t;
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(a->GetCellType(c), b->GetCellType(c));
    a->GetCellPoints(c, s);
    b->GetCellPoints(c, t);
    ASSERT_EQ(s->GetNumberOfIds(), t->GetNumberOfIds());
    for (vtkIdType i = 0; i < s->GetNumberOfIds(); ++i)
    {
      ASSERT_EQ(s->GetId(i), t->GetId(i)) << "cell " << c;
    }
  }
  ExpectSameArrays(a->GetPointData(), b->GetPointData());
  ExpectSameArrays(a->GetCellData(), b->GetCellData());
}

inline bool IsEmpty(vtkDataObject* data)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    return set->GetNumberOfPoints() == 0 && set->GetNumberOfCells() == 0;
  }
  auto* table = vtkTable::SafeDownCast(data);
  return table && table->GetNumberOfRows() == 0;
}

inline double Figure(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(0, 0) : std::nan("");
}

inline vtkSmartPointer<vtkDataObject> CopyOf(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

//--- what holds for each filter -------------------------------------------------------------------
/// Exactly one error, which contains @a text; all outputs exist and are empty.
inline void ExpectOneError(vtkAlgorithm* filter, const std::string& text)
{
  Messages messages(filter);
  filter->Update();
  ASSERT_EQ(messages.Errors.size(), 1u) << (messages.Errors.empty() ? "" : messages.Errors.back());
  EXPECT_NE(messages.Errors[0].find(text), std::string::npos) << messages.Errors[0];
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    ASSERT_NE(filter->GetOutputDataObject(port), nullptr);
    EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(port))) << "port " << port;
  }
}

/// The error of the filter itself: with a code, and marked in the output.
inline void ExpectFailure(vtkAlgorithm* filter, const std::string& text)
{
  ExpectOneError(filter, text);
  EXPECT_GE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_NE(
    filter->GetOutputDataObject(0)->GetFieldData()->GetAbstractArray("FeatureHexError"), nullptr);
}

/// Wrong type and nothing at all at a port.
inline void ExpectTypeErrors(vtkAlgorithm* filter, int port = 0)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  filter->SetInputDataObject(port, image);
  ExpectOneError(filter, "is of type vtkImageData");
  filter->SetInputDataObject(port, nullptr);
  ExpectOneError(filter, "connections but is not optional");
}

/// Nothing runs twice, the input stays as it is, another number of threads gives the same bits,
/// pieces beyond the first are empty, and an abort at the first progress event leaves nothing. The
/// filter must have its input and give something.
inline void ExpectGoodCitizen(vtkAlgorithm* filter)
{
  std::vector<vtkSmartPointer<vtkDataObject>> before, inputs;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      filter->GetInputAlgorithm(port, i)->Update();
      inputs.emplace_back(filter->GetInputDataObject(port, i));
      before.push_back(CopyOf(inputs.back()));
    }
  }
  Messages messages(filter);
  Executions runs(filter);
  std::pair<double, bool> progress(0.0, false); // the last one, went back
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&progress);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto& [last, back] = *static_cast<std::pair<double, bool>*>(data);
      const double now = static_cast<vtkAlgorithm*>(caller)->GetProgress();
      back = back || now < last;
      last = now;
    });
  const unsigned long watching = filter->AddObserver(vtkCommand::ProgressEvent, watch);
  std::vector<vtkSmartPointer<vtkDataObject>> first;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "STDThread", false }, [&] { filter->Update(); });
  ASSERT_TRUE(messages.Errors.empty()) << messages.Errors[0];
  filter->RemoveObserver(watching);
  EXPECT_FALSE(progress.second) << "progress goes back";
  EXPECT_EQ(progress.first, 1.0);
  ASSERT_FALSE(IsEmpty(filter->GetOutputDataObject(0)));
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    first.push_back(CopyOf(filter->GetOutputDataObject(port)));
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    ExpectSameData(inputs[i], before[i]);
    ExpectSameArrays(inputs[i]->GetFieldData(), before[i]->GetFieldData());
  }
  filter->Update();
  EXPECT_EQ(runs.Count, 1) << "unchanged input";

  filter->Modified();
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, "STDThread", false }, [&] { filter->Update(); });
  EXPECT_EQ(runs.Count, 2);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    ExpectSameData(first[port], filter->GetOutputDataObject(port));
  }

  filter->Modified();
  filter->UpdatePiece(1, 2, 0);
  EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(0))) << "second of two pieces";
  filter->UpdatePiece(0, 2, 0);
  ExpectSameData(first[0], filter->GetOutputDataObject(0));

  filter->Modified();
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      EXPECT_NE(algorithm->GetProgressText(), nullptr);
      algorithm->SetAbortExecute(1);
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->UpdatePiece(0, 1, 0);
  filter->RemoveObserver(tag);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(port))) << "after abort";
  }
  EXPECT_TRUE(messages.Errors.empty()) << messages.Errors[0];
  EXPECT_TRUE(messages.Warnings.empty()) << messages.Warnings[0];
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  ExpectSameData(first[0], filter->GetOutputDataObject(0));
}
} // namespace FilterChecks

#endif
