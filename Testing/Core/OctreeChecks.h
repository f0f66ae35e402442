// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Octrees made by independent, brute-force means, and the promises of the octree and of its dual.

#ifndef featurehex_OctreeChecks_h
#define featurehex_OctreeChecks_h

#include "BlockOctree.h"
#include "OctreeDual.h"
#include "SharedData.h"
#include "SurfaceReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace octreechecks
{
using namespace featurehex;

/// Path of a real scan, empty when the test data isn't there.
inline std::string ScanPath(const std::string& name)
{
  const std::string path = SharedData() / "surfaces/organic" / (name + ".obj");
  return std::filesystem::exists(path) ? path : std::string();
}

/// Sphere as a subdivided octahedron, outward oriented.
inline SurfaceMesh Sphere(const Vec3& center, double radius, int divisions)
{
  SurfaceMesh mesh;
  std::map<std::tuple<int, int, int>, Index> ids;
  const auto point = [&](int x, int y, int z)
  {
    const auto found =
      ids.emplace(std::make_tuple(x, y, z), static_cast<Index>(mesh.Points.size()));
    if (found.second)
    {
      mesh.Points.push_back(center + radius * Vec3(x, y, z).normalized());
    }
    return found.first->second;
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const int s[3] = { octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1 };
    const bool flip = s[0] * s[1] * s[2] < 0;
    const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c)
    {
      Triangle t;
      int n = 0;
      for (const auto& p : { a, b, c })
      {
        t[n++] = point(s[0] * p[0], s[1] * p[1], s[2] * (divisions - p[0] - p[1]));
      }
      if (flip)
      {
        std::swap(t[1], t[2]);
      }
      mesh.Triangles.push_back(t);
    };
    for (int i = 0; i < divisions; ++i)
    {
      for (int j = 0; i + j < divisions; ++j)
      {
        add({ i, j }, { i + 1, j }, { i, j + 1 });
        if (i + j + 1 < divisions)
        {
          add({ i + 1, j }, { i + 1, j + 1 }, { i, j + 1 });
        }
      }
    }
  }
  return mesh;
}

/// Octree as a plain set of blocks (level, x, y, z): slow, obvious.
class BlockSet
{
public:
  using Key = std::array<int, 4>;

  explicit BlockSet(int roots)
    : Roots(roots)
  {
    for (int n = 0; n < roots * roots * roots; ++n)
    {
      this->Leaves.insert({ 0, n % roots, n / roots % roots, n / roots / roots });
    }
  }

  void Split(const Key& b)
  {
    this->Leaves.erase(b);
    for (int c = 0; c < 8; ++c)
    {
      this->Leaves.insert(
        { b[0] + 1, 2 * b[1] + (c & 1), 2 * b[2] + (c >> 1 & 1), 2 * b[3] + (c >> 2) });
    }
  }

  void SplitRandom(std::mt19937& random, int maximumLevel)
  {
    const std::size_t n = random() % this->Leaves.size();
    const Key b = *std::next(this->Leaves.begin(), static_cast<std::ptrdiff_t>(n));
    if (b[0] < maximumLevel)
    {
      this->Split(b);
    }
  }

  /// Split the coarser of two closed blocks that meet and differ by two levels, until none do.
  void Balance(int depth)
  {
    const auto low = [depth](const Key& b, int k) { return b[k + 1] << (depth - b[0]); };
    const auto high = [depth](const Key& b, int k) { return (b[k + 1] + 1) << (depth - b[0]); };
    for (bool again = true; again;)
    {
      again = false;
      const std::vector<Key> leaves(this->Leaves.begin(), this->Leaves.end());
      for (const Key& a : leaves)
      {
        for (const Key& b : leaves)
        {
          bool touch = a[0] < b[0] - 1 && this->Leaves.count(a) > 0;
          for (int k = 0; k < 3 && touch; ++k)
          {
            touch = low(a, k) <= high(b, k) && low(b, k) <= high(a, k);
          }
          if (touch)
          {
            this->Split(a);
            again = true;
          }
        }
      }
    }
  }

  int Depth() const { return (*this->Leaves.rbegin())[0]; }

  OctreeCells Cells(int depth) const
  {
    OctreeCells cells;
    for (const Key& b : this->Leaves)
    {
      for (int c = 0; c < 8; ++c)
      {
        const int shift = depth - b[0];
        cells.OctreeIndex.push_back({ (2 * b[1] + (c & 1)) << shift,
          (2 * b[2] + (c >> 1 & 1)) << shift, (2 * b[3] + (c >> 2)) << shift });
        cells.Level.push_back(b[0]);
      }
    }
    return cells;
  }

  int Roots;
  std::set<Key> Leaves;
};

inline BlockOctree MakeOctree(const BlockSet& blocks)
{
  BlockOctree octree;
  octree.Depth = blocks.Depth();
  const Status status = RebuildBlockOctree(blocks.Cells(octree.Depth), octree);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return octree;
}

/// Smallest scaled Jacobian of the corners.
inline double SmallestScaledJacobian(const HexMesh& mesh)
{
  double smallest = 1e300;
  for (const Hex& hex : mesh.Hexes)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      Mat3 edges;
      for (int k = 0; k < 3; ++k)
      {
        edges.col(k) =
          (mesh.Points[hex[HexCornerNeighbors[corner][k]]] - mesh.Points[hex[corner]]).normalized();
      }
      smallest = std::min(smallest, edges.determinant());
    }
  }
  return smallest;
}

/// Interior faces exactly twice and in opposite directions; faces of one hex only between cells at
/// the same side of the root grid; every point used.
inline void ExpectConforming(
  const BlockOctree& octree, const HexMesh& mesh, const OctreeDualArrays& arrays)
{
  struct Face
  {
    std::array<Index, 4> Sorted;
    Quad Corners;
    bool operator<(const Face& other) const { return this->Sorted < other.Sorted; }
  };
  std::vector<Face> faces;
  std::vector<char> used(mesh.Points.size(), 0);
  for (const Hex& hex : mesh.Hexes)
  {
    for (const auto& f : HexFaces)
    {
      const Quad q = { hex[f[0]], hex[f[1]], hex[f[2]], hex[f[3]] };
      Face face = { q, q };
      std::sort(face.Sorted.begin(), face.Sorted.end());
      ASSERT_TRUE(std::adjacent_find(face.Sorted.begin(), face.Sorted.end()) == face.Sorted.end());
      faces.push_back(face);
    }
    for (Index v : hex)
    {
      used[v] = 1;
    }
  }
  ASSERT_EQ(std::count(used.begin(), used.end(), 0), 0);
  std::sort(faces.begin(), faces.end());

  const auto bordersOf = [&](Index v)
  {
    const std::array<int, 3>& index = arrays.PointOctreeIndex[v];
    const Vec3 center = octree.ToModel(Vec3(index[0], index[1], index[2]) + Vec3::Constant(0.5));
    const int level = octree.Leaf(octree.LeafAt(center)).Level;
    unsigned sides = 0;
    for (int k = 0; k < 3; ++k)
    {
      sides |= index[k] == 0 ? 1u << 2 * k : 0u;
      sides |= index[k] + (1 << (octree.Depth - level)) == 2 * octree.RootBlocks[k] << octree.Depth
                 ? 2u << 2 * k
                 : 0u;
    }
    return sides;
  };
  for (std::size_t begin = 0; begin < faces.size();)
  {
    std::size_t end = begin + 1;
    while (end < faces.size() && faces[end].Sorted == faces[begin].Sorted)
    {
      ++end;
    }
    const Quad& a = faces[begin].Corners;
    ASSERT_LE(end - begin, 2u);
    if (end - begin == 1)
    {
      ASSERT_NE(bordersOf(a[0]) & bordersOf(a[1]) & bordersOf(a[2]) & bordersOf(a[3]), 0u)
        << "a crack at " << mesh.Points[a[0]].transpose();
    }
    else
    {
      // Opposite directions: the second reads a[0], a[3], a[2], a[1] from a[0] on.
      const Quad& b = faces[begin + 1].Corners;
      const int at = static_cast<int>(std::find(b.begin(), b.end(), a[0]) - b.begin());
      for (int n = 0; n < 4; ++n)
      {
        ASSERT_EQ(b[(at + n) % 4], a[(4 - n) % 4]);
      }
    }
    begin = end;
  }
}
} // namespace octreechecks

#endif
