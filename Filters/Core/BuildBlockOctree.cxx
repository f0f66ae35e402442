// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOctree.h"

#include "BlockTree.h"
#include "GridFit.h"
#include "MessageText.h"
#include "TriangleBoxOverlap.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace featurehex
{
namespace
{
/// Hexes of the dual for each octree cell: 1.14 to 1.31 on scans at 26 to 200 cells a side.
constexpr double HexesPerCell = 1.25;

/// Root grid and local coordinates counted in target edge lengths, in which every block
/// has its corners at exact multiples of its size.
struct RootFrame
{
  Vec3 Origin = Vec3::Zero();
  Mat3 Axes = Mat3::Identity();
  double Unit = 1.0;
  int BaseLevel = 0;
  double Count[3] = { 0, 0, 0 }; ///< root blocks along each axis; may be beyond any integer

  double BlockSize(int level) const { return 2 * std::ldexp(1.0, this->BaseLevel - level); }
  Vec3 ToLocal(const Vec3& p) const
  {
    return this->Axes.transpose() * (p - this->Origin) / this->Unit;
  }
  double Blocks() const { return this->Count[0] * this->Count[1] * this->Count[2]; }
};

/// Box of the surface in the frame @a axes around the model's origin.
Box BoxAlong(const SurfaceMesh& surface, const Mat3& axes)
{
  Box box;
  for (const Triangle& t : surface.Triangles)
  {
    for (Index v : t)
    {
      box.Extend(axes.transpose() * surface.Points[v]);
    }
  }
  return box;
}

/// Principal axes of the surface as a homogeneous shell, right-handed. The integral of x x^T over a
/// triangle of area A is A/12 (sum v v^T + (sum v)(sum v)^T).
Mat3 PrincipalAxes(const SurfaceMesh& surface, const Vec3& center)
{
  double area = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const Triangle& t : surface.Triangles)
  {
    const Vec3 v[3] = { surface.Points[t[0]] - center, surface.Points[t[1]] - center,
      surface.Points[t[2]] - center };
    const double a = 0.5 * (v[1] - v[0]).cross(v[2] - v[0]).norm();
    const Vec3 sum = v[0] + v[1] + v[2];
    area += a;
    first += a / 3 * sum;
    second += a / 12 * (sum * sum.transpose());
    for (const Vec3& p : v)
    {
      second += a / 12 * (p * p.transpose());
    }
  }
  if (!(area > 0))
  {
    return Mat3::Identity();
  }
  const Mat3 covariance = second / area - (first / area) * (first / area).transpose();
  Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
  Mat3 axes;
  for (int k = 0; k < 3; ++k)
  {
    Vec3 axis = solver.eigenvectors().col(2 - k);
    int largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    axes.col(k) = axis[largest] < 0 ? Vec3(-axis) : axis;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Status CheckInput(const SurfaceMesh& surface, const std::vector<RefinementPoint>& points,
  const OctreeOptions& options)
{
  if (!(options.TargetEdgeLength > 0) || !std::isfinite(options.TargetEdgeLength))
  {
    return Status(
      StatusCode::InvalidOption, "TargetEdgeLength is " + NumberText(options.TargetEdgeLength) +
                                   "; the octree needs a positive length in model units.");
  }
  if (options.MaximumLevel < 0 || options.MaximumLevel > 12 || options.CoarseLevels < 0 ||
      options.CoarseLevels > 12 || options.MarginCells < 2 || options.MaximumNumberOfCells < 1 ||
      options.MaximumNumberOfCells > 1000000000)
  {
    return Status(StatusCode::InvalidOption,
      "Octree options out of range: MaximumLevel " + std::to_string(options.MaximumLevel) +
        " (0 to 12), CoarseLevels " + std::to_string(options.CoarseLevels) +
        " (0 to 12), MarginCells " + std::to_string(options.MarginCells) +
        " (at least 2), MaximumNumberOfCells " + std::to_string(options.MaximumNumberOfCells) +
        " (1 to 10^9).");
  }
  if (surface.Triangles.empty())
  {
    return Status(
      StatusCode::EmptySurface, "The surface has no triangles to build an octree from.");
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (Index v : surface.Triangles[t])
    {
      if (v < 0 || static_cast<std::size_t>(v) >= surface.Points.size())
      {
        return Status(StatusCode::IndexOutOfRange,
          "Triangle " + std::to_string(t) + " refers to point " + std::to_string(v) + " of " +
            std::to_string(surface.Points.size()) + ".");
      }
      if (!surface.Points[v].allFinite())
      {
        return Status(StatusCode::NonFinite,
          "Point " + std::to_string(v) + " of the surface has a coordinate that isn't finite.");
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!points[i].Position.allFinite())
    {
      return Status(StatusCode::NonFinite,
        "Refinement point " + std::to_string(i) + " has a coordinate that isn't finite.");
    }
  }
  return Status();
}

RootFrame MakeRootFrame(const SurfaceMesh& surface, const OctreeOptions& options)
{
  RootFrame frame;
  frame.Unit = options.TargetEdgeLength;
  frame.BaseLevel = options.CoarseLevels;
  frame.Axes = GridAxes(surface, options.AlignToPrincipalAxes);
  const Box box = BoxAlong(surface, frame.Axes);
  const double root = frame.BlockSize(0) * frame.Unit;
  const double margin = options.MarginCells * frame.Unit;
  const GridFit fit(surface, frame.Axes);
  Vec3 middle = box.Center();
  Vec3 size;
  for (int k = 0; k < 3; ++k)
  {
    // Planes of cell centres through the flat faces: at most half a cell from the middle.
    const double centers = middle[k] + 0.5 * frame.Unit;
    const double shift = !options.FitToFlatFaces
      ? 0.0
      : std::remainder(fit.CenterPlane(k, frame.Unit, centers) - centers, frame.Unit);
    middle[k] += shift;
    const double length = box.Size()[k] + 2 * (margin + std::abs(shift));
    frame.Count[k] = std::max(1.0, std::ceil(length / root));
    size[k] = frame.Count[k] * root;
  }
  frame.Origin = frame.Axes * (middle - 0.5 * size);
  return frame;
}

/// Level of a refinement point, counted from the root.
int AbsoluteLevel(const RefinementPoint& point, const OctreeOptions& options)
{
  return std::max(0, options.CoarseLevels + std::min(point.Level, options.MaximumLevel));
}

OctreePrediction PredictInFrame(const SurfaceMesh& surface,
  const std::vector<RefinementPoint>& points, const OctreeOptions& options, const RootFrame& frame)
{
  double projected = 0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vec3 a = surface.Points[t[0]];
    const Vec3 normal = (surface.Points[t[1]] - a).cross(surface.Points[t[2]] - a) / 2;
    projected += (frame.Axes.transpose() * normal).cwiseAbs().sum();
  }
  projected /= frame.Unit * frame.Unit;
  double leaves = frame.Blocks();
  for (int level = frame.BaseLevel - 1; level >= 0; --level)
  {
    // Balance splits a coarser block when the surface meets a box around it: 2, 2.5, 2.75 ...
    // times its size (each level adds half a block to what the level below needs).
    const double size = frame.BlockSize(level);
    const double reach = 3 - std::ldexp(2.0, level - (frame.BaseLevel - 1));
    leaves +=
      7 * std::min(reach * projected / (size * size) + 1, frame.Blocks() * std::pow(8.0, level));
  }
  for (const RefinementPoint& point : points)
  {
    leaves += 7.0 * 8.0 * std::max(0, AbsoluteLevel(point, options) - frame.BaseLevel);
  }
  constexpr double limit = 9e18;
  OctreePrediction prediction;
  prediction.Cells = static_cast<std::int64_t>(std::min(limit, 8 * leaves));
  prediction.Hexes = static_cast<std::int64_t>(std::min(limit, HexesPerCell * 8 * leaves));
  return prediction;
}

Status CellLimitStatus(const OctreePrediction& prediction, const OctreeOptions& options)
{
  return Status(StatusCode::CellLimit,
    "The octree needs about " +
      std::to_string(std::max(prediction.Cells, options.MaximumNumberOfCells + 1)) +
      " cells, more than MaximumNumberOfCells = " + std::to_string(options.MaximumNumberOfCells) +
      ". Raise TargetEdgeLength (now " + NumberText(options.TargetEdgeLength) +
      ") or MaximumNumberOfCells, or ask for less refinement.");
}

/// Splits the blocks that meet the surface, top down with lists of the triangles in each block.
class SurfaceSplitter
{
public:
  SurfaceSplitter(const SurfaceMesh& surface, const RootFrame& frame, BlockTree& tree)
    : Triangles(surface.Triangles)
    , Frame(frame)
    , Tree(tree)
  {
    this->Points.reserve(surface.Points.size());
    for (const Vec3& p : surface.Points)
    {
      this->Points.push_back(frame.ToLocal(p));
    }
  }

  /// False beyond the cell limit or when stopped.
  bool Run(const BlockIndex& roots, Monitor& monitor)
  {
    std::vector<std::pair<BlockIndex, Index>> pairs; // root block (z first), triangle
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      this->DistributeToRoots(static_cast<Index>(t), roots, pairs);
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t begin = 0; begin < pairs.size();)
    {
      if (!monitor.Update(0.1 + 0.6 * static_cast<double>(begin) / pairs.size()))
      {
        return false;
      }
      this->List.clear();
      const BlockIndex key = pairs[begin].first;
      for (; begin < pairs.size() && pairs[begin].first == key; ++begin)
      {
        this->List.push_back(pairs[begin].second);
      }
      const BlockIndex root = { key[2], key[1], key[0] };
      if (!this->Split(this->Tree.Root(root), 0, root, 0))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool Meets(Index triangle, int level, const BlockIndex& block) const
  {
    const double size = this->Frame.BlockSize(level);
    const Triangle& t = this->Triangles[triangle];
    const Vec3 center((block[0] + 0.5) * size, (block[1] + 0.5) * size, (block[2] + 0.5) * size);
    return TriangleBoxOverlap(
      center, Vec3::Constant(size / 2), this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
  }

  void DistributeToRoots(
    Index triangle, const BlockIndex& roots, std::vector<std::pair<BlockIndex, Index>>& pairs) const
  {
    const Triangle& t = this->Triangles[triangle];
    const double size = this->Frame.BlockSize(0);
    int low[3];
    int high[3];
    for (int k = 0; k < 3; ++k)
    {
      const double x[3] = { this->Points[t[0]][k], this->Points[t[1]][k], this->Points[t[2]][k] };
      // One block more on each side when the triangle may touch the border between two.
      const double slack = 1e-9;
      low[k] = std::clamp(
        static_cast<int>(std::floor(*std::min_element(x, x + 3) / size - slack)), 0, roots[k] - 1);
      high[k] = std::clamp(
        static_cast<int>(std::floor(*std::max_element(x, x + 3) / size + slack)), 0, roots[k] - 1);
    }
    for (int z = low[2]; z <= high[2]; ++z)
    {
      for (int y = low[1]; y <= high[1]; ++y)
      {
        for (int x = low[0]; x <= high[0]; ++x)
        {
          if (this->Meets(triangle, 0, { x, y, z }))
          {
            pairs.emplace_back(BlockIndex{ z, y, x }, triangle);
          }
        }
      }
    }
  }

  /// The block meets the triangles at the end of List, from @a begin on.
  bool Split(std::int32_t node, int level, const BlockIndex& block, std::size_t begin)
  {
    if (level >= this->Frame.BaseLevel)
    {
      return true;
    }
    const std::int32_t first = this->Tree.Split(node, level, block);
    if (first < 0)
    {
      return false;
    }
    const std::size_t end = this->List.size();
    const bool last = level + 1 == this->Frame.BaseLevel;
    // Whether a child is split at all is known from the first triangle; only children with
    // grandchildren to split need their whole list.
    const bool firstIsEnough = level + 2 == this->Frame.BaseLevel;
    for (int child = 0; child < 8 && !last; ++child)
    {
      const BlockIndex index = ChildBlock({ level, block }, child).Index;
      for (std::size_t n = begin; n < end; ++n)
      {
        const Index triangle = this->List[n];
        if (this->Meets(triangle, level + 1, index))
        {
          this->List.push_back(triangle);
          if (firstIsEnough)
          {
            break;
          }
        }
      }
      if (this->List.size() > end && !this->Split(first + child, level + 1, index, end))
      {
        return false;
      }
      this->List.resize(end);
    }
    return true;
  }

  const std::vector<Triangle>& Triangles;
  const RootFrame& Frame;
  BlockTree& Tree;
  std::vector<Vec3> Points;
  std::vector<Index> List;
};

/// Split every block coarser than the wanted level that a box of one parent cell (two wanted cells)
/// each way around the point touches. A union of such sets: the order of the points has no effect.
bool SplitAtPoint(
  const Vec3& local, int level, const RootFrame& frame, const BlockIndex& roots, BlockTree& tree)
{
  const double radius = frame.BlockSize(level);
  for (int l = 0; l < level; ++l)
  {
    const double size = frame.BlockSize(l);
    int low[3];
    int high[3];
    for (int k = 0; k < 3; ++k)
    {
      const double count = static_cast<double>(roots[k] << l);
      low[k] = static_cast<int>(std::clamp(std::floor((local[k] - radius) / size), 0.0, count));
      high[k] =
        static_cast<int>(std::clamp(std::floor((local[k] + radius) / size), -1.0, count - 1));
    }
    for (int z = low[2]; z <= high[2]; ++z)
    {
      for (int y = low[1]; y <= high[1]; ++y)
      {
        for (int x = low[0]; x <= high[0]; ++x)
        {
          const std::int32_t node = tree.Ensure(l, { x, y, z });
          if (node < 0 || tree.Split(node, l, { x, y, z }) < 0)
          {
            return false;
          }
        }
      }
    }
  }
  return true;
}
} // namespace

Mat3 GridAxes(const SurfaceMesh& surface, bool alignToPrincipalAxes)
{
  const Mat3 unturned = Mat3::Identity();
  if (!alignToPrincipalAxes)
  {
    return unturned;
  }
  const Box box = BoxAlong(surface, unturned);
  const Mat3 axes = PrincipalAxes(surface, box.Center());
  return BoxAlong(surface, axes).Size().prod() < 0.99 * box.Size().prod() ? axes : unturned;
}

OctreePrediction PredictOctree(const SurfaceMesh& surface,
  const std::vector<RefinementPoint>& points, const OctreeOptions& options)
{
  if (!CheckInput(surface, points, options).Ok())
  {
    return OctreePrediction();
  }
  return PredictInFrame(surface, points, options, MakeRootFrame(surface, options));
}

Status BuildBlockOctree(const SurfaceMesh& surface, const std::vector<RefinementPoint>& points,
  const OctreeOptions& options, BlockOctree& octree, OctreePrediction* prediction, Monitor& monitor)
{
  octree = BlockOctree();
  Status status = CheckInput(surface, points, options);
  if (!status.Ok())
  {
    return status;
  }
  const RootFrame frame = MakeRootFrame(surface, options);
  OctreePrediction predicted = PredictInFrame(surface, points, options, frame);
  if (prediction)
  {
    *prediction = predicted;
  }
  int finest = frame.BaseLevel;
  for (const RefinementPoint& point : points)
  {
    finest = std::max(finest, AbsoluteLevel(point, options));
  }
  const double longest = std::max({ frame.Count[0], frame.Count[1], frame.Count[2] });
  if (!(8 * frame.Blocks() <= static_cast<double>(options.MaximumNumberOfCells)) ||
      std::ldexp(longest, finest) > std::ldexp(1.0, MaximumBlockBits))
  {
    return CellLimitStatus(predicted, options);
  }
  const BlockIndex roots = { static_cast<int>(frame.Count[0]), static_cast<int>(frame.Count[1]),
    static_cast<int>(frame.Count[2]) };

  BlockTree tree(roots, options.MaximumNumberOfCells / 8);
  bool complete = SurfaceSplitter(surface, frame, tree).Run(roots, monitor);
  for (std::size_t n = 0; n < points.size() && complete; ++n)
  {
    complete = (n % 1024 != 0 || monitor.Update(0.8)) &&
               SplitAtPoint(frame.ToLocal(points[n].Position), AbsoluteLevel(points[n], options),
                 frame, roots, tree);
  }
  complete = complete && tree.Balance(monitor);
  if (!complete)
  {
    return tree.WithinLimit() ? monitor.StopStatus() : CellLimitStatus(predicted, options);
  }

  octree.Origin = frame.Origin;
  octree.Axes = frame.Axes;
  octree.BaseLevel = frame.BaseLevel;
  octree.Depth = std::max(frame.BaseLevel, tree.Depth());
  octree.FinestCellSize = std::ldexp(frame.Unit, frame.BaseLevel - octree.Depth);
  octree.RootBlocks = roots;
  octree.Leaves = tree.SortedLeaves(octree.Depth);
  if (prediction)
  {
    prediction->Cells = 8 * tree.NumberOfLeaves();
    prediction->Hexes =
      static_cast<std::int64_t>(HexesPerCell * static_cast<double>(prediction->Cells));
  }
  return monitor.Update(1.0) ? Status() : monitor.StopStatus();
}
} // namespace featurehex
