// SPDX-License-Identifier: BSD-3-Clause
// All stages one after another: what they promise together, and what the pipeline executes.
#include "FilterChain.h"
#include "vtkFeatureHexMesher.h"

#include <algorithm>

using namespace FilterChecks;

namespace
{
void ExpectValid(vtkPolyData* surface, double edge, double euler)
{
  Chain chain(surface, edge);
  chain.Validation->Update();
  vtkDataObject* mesh = chain.Validation->GetOutput();
  EXPECT_EQ(Figure(mesh, "Valid"), 1.0);
  EXPECT_EQ(Figure(mesh, "EulerCharacteristic"), euler);
  EXPECT_GT(Figure(mesh, "MinimumScaledJacobian"), 0.3);
  EXPECT_EQ(vtkTable::SafeDownCast(chain.Validation->GetOutput(1))->GetNumberOfRows(), 1);
  EXPECT_TRUE(IsEmpty(chain.Validation->GetOutput(2)));
}
} // namespace

TEST(FilterChain, SphereIsValid)
{
  ExpectValid(Sphere(), 0.17, 2);
}

TEST(FilterChain, TorusIsValid)
{
  ExpectValid(Torus(), 0.25, 0);
}

TEST(FilterChain, OneRoundEqualsTheComposite)
{
  const auto sphere = Sphere();
  Chain chain(sphere);
  chain.Validation->Update();
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputDataObject(0, sphere);
  mesher->SetTargetEdgeLength(0.17);
  mesher->SetTolerance(0.02);
  mesher->Update();
  ASSERT_EQ(Figure(mesher->GetOutput(), "Rounds"), 1.0);
  auto* staged = vtkUnstructuredGrid::SafeDownCast(chain.Validation->GetOutput());
  auto* whole = vtkUnstructuredGrid::SafeDownCast(mesher->GetOutput());
  ASSERT_EQ(staged->GetNumberOfPoints(), whole->GetNumberOfPoints());
  ASSERT_EQ(staged->GetNumberOfCells(), whole->GetNumberOfCells());
  for (vtkIdType p = 0; p < whole->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(staged->GetPoint(p)[k], whole->GetPoint(p)[k]) << p;
    }
  }
  for (const char* name : { "Region", "Level", "ScaledJacobian" })
  {
    vtkDataArray* a = staged->GetCellData()->GetArray(name);
    vtkDataArray* b = whole->GetCellData()->GetArray(name);
    for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
    {
      ASSERT_EQ(a->GetComponent(c, 0), b->GetComponent(c, 0)) << name << " " << c;
    }
  }
}

namespace
{
void ExpectFeatures(const char* surface, double edge, double corners, double curves)
{
  FeatureChain chain(DataSurface(surface), edge);
  EXPECT_LT(chain.Refine(), 8);
  chain.Validation->Update();
  vtkDataObject* mesh = chain.Validation->GetOutput();
  EXPECT_EQ(Figure(mesh, "Valid"), 1.0)
    << mesh->GetFieldData()->GetAbstractArray("Verdict")->GetVariantValue(0).ToString();
  EXPECT_EQ(Figure(mesh, "CornersCaptured"), corners);
  EXPECT_EQ(Figure(mesh, "CurvesCaptured"), curves);
  EXPECT_EQ(Figure(mesh, "PatchesCaptured"), Figure(mesh, "PatchesEnforced"));
}
} // namespace

TEST(FilterChain, BracketKeepsItsFeatures)
{
  ExpectFeatures("rotation/bracket.obj", 0.3, 20, 30);
}

TEST(FilterChain, OneRoundWithFeaturesEqualsTheComposite)
{
  const auto bracket = DataSurface("rotation/bracket.obj");
  FeatureChain chain(bracket, 0.3);
  chain.Fitting->SetMinimumScaledJacobian(0.1);
  chain.Validation->Update();
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputDataObject(0, bracket);
  mesher->SetFeatureModeToAngle();
  mesher->SetTargetEdgeLength(0.3);
  mesher->SetTolerance(0.02);
  mesher->SetMinimumScaledJacobian(0.1);
  mesher->Update();
  ASSERT_EQ(Figure(mesher->GetOutput(), "Rounds"), 1.0);
  auto* staged = vtkUnstructuredGrid::SafeDownCast(chain.Validation->GetOutput());
  auto* whole = vtkUnstructuredGrid::SafeDownCast(mesher->GetOutput());
  ASSERT_EQ(staged->GetNumberOfPoints(), whole->GetNumberOfPoints());
  ASSERT_EQ(staged->GetNumberOfCells(), whole->GetNumberOfCells());
  double worst = 0;
  for (vtkIdType p = 0; p < whole->GetNumberOfPoints(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, std::abs(staged->GetPoint(p)[k] - whole->GetPoint(p)[k]));
    }
  }
  EXPECT_EQ(worst, 0.0);
}

TEST(FilterChain, CylinderKeepsItsFeatures)
{
  ExpectFeatures("rotation/cylinder.obj", 0.2, 0, 2);
}

TEST(FilterChain, ALateChangeDoesNotRunEarlyStages)
{
  Chain chain(Sphere());
  std::vector<std::unique_ptr<Executions>> runs;
  for (vtkAlgorithm* filter : chain.All())
  {
    runs.push_back(std::make_unique<Executions>(filter));
  }
  chain.Validation->Update();
  chain.Validation->Update();
  chain.Fitting->SetMinimumScaledJacobian(0.4);
  chain.Validation->Update();
  chain.Validation->SetTolerance(0.03);
  chain.Validation->Update();
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(runs[i]->Count, 1) << i;
  }
  EXPECT_EQ(runs[6]->Count, 2);
  EXPECT_EQ(runs[7]->Count, 3);
}

TEST(FilterChain, OneErrorForTheWholeChain)
{
  Chain chain(OpenSphere());
  std::vector<std::unique_ptr<Messages>> messages;
  for (vtkAlgorithm* filter : chain.All())
  {
    messages.push_back(std::make_unique<Messages>(filter));
  }
  chain.Validation->Update();
  EXPECT_EQ(messages[0]->Errors.size(), 1u);
  for (std::size_t i = 1; i < messages.size(); ++i)
  {
    EXPECT_TRUE(messages[i]->Errors.empty()) << i << messages[i]->Errors[0];
  }
  auto* error = vtkStringArray::SafeDownCast(
    chain.Validation->GetOutput()->GetFieldData()->GetAbstractArray("FeatureHexError"));
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->GetValue(0).find("OpenBoundary: "), 0u);
}
