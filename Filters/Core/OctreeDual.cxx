// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeDual.h"

#include "Parallel.h"
#include "Tables/DualTemplates.h"

#include <algorithm>
#include <limits>
#include <string>

namespace featurehex
{
namespace
{
/// The cells of a block are numbered x + 2 y + 4 z, its faces 2 axis + side, its edges 4 axis + u +
/// 2 w, where u and w are the sides along the two axes that follow.
int FaceNeighbor(int axis, int side)
{
  constexpr int stride[3] = { 1, 3, 9 };
  return 13 + (side ? stride[axis] : -stride[axis]);
}

int EdgeId(int axis, const int sides[3])
{
  return 4 * axis + sides[(axis + 1) % 3] + 2 * sides[(axis + 2) % 3];
}

int CellId(const int sides[3])
{
  return sides[0] + 2 * sides[1] + 4 * sides[2];
}

int CountBits(unsigned bits)
{
  int count = 0;
  for (; bits; bits &= bits - 1)
  {
    ++count;
  }
  return count;
}

/// What a block owns in the dual mesh: cell centres, then split vertices of its edges,
/// then interior vertices of its faces towards finer blocks.
struct BlockPlan
{
  Index FirstVertex = 0;
  std::int64_t FirstHex = 0;
  std::uint16_t SplitEdges = 0; ///< bit: the edge has two split vertices
  std::uint8_t FineFaces = 0;   ///< bit: four finer blocks across the face
};

class DualBuilder
{
public:
  explicit DualBuilder(const BlockOctree& octree)
    : Octree(octree)
    , Locator(octree)
    , Neighbors(27 * octree.Leaves.size())
    , Plans(octree.Leaves.size())
  {
  }

  /// Neighbours, vertex and hex numbers of all blocks.
  bool Plan(Monitor& monitor)
  {
    const bool complete = this->ForAllBlocks(monitor, 0.0, 0.5,
      [this](std::size_t leaf)
      {
        std::int32_t* neighbors = &this->Neighbors[27 * leaf];
        this->Locator.FindNeighbors(leaf, neighbors);
        this->PlanBlock(leaf, neighbors);
      });
    for (std::size_t leaf = 0; leaf < this->Plans.size() && complete; ++leaf)
    {
      BlockPlan& plan = this->Plans[leaf];
      const std::int64_t hexes = plan.FirstHex;
      plan.FirstHex = this->Hexes;
      plan.FirstVertex = static_cast<Index>(this->Vertices);
      this->Hexes += hexes;
      this->Vertices += 8 + 2 * CountBits(plan.SplitEdges) + 4 * CountBits(plan.FineFaces);
    }
    return complete;
  }

  std::int64_t NumberOfHexes() const { return this->Hexes; }
  std::int64_t NumberOfVertices() const { return this->Vertices; }

  bool Fill(HexMesh& mesh, OctreeDualArrays* arrays, Monitor& monitor)
  {
    this->Mesh = &mesh;
    this->Arrays = arrays;
    mesh.Points.resize(static_cast<std::size_t>(this->Vertices));
    mesh.Hexes.resize(static_cast<std::size_t>(this->Hexes));
    if (arrays)
    {
      arrays->HexLevel.resize(mesh.Hexes.size());
      arrays->HexKind.resize(mesh.Hexes.size());
      arrays->PointOctreeIndex.resize(mesh.Points.size());
    }
    return this->ForAllBlocks(monitor, 0.5, 1.0,
      [this](std::size_t leaf)
      {
        this->FillVertices(leaf);
        this->FillHexes(leaf);
      });
  }

private:
  template <typename Body>
  bool ForAllBlocks(Monitor& monitor, double from, double to, const Body& body)
  {
    constexpr std::size_t batch = 65536;
    const std::size_t count = this->Plans.size();
    for (std::size_t begin = 0; begin < count; begin += batch)
    {
      if (!monitor.Update(from + (to - from) * static_cast<double>(begin) / count))
      {
        return false;
      }
      ParallelFor(
        std::min(batch, count - begin), 1024, [begin, &body](std::size_t n) { body(begin + n); });
    }
    return monitor.Update(to);
  }

  // ---- who is where

  /// The four columns round an edge of a block as neighbour positions; this block's own is
  /// returned.
  static int ColumnsAtEdge(int axis, int uSide, int wSide, int positions[4])
  {
    constexpr int stride[3] = { 1, 3, 9 };
    int own = 0;
    for (int q = 0; q < 4; ++q)
    {
      // The edge is on side uSide of the block: blocks on the high side of it are uSide further.
      const int du = uSide - 1 + dual::EdgeColumns[q][0];
      const int dw = wSide - 1 + dual::EdgeColumns[q][1];
      positions[q] = 13 + du * stride[(axis + 1) % 3] + dw * stride[(axis + 2) % 3];
      own = positions[q] == 13 ? q : own;
    }
    return own;
  }

  /// Coarse columns (bits) of the dual cell at an edge when this block has to make it, else 0: all
  /// four columns are of this level or finer, and this is the first coarse one.
  static unsigned OwnedEdge(const std::int32_t* neighbors, int axis, int uSide, int wSide)
  {
    int positions[4];
    const int own = ColumnsAtEdge(axis, uSide, wSide, positions);
    unsigned coarse = 0;
    for (int q = 0; q < 4; ++q)
    {
      const std::int32_t found = neighbors[positions[q]];
      if (found == BlockLocator::Outside || found <= BlockLocator::Coarser ||
          (found >= 0 && q < own))
      {
        return 0;
      }
      coarse |= found >= 0 ? 1u << q : 0u;
    }
    return coarse;
  }

  /// The upper corner of a block is that of eight blocks when no coarser one has it inside a face
  /// or an edge; each such point is the upper corner of exactly one block.
  bool HasUpperCorner(const Block& block, const std::int32_t* neighbors) const
  {
    bool even = true;
    for (int k = 0; k < 3; ++k)
    {
      even = even && (block.Index[k] + 1) % 2 == 0;
    }
    for (int q = 1; q < 8; ++q)
    {
      const std::int32_t found = neighbors[CornerPosition(q)];
      if (found == BlockLocator::Outside || (found <= BlockLocator::Coarser && !even))
      {
        return false;
      }
    }
    return true;
  }

  static int CornerPosition(int q) { return 13 + (q & 1) + 3 * (q >> 1 & 1) + 9 * (q >> 2); }

  /// Masks and number of hexes of one block.
  void PlanBlock(std::size_t leaf, const std::int32_t* neighbors)
  {
    BlockPlan& plan = this->Plans[leaf];
    int hexes = 1;
    for (int face = 0; face < 6; ++face)
    {
      const std::int32_t found = neighbors[FaceNeighbor(face / 2, face % 2)];
      if (found == BlockLocator::Finer)
      {
        plan.FineFaces |= 1u << face;
        hexes += dual::FrustumHexCount;
      }
      else if (found >= 0 && face % 2 == 1)
      {
        ++hexes;
      }
    }
    for (int edge = 0; edge < 12; ++edge)
    {
      const int axis = edge / 4;
      const int uSide = edge & 1;
      const int wSide = edge >> 1 & 1;
      if (this->IsSplit(neighbors, axis, uSide, wSide))
      {
        plan.SplitEdges |= 1u << edge;
      }
      const unsigned coarse = OwnedEdge(neighbors, axis, uSide, wSide);
      hexes += coarse ? dual::EdgeHexCount(coarse) : 0;
    }
    hexes += this->HasUpperCorner(this->Octree.Leaf(leaf), neighbors) ? 1 : 0;
    plan.FirstHex = hexes;
  }

  /// Split vertices are needed next to a frustum, and opposite a single fine column (concave).
  static bool IsSplit(const std::int32_t* neighbors, int axis, int uSide, int wSide)
  {
    const int uFace = FaceNeighbor((axis + 1) % 3, uSide);
    const int wFace = FaceNeighbor((axis + 2) % 3, wSide);
    if (neighbors[uFace] == BlockLocator::Finer || neighbors[wFace] == BlockLocator::Finer)
    {
      return true;
    }
    return neighbors[uFace] >= 0 && neighbors[wFace] >= 0 &&
           neighbors[uFace + wFace - 13] == BlockLocator::Finer;
  }

  // ---- vertex numbers

  Index CellVertex(std::size_t leaf, const int sides[3]) const
  {
    return this->Plans[leaf].FirstVertex + CellId(sides);
  }

  Index SplitVertex(std::size_t leaf, int edge, int end) const
  {
    const BlockPlan& plan = this->Plans[leaf];
    return plan.FirstVertex + 8 + 2 * CountBits(plan.SplitEdges & ((1u << edge) - 1)) + end;
  }

  Index InteriorVertex(std::size_t leaf, int face, int number) const
  {
    const BlockPlan& plan = this->Plans[leaf];
    return plan.FirstVertex + 8 + 2 * CountBits(plan.SplitEdges) +
           4 * CountBits(plan.FineFaces & ((1u << face) - 1)) + number;
  }

  /// One of the eight children of the block position @a at, of which one is known to be a leaf.
  std::size_t FineLeaf(const Block& at, const int sides[3]) const
  {
    return static_cast<std::size_t>(this->Locator.FindExact({ at.Level + 1,
      { 2 * at.Index[0] + sides[0], 2 * at.Index[1] + sides[1], 2 * at.Index[2] + sides[2] } }));
  }

  static Block NeighborBlock(const Block& block, int position)
  {
    return { block.Level,
      { block.Index[0] + position % 3 - 1, block.Index[1] + position / 3 % 3 - 1,
        block.Index[2] + position / 9 - 1 } };
  }

  /// Axes of the frame of a frustum: x, y along the face, z from the fine to the coarse side.
  struct FaceFrame
  {
    FaceFrame(int face)
      : Z(face / 2)
      , Side(face % 2)
      , X(this->Side ? (this->Z + 2) % 3 : (this->Z + 1) % 3)
      , Y(this->Side ? (this->Z + 1) % 3 : (this->Z + 2) % 3)
    {
    }
    int Z;
    int Side;
    int X;
    int Y;
  };

  // ---- positions

  void PutVertex(Index vertex, const Vec3& local, const std::array<int, 3>& cell)
  {
    this->Mesh->Points[vertex] = this->Octree.ToModel(local);
    if (this->Arrays)
    {
      this->Arrays->PointOctreeIndex[vertex] = cell;
    }
  }

  void FillVertices(std::size_t leaf)
  {
    const Block block = this->Octree.Leaf(leaf);
    const BlockPlan& plan = this->Plans[leaf];
    const int unit = 1 << (this->Octree.Depth - block.Level); // cell edge in finest cells
    const std::array<int, 3> low = { 2 * unit * block.Index[0], 2 * unit * block.Index[1],
      2 * unit * block.Index[2] };
    for (int cell = 0; cell < 8; ++cell)
    {
      const std::array<int, 3> index = { low[0] + (cell & 1) * unit,
        low[1] + (cell >> 1 & 1) * unit, low[2] + (cell >> 2) * unit };
      this->PutVertex(plan.FirstVertex + cell,
        Vec3(index[0], index[1], index[2]) + Vec3::Constant(0.5 * unit), index);
    }
    for (int edge = 0; edge < 12 && plan.SplitEdges; ++edge)
    {
      if (plan.SplitEdges >> edge & 1)
      {
        this->FillSplitVertices(leaf, edge, low, unit);
      }
    }
    for (int face = 0; face < 6 && plan.FineFaces; ++face)
    {
      if (plan.FineFaces >> face & 1)
      {
        this->FillInteriorVertices(leaf, face, low, unit);
      }
    }
  }

  void FillSplitVertices(std::size_t leaf, int edge, const std::array<int, 3>& low, int unit)
  {
    const int axis = edge / 4;
    const int u = (axis + 1) % 3;
    const int w = (axis + 2) % 3;
    int sides[3];
    sides[u] = edge & 1;
    sides[w] = edge >> 1 & 1;
    const unsigned fine = this->Plans[leaf].FineFaces;
    const bool uFine = fine >> (2 * u + sides[u]) & 1;
    const bool wFine = fine >> (2 * w + sides[w]) & 1;
    const dual::SplitPlacement& place = uFine && wFine ? dual::SplitBothFine
                                        : uFine        ? dual::SplitFirstFine
                                        : wFine        ? dual::SplitSecondFine
                                                       : dual::SplitConcave;
    const double s = 0.5 * unit;
    for (int end = 0; end < 2; ++end)
    {
      sides[axis] = end;
      Vec3 local;
      local[axis] = low[axis] + unit + (end ? s : -s) * place.Along;
      local[u] = sides[u] ? low[u] + 2 * unit - s * place.FromFirst : low[u] + s * place.FromFirst;
      local[w] =
        sides[w] ? low[w] + 2 * unit - s * place.FromSecond : low[w] + s * place.FromSecond;
      this->PutVertex(this->SplitVertex(leaf, edge, end), local,
        { low[0] + sides[0] * unit, low[1] + sides[1] * unit, low[2] + sides[2] * unit });
    }
  }

  void FillInteriorVertices(std::size_t leaf, int face, const std::array<int, 3>& low, int unit)
  {
    const FaceFrame frame(face);
    const double s = 0.5 * unit;
    for (int number = 0; number < 4; ++number)
    {
      int sides[3];
      sides[frame.X] = number & 1;
      sides[frame.Y] = number >> 1;
      sides[frame.Z] = frame.Side;
      Vec3 local;
      local[frame.X] = low[frame.X] + unit + (sides[frame.X] ? s : -s) * dual::InteriorAcross;
      local[frame.Y] = low[frame.Y] + unit + (sides[frame.Y] ? s : -s) * dual::InteriorAcross;
      local[frame.Z] = frame.Side ? low[frame.Z] + 2 * unit + s * dual::InteriorDepth
                                  : low[frame.Z] - s * dual::InteriorDepth;
      this->PutVertex(this->InteriorVertex(leaf, face, number), local,
        { low[0] + sides[0] * unit, low[1] + sides[1] * unit, low[2] + sides[2] * unit });
    }
  }

  // ---- hexes

  /// Writes the hexes of one block one after the other.
  struct HexWriter
  {
    void Add(const Hex& hex, int level, DualHexKind kind)
    {
      this->Mesh.Hexes[this->Next] = hex;
      if (this->Arrays)
      {
        this->Arrays->HexLevel[this->Next] = level;
        this->Arrays->HexKind[this->Next] = kind;
      }
      ++this->Next;
    }
    HexMesh& Mesh;
    OctreeDualArrays* Arrays;
    std::size_t Next;
  };

  void FillHexes(std::size_t leaf)
  {
    const Block block = this->Octree.Leaf(leaf);
    const std::int32_t* neighbors = &this->Neighbors[27 * leaf];
    HexWriter out{ *this->Mesh, this->Arrays,
      static_cast<std::size_t>(this->Plans[leaf].FirstHex) };
    const Index v = this->Plans[leaf].FirstVertex;
    out.Add(
      { v, v + 1, v + 3, v + 2, v + 4, v + 5, v + 7, v + 6 }, block.Level, DualHexKind::Regular);
    for (int face = 0; face < 6; ++face)
    {
      const std::int32_t found = neighbors[FaceNeighbor(face / 2, face % 2)];
      if (found == BlockLocator::Finer)
      {
        this->AddFrustum(leaf, block, face, out);
      }
      else if (found >= 0 && face % 2 == 1)
      {
        this->AddFace(leaf, static_cast<std::size_t>(found), block.Level, face / 2, out);
      }
    }
    for (int edge = 0; edge < 12; ++edge)
    {
      const unsigned coarse = OwnedEdge(neighbors, edge / 4, edge & 1, edge >> 1 & 1);
      if (coarse)
      {
        this->AddEdge(block, neighbors, edge, coarse, out);
      }
    }
    if (this->HasUpperCorner(block, neighbors))
    {
      this->AddCorner(block, neighbors, out);
    }
  }

  /// Between a block and its equal on the high side.
  void AddFace(std::size_t low, std::size_t high, int level, int axis, HexWriter& out) const
  {
    Hex hex;
    for (int n = 0; n < 4; ++n)
    {
      int sides[3];
      sides[(axis + 1) % 3] = dual::EdgeColumns[n][0];
      sides[(axis + 2) % 3] = dual::EdgeColumns[n][1];
      sides[axis] = 1;
      hex[n] = this->CellVertex(low, sides);
      sides[axis] = 0;
      hex[n + 4] = this->CellVertex(high, sides);
    }
    out.Add(hex, level, DualHexKind::Regular);
  }

  void AddFrustum(std::size_t leaf, const Block& block, int face, HexWriter& out) const
  {
    const FaceFrame frame(face);
    const Block across = NeighborBlock(block, FaceNeighbor(frame.Z, frame.Side));
    Index ids[dual::FrustumVertices];
    int sides[3];
    for (int child = 0; child < 4; ++child)
    {
      sides[frame.X] = child & 1;
      sides[frame.Y] = child >> 1;
      sides[frame.Z] = 1 - frame.Side;
      const std::size_t fine = this->FineLeaf(across, sides);
      for (int cell = 0; cell < 4; ++cell)
      {
        sides[frame.X] = cell & 1;
        sides[frame.Y] = cell >> 1;
        ids[dual::B(2 * (child & 1) + (cell & 1), 2 * (child >> 1) + (cell >> 1))] =
          this->CellVertex(fine, sides);
      }
    }
    sides[frame.Z] = frame.Side;
    for (int number = 0; number < 4; ++number)
    {
      const int i = number & 1;
      const int j = number >> 1;
      sides[frame.X] = i;
      sides[frame.Y] = j;
      ids[dual::U(3 * i, 3 * j)] = this->CellVertex(leaf, sides);
      ids[dual::U(1 + i, 1 + j)] = this->InteriorVertex(leaf, face, number);
      ids[dual::U(1 + i, 3 * j)] = this->SplitVertex(leaf, EdgeId(frame.X, sides), i);
      ids[dual::U(3 * i, 1 + j)] = this->SplitVertex(leaf, EdgeId(frame.Y, sides), j);
    }
    for (const int(&corners)[8] : dual::FrustumHexes)
    {
      Hex hex;
      for (int n = 0; n < 8; ++n)
      {
        hex[n] = ids[corners[n]];
      }
      out.Add(hex, block.Level + 1, DualHexKind::Frustum);
    }
  }

  void AddEdge(const Block& block, const std::int32_t* neighbors, int edge, unsigned coarse,
    HexWriter& out) const
  {
    const int axis = edge / 4;
    const int u = (axis + 1) % 3;
    const int w = (axis + 2) % 3;
    int positions[4];
    ColumnsAtEdge(axis, edge & 1, edge >> 1 & 1, positions);
    const bool allCoarse = coarse == 15u;
    Index columns[4][4];
    for (int q = 0; q < 4; ++q)
    {
      int sides[3]; // of the cells and edges of the column's blocks that face the edge
      sides[u] = 1 - dual::EdgeColumns[q][0];
      sides[w] = 1 - dual::EdgeColumns[q][1];
      for (int end = 0; end < 2; ++end)
      {
        sides[axis] = end;
        if (coarse >> q & 1)
        {
          const std::size_t leaf = static_cast<std::size_t>(neighbors[positions[q]]);
          columns[q][3 * end] = this->CellVertex(leaf, sides);
          if (!allCoarse)
          {
            columns[q][1 + end] = this->SplitVertex(leaf, EdgeId(axis, sides), end);
          }
        }
        else
        {
          const std::size_t leaf = this->FineLeaf(NeighborBlock(block, positions[q]), sides);
          sides[axis] = 0;
          columns[q][2 * end] = this->CellVertex(leaf, sides);
          sides[axis] = 1;
          columns[q][2 * end + 1] = this->CellVertex(leaf, sides);
        }
      }
    }
    if (allCoarse)
    {
      out.Add({ columns[0][0], columns[1][0], columns[2][0], columns[3][0], columns[0][3],
                columns[1][3], columns[2][3], columns[3][3] },
        block.Level, DualHexKind::Regular);
      return;
    }
    for (int t = 0; t < 3; ++t)
    {
      out.Add({ columns[0][t], columns[1][t], columns[2][t], columns[3][t], columns[0][t + 1],
                columns[1][t + 1], columns[2][t + 1], columns[3][t + 1] },
        block.Level + 1, DualHexKind::MixedEdge);
    }
    for (int q = 0; q < 4; ++q)
    {
      const int r = (q + 1) % 4;
      if ((coarse >> q & 1) && (coarse >> r & 1))
      {
        out.Add({ columns[q][0], columns[q][1], columns[q][2], columns[q][3], columns[r][0],
                  columns[r][1], columns[r][2], columns[r][3] },
          block.Level + 1, DualHexKind::MixedEdge);
      }
    }
  }

  void AddCorner(const Block& block, const std::int32_t* neighbors, HexWriter& out) const
  {
    Index ids[8];
    int coarsest = block.Level;
    int finest = block.Level;
    for (int q = 0; q < 8; ++q)
    {
      const int sides[3] = { 1 - (q & 1), 1 - (q >> 1 & 1), 1 - (q >> 2) };
      const int position = CornerPosition(q);
      const std::int32_t found = neighbors[position];
      if (found == BlockLocator::Finer)
      {
        ids[q] = this->CellVertex(this->FineLeaf(NeighborBlock(block, position), sides), sides);
        finest = block.Level + 1;
      }
      else
      {
        const bool equal = found >= 0;
        coarsest = equal ? coarsest : block.Level - 1;
        ids[q] = this->CellVertex(
          static_cast<std::size_t>(equal ? found : BlockLocator::Coarser - found), sides);
      }
    }
    out.Add({ ids[0], ids[1], ids[3], ids[2], ids[4], ids[5], ids[7], ids[6] }, finest,
      coarsest == finest ? DualHexKind::Regular : DualHexKind::MixedCorner);
  }

  const BlockOctree& Octree;
  BlockLocator Locator;
  std::vector<std::int32_t> Neighbors;
  std::vector<BlockPlan> Plans;
  std::int64_t Hexes = 0;
  std::int64_t Vertices = 0;
  HexMesh* Mesh = nullptr;
  OctreeDualArrays* Arrays = nullptr;
};
} // namespace

Status ConvertOctreeToHexes(
  const BlockOctree& octree, HexMesh& mesh, OctreeDualArrays* arrays, Monitor& monitor)
{
  mesh = HexMesh();
  if (arrays)
  {
    *arrays = OctreeDualArrays();
  }
  if (octree.Leaves.empty())
  {
    return Status(StatusCode::InvalidMesh, "The octree has no leaves to convert to hexes.");
  }
  DualBuilder builder(octree);
  if (!builder.Plan(monitor))
  {
    return monitor.StopStatus();
  }
  constexpr std::int64_t limit = std::numeric_limits<Index>::max();
  if (builder.NumberOfVertices() > limit || builder.NumberOfHexes() > limit)
  {
    return Status(StatusCode::CellLimit,
      "The dual of the octree has " + std::to_string(builder.NumberOfVertices()) +
        " vertices and " + std::to_string(builder.NumberOfHexes()) + " hexes, at most " +
        std::to_string(limit) + " are possible. Raise TargetEdgeLength.");
  }
  if (!builder.Fill(mesh, arrays, monitor))
  {
    mesh = HexMesh();
    if (arrays)
    {
      *arrays = OctreeDualArrays();
    }
    return monitor.StopStatus();
  }
  return Status();
}

std::int64_t CountDualHexes(const BlockOctree& octree)
{
  Monitor monitor;
  DualBuilder builder(octree);
  return builder.Plan(monitor) ? builder.NumberOfHexes() : 0;
}
} // namespace featurehex
