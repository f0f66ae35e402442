// SPDX-License-Identifier: BSD-3-Clause
#include "HexStitching.h"

#include "HexQuality.h"
#include "MipsEnergy.h"
#include "Parallel.h"
#include "VertexSchedule.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr double BadScaledJacobian = 1e-4;
constexpr int Rings = 2;
constexpr double StitchingShare = 1e4; // lambda rises to this times E_D / E_S ...
constexpr double FirstWeight = 10.0;   // ... from this ...
constexpr double LargestWeight = 1e16; // ... up to this
/// Per sweep at most: faster, and copies freeze before they are in order.
constexpr double WeightGrowth = 1.15;
constexpr double RatioTest = 0.8;      // share of a determinant that one step may take
constexpr double LeastVolume = 0.05;   // of a cube, in cubes of the mean edge of its hex

/// A connected set of hexes that is untangled on its own.
struct Piece
{
  std::vector<Index> Hexes;
  double Weight = FirstWeight;
  Index Inverted = 0; ///< before
  Index Hopeless = 0; ///< no move can free these
  bool Done = false;
};

/// Vertices of one hex, its own copies.
using Copies = std::array<Vec3, 8>;

class Stitching
{
public:
  Stitching(HexMesh& mesh, const HexStars& stars, const HexOptimizer& terms)
    : Mesh(mesh)
    , Stars(stars)
    , Terms(terms)
    , Schedule(mesh.Hexes, stars.Hexes, 1)
    , PieceOf(mesh.Hexes.size(), -1)
    , CopiesOf(mesh.Hexes.size())
    , Free(mesh.Points.size(), 0)
  {
    this->FindPieces(this->ChooseHexes());
    this->TakeApart();
  }

  bool Done() const
  {
    return std::all_of(
      this->Pieces.begin(), this->Pieces.end(), [](const Piece& piece) { return piece.Done; });
  }

  void Sweep(Monitor& monitor)
  {
    this->Schedule.Sweep([this](Index v) { return this->VisitVertex(v); }, &monitor);
    ParallelFor(this->Pieces.size(), 1, [this](std::size_t i) { this->Judge(this->Pieces[i]); });
  }

  /// Pieces that are not free: back to where they were unless they are better now.
  void KeepBest()
  {
    for (const Piece& piece : this->Pieces)
    {
      if (!piece.Done && this->CountInverted(piece) >= piece.Inverted)
      {
        for (Index h : piece.Hexes)
        {
          for (Index v : this->Mesh.Hexes[h])
          {
            this->Mesh.Points[v] = this->Before[v];
          }
        }
      }
    }
  }

private:
  std::vector<char> ChooseHexes() const
  {
    const std::vector<double> quality = ScaledJacobians(this->Mesh);
    std::vector<char> chosen(quality.size());
    std::transform(quality.begin(), quality.end(), chosen.begin(),
      [](double q) { return !(q >= BadScaledJacobian); });
    for (int ring = 0; ring < Rings; ++ring)
    {
      std::vector<char> touched(this->Mesh.Points.size(), 0);
      for (std::size_t h = 0; h < chosen.size(); ++h)
      {
        for (Index v : this->Mesh.Hexes[h])
        {
          touched[v] |= chosen[h];
        }
      }
      for (std::size_t h = 0; h < chosen.size(); ++h)
      {
        const Hex& hex = this->Mesh.Hexes[h];
        chosen[h] = std::any_of(hex.begin(), hex.end(), [&](Index v) { return touched[v] != 0; });
      }
    }
    return chosen;
  }

  /// Chosen hexes that share vertices form a piece. A vertex is free when it is inside of one.
  void FindPieces(const std::vector<char>& chosen)
  {
    for (std::size_t seed = 0; seed < chosen.size(); ++seed)
    {
      if (!chosen[seed] || this->PieceOf[seed] >= 0)
      {
        continue;
      }
      const Index id = static_cast<Index>(this->Pieces.size());
      this->Pieces.emplace_back();
      std::vector<Index>& hexes = this->Pieces.back().Hexes;
      hexes.push_back(static_cast<Index>(seed));
      this->PieceOf[seed] = id;
      for (std::size_t i = 0; i < hexes.size(); ++i)
      {
        for (Index v : this->Mesh.Hexes[hexes[i]])
        {
          for (Index other : this->Stars.Hexes[v])
          {
            if (chosen[other] && this->PieceOf[other] < 0)
            {
              this->PieceOf[other] = id;
              hexes.push_back(other);
            }
          }
        }
      }
      this->Pieces.back().Inverted = this->CountInverted(this->Pieces.back());
      this->Pieces.back().Hopeless = static_cast<Index>(std::count_if(
        hexes.begin(), hexes.end(), [this](Index h) { return this->Terms.Hopeless(h); }));
    }
    for (std::size_t v = 0; v < this->Free.size(); ++v)
    {
      const IdLists::Range hexes = this->Stars.Hexes[static_cast<Index>(v)];
      this->Free[v] = !this->Terms.Fixed[v] &&
        std::all_of(hexes.begin(), hexes.end(), [&](Index h) { return chosen[h] != 0; });
    }
  }

  void TakeApart()
  {
    this->Before = this->Mesh.Points;
    ParallelFor(this->Mesh.Hexes.size(), 256, [this](std::size_t h) {
      if (this->PieceOf[h] >= 0)
      {
        this->CopiesOf[h] = this->CubeOf(static_cast<Index>(h));
      }
    });
    ParallelFor(this->Mesh.Points.size(), 1024, [this](std::size_t v) {
      const IdLists::Range hexes = this->Stars.Hexes[static_cast<Index>(v)];
      if (this->Free[v] && hexes.size() > 0)
      {
        Vec3 sum = Vec3::Zero();
        for (Index i = this->Stars.Hexes.Offsets[v]; i < this->Stars.Hexes.Offsets[v + 1]; ++i)
        {
          sum += this->CopiesOf[this->Stars.Hexes.Ids[i]][this->Stars.Corners[i]];
        }
        this->Mesh.Points[v] = sum / hexes.size();
      }
    });
  }

  /// Cube of the volume of the hex at its centre, turned as close to it as a rotation can.
  Copies CubeOf(Index h) const
  {
    constexpr int signs[8][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
      { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };
    Vec3 center = Vec3::Zero();
    Mat3 frame = Mat3::Zero(); // columns: the mean edges in the three directions
    for (int c = 0; c < 8; ++c)
    {
      const Vec3& p = this->Before[this->Mesh.Hexes[h][c]];
      center += p / 8;
      for (int k = 0; k < 3; ++k)
      {
        frame.col(k) += 0.25 * signs[c][k] * p;
      }
    }
    const Eigen::JacobiSVD<Mat3> svd(frame, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 turn = svd.matrixU();
    if ((turn * svd.matrixV().transpose()).determinant() < 0)
    {
      turn.col(2) *= -1;
    }
    const Mat3 rotation = turn * svd.matrixV().transpose();
    const double edge = this->MeanEdge(h);
    const double side =
      std::cbrt(std::max(frame.determinant(), LeastVolume * edge * edge * edge));
    Copies cube;
    for (int c = 0; c < 8; ++c)
    {
      cube[c] = center + 0.5 * side * (rotation * Vec3(signs[c][0], signs[c][1], signs[c][2]));
    }
    return cube;
  }

  double MeanEdge(Index h) const
  {
    double sum = 0;
    for (const auto& edge : HexEdges)
    {
      sum +=
        (this->Before[this->Mesh.Hexes[h][edge[1]]] - this->Before[this->Mesh.Hexes[h][edge[0]]])
          .norm();
    }
    return sum / 12;
  }

  Index CountInverted(const Piece& piece) const
  {
    return static_cast<Index>(std::count_if(piece.Hexes.begin(), piece.Hexes.end(),
      [this](Index h) { return !(LeastCornerDeterminant(this->Mesh, h) > 0); }));
  }

  /// Is the piece free? If not, the weight of its stitching grows.
  void Judge(Piece& piece)
  {
    if (piece.Done || this->CountInverted(piece) == piece.Hopeless)
    {
      piece.Done = true;
      return;
    }
    double distortion = 0;
    double stitching = 0;
    for (Index h : piece.Hexes)
    {
      const Copies& copies = this->CopiesOf[h];
      const auto point = [&copies](int i) -> const Vec3& { return copies[i]; };
      for (int c = 0; c < 8; ++c)
      {
        const MipsCorner corner = MipsCornersAt(point, c)[0];
        distortion += MipsValue(corner.S, corner.D);
        const Index v = this->Mesh.Hexes[h][c];
        const double size = this->Terms.SizeAt(v);
        stitching += (copies[c] - this->Mesh.Points[v]).squaredNorm() / (size * size);
      }
    }
    const double wanted = StitchingShare * distortion / std::max(stitching, 1e-300);
    piece.Weight =
      std::clamp(wanted, piece.Weight, std::min(WeightGrowth * piece.Weight, LargestWeight));
  }

  /// One copy of the vertex: its corners, their distortion, its offset from the merged position,
  /// its step.
  struct Copy
  {
    Vec3* Position;
    std::array<MipsCorner, 4> Corners;
    MipsSum Sum;
    Vec3 Offset;
    Vec3 Step;
    Eigen::LDLT<Mat3> Solver; ///< of Hessian + 2 weight I
  };

  Copy Gather(Index h, int c, const Vec3& merged, double weight)
  {
    Copy copy;
    Copies& copies = this->CopiesOf[h];
    copy.Position = &copies[c];
    copy.Corners = MipsCornersAt([&copies](int i) -> const Vec3& { return copies[i]; }, c);
    for (const MipsCorner& corner : copy.Corners)
    {
      copy.Sum.Add(corner, corner.D, 1.0);
    }
    copy.Offset = copies[c] - merged;
    copy.Solver.compute(copy.Sum.Hessian + 2 * weight * Mat3::Identity());
    return copy;
  }

  bool VisitVertex(Index v)
  {
    const Index first = this->Stars.Hexes.Offsets[v];
    const Index last = this->Stars.Hexes.Offsets[v + 1];
    static thread_local std::vector<Copy> copies;
    copies.clear();
    double weight = 0;
    for (Index i = first; i < last; ++i)
    {
      const Index h = this->Stars.Hexes.Ids[i];
      if (this->PieceOf[h] >= 0 && !this->Pieces[this->PieceOf[h]].Done)
      {
        const double size = this->Terms.SizeAt(v);
        weight = this->Pieces[this->PieceOf[h]].Weight / (size * size);
        copies.push_back(this->Gather(h, this->Stars.Corners[i], this->Mesh.Points[v], weight));
      }
    }
    if (copies.empty())
    {
      return false;
    }
    const Vec3 shift = this->Free[v]
                         ? this->MergedStep(copies, weight, this->Terms.VertexTerms[v], v)
                         : Vec3::Zero();
    for (Copy& copy : copies)
    {
      copy.Step = copy.Solver.solve(2 * weight * (shift - copy.Offset) - copy.Sum.Gradient);
    }
    return this->Move(v, copies, weight, shift);
  }

  /// Step of the merged position, with the best steps of the copies eliminated:
  /// (2 w sum A^-1 H + T) m = 2 w sum A^-1 (H p - g) + T t,
  /// A = H + 2 w I, T the Hessian of the surface term.
  Vec3 MergedStep(
    const std::vector<Copy>& copies, double weight, const SurfaceTerm& term, Index v) const
  {
    Mat3 matrix = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    for (const Copy& copy : copies)
    {
      matrix += 2 * weight * copy.Solver.solve(copy.Sum.Hessian);
      right +=
        2 * weight * copy.Solver.solve(copy.Sum.Hessian * copy.Offset - copy.Sum.Gradient);
    }
    if (term.Weight > 0)
    {
      const Mat3 surface = 2 * term.Weight *
        (term.Normal * term.Normal.transpose() + term.Tether * Mat3::Identity());
      matrix += surface;
      right += surface * (term.Target - this->Mesh.Points[v]);
    }
    return matrix.partialPivLu().solve(right);
  }

  /// Line search along the joint step.
  bool Move(Index v, const std::vector<Copy>& copies, double weight, const Vec3& shift)
  {
    double alpha = 1;
    for (const Copy& copy : copies)
    {
      for (const MipsCorner& corner : copy.Corners)
      {
        const double change = corner.GradD.dot(copy.Step);
        if (change < 0)
        {
          alpha = std::min(alpha, RatioTest * corner.D / -change);
        }
      }
    }
    const auto energyAt = [&](double a) {
      double sum = 0;
      for (const Copy& copy : copies)
      {
        for (const MipsCorner& corner : copy.Corners)
        {
          sum += MipsValue(corner.S + a * corner.GradS.dot(copy.Step) +
              a * a * corner.Edges * copy.Step.squaredNorm(),
            corner.D + a * corner.GradD.dot(copy.Step));
        }
        sum += weight * (copy.Offset + a * (copy.Step - shift)).squaredNorm();
      }
      const SurfaceTerm& term = this->Terms.VertexTerms[v];
      const Vec3 d = this->Mesh.Points[v] + a * shift - term.Target;
      const double nd = term.Normal.dot(d);
      return sum + term.Weight * (nd * nd + term.Tether * d.squaredNorm());
    };
    const double energy = energyAt(0);
    for (int trial = 0; trial < 6; ++trial, alpha *= 0.4)
    {
      if (energyAt(alpha) < energy)
      {
        for (const Copy& copy : copies)
        {
          *copy.Position += alpha * copy.Step;
        }
        this->Mesh.Points[v] += alpha * shift;
        return true;
      }
    }
    return false;
  }

  HexMesh& Mesh;
  const HexStars& Stars;
  const HexOptimizer& Terms;
  VertexSchedule Schedule;
  std::vector<Index> PieceOf;   ///< of each hex, -1: none
  std::vector<Copies> CopiesOf; ///< of each hex in a piece
  std::vector<char> Free;
  std::vector<Vec3> Before;
  std::vector<Piece> Pieces;
};
}

Status StitchHexes(HexMesh& mesh, const HexStars& stars, const HexOptimizer& terms,
  int maximumSweeps, int& sweeps, Monitor& monitor)
{
  Stitching stitching(mesh, stars, terms);
  for (sweeps = 0; !stitching.Done() && sweeps < maximumSweeps; ++sweeps)
  {
    if (!monitor.Update(static_cast<double>(sweeps) / maximumSweeps))
    {
      return monitor.StopStatus();
    }
    stitching.Sweep(monitor);
  }
  stitching.KeepBest();
  return monitor.StopStatus();
}
}
