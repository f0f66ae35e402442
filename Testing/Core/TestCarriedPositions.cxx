// SPDX-License-Identifier: BSD-3-Clause
#include "CarriedPositions.h"

#include "HexGrids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace hexgrids;

namespace
{
constexpr int Size = 12; // hexes a side

/// What a fit might do: smooth, and nowhere zero.
Vec3 Fitted(const Vec3& p)
{
  return p + Vec3(0.2 + 0.01 * p[1], 0.1 * std::sin(0.3 * p[0]), -0.1);
}

struct Round
{
  HexMesh Mesh = Grid(Size);
  HexStars Stars;
  FeatureLabels Labels;

  explicit Round(HexMesh mesh = Grid(Size))
    : Mesh(std::move(mesh))
    , Stars(this->Mesh)
  {
    for (Index v = 0; v < static_cast<Index>(this->Mesh.Points.size()); ++v)
    {
      this->Labels.Kind.push_back(
        this->Stars.OnBoundary(v) ? FeatureKind::Surface : FeatureKind::Interior);
      this->Labels.Id.push_back(-1);
    }
  }

  void Leave(CarriedPositions& carried) const
  {
    std::vector<Vec3> fitted;
    for (const Vec3& p : this->Mesh.Points)
    {
      fitted.push_back(Fitted(p));
    }
    carried.Remember(this->Mesh.Points, this->Labels, fitted, 1.0);
  }

  std::vector<char> Take(const CarriedPositions& carried)
  {
    return carried.Apply(this->Mesh, this->Stars, this->Labels);
  }
};

/// Greatest difference of two grid positions in any direction.
double Rings(const Vec3& a, const Vec3& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}
}

TEST(CarriedPositions, TheSameMeshIsTakenOverBitByBit)
{
  CarriedPositions carried;
  Round round;
  round.Leave(carried);
  const std::vector<Vec3> before = round.Mesh.Points;
  const std::vector<char> changed = round.Take(carried);
  ASSERT_EQ(changed.size(), before.size());
  EXPECT_EQ(std::count(changed.begin(), changed.end(), 1), 0);
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_EQ(round.Mesh.Points[v], Fitted(before[v])) << v;
  }
}

TEST(CarriedPositions, IdsMayChange)
{
  CarriedPositions carried;
  const Round first;
  first.Leave(carried);
  HexMesh renumbered = Grid(Size);
  const Index count = static_cast<Index>(renumbered.Points.size());
  for (Index v = 0; v < count; ++v)
  {
    renumbered.Points[count - 1 - v] = first.Mesh.Points[v];
  }
  for (Hex& hex : renumbered.Hexes)
  {
    std::transform(
      hex.begin(), hex.end(), hex.begin(), [count](Index v) { return count - 1 - v; });
  }
  Round second(std::move(renumbered));
  const std::vector<char> changed = second.Take(carried);
  EXPECT_EQ(std::count(changed.begin(), changed.end(), 1), 0);
  EXPECT_EQ(second.Mesh.Points[0], Fitted(first.Mesh.Points[count - 1]));
}

TEST(CarriedPositions, NewVerticesFollowAndThoseRoundThemAreMarked)
{
  CarriedPositions carried;
  Round round;
  round.Leave(carried);
  const Vec3 place(5, 6, 6);
  const auto fresh = static_cast<std::size_t>(
    std::find(round.Mesh.Points.begin(), round.Mesh.Points.end(), place) -
    round.Mesh.Points.begin());
  const std::vector<Vec3> before = round.Mesh.Points;
  round.Mesh.Points[fresh] += Vec3(0.1, 0, 0);
  const std::vector<char> changed = round.Take(carried);
  ASSERT_EQ(changed.size(), before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_EQ(changed[v], Rings(before[v], place) <= 3 ? 1 : 0) << before[v].transpose();
    EXPECT_LT((round.Mesh.Points[v] - Fitted(before[v])).norm(), v == fresh ? 0.11 : 1e-12);
  }
}

TEST(CarriedPositions, AVertexOnAnotherFeatureIsNew)
{
  CarriedPositions carried;
  Round round;
  round.Leave(carried);
  round.Labels.Kind[0] = FeatureKind::Corner;
  round.Labels.Id[0] = 0;
  const std::vector<char> changed = round.Take(carried);
  ASSERT_FALSE(changed.empty());
  EXPECT_EQ(std::count(changed.begin(), changed.end(), 1), 4 * 4 * 4);
}

TEST(CarriedPositions, AMeshWithoutMuchInCommonStaysAsItIs)
{
  CarriedPositions carried;
  Round round;
  EXPECT_TRUE(round.Take(carried).empty()) << "nothing has been remembered";
  round.Leave(carried);
  for (Vec3& p : round.Mesh.Points)
  {
    p *= 0.5;
  }
  const std::vector<Vec3> before = round.Mesh.Points;
  EXPECT_TRUE(round.Take(carried).empty());
  EXPECT_EQ(round.Mesh.Points, before);
}
