// SPDX-License-Identifier: BSD-3-Clause
#include "IslandRepair.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

namespace featurehex
{
namespace
{
/// A path costs this much per hex besides its distance, and no more than MaximumPathCost in all.
constexpr double HexCost = 0.2;
constexpr double MaximumPathCost = 3.0;

/// Islands of at most so many hexes are dropped when no path leads to them.
constexpr Index MaximumDroppedHexes = 8;

/// A set of face-connected hexes with the same label.
struct Piece
{
  Index Size = 0;
  Index First = 0;      ///< lowest hex
  char Inside = 0;
  bool Border = false;  ///< reaches the border of the mesh
  Index Shell = -1;     ///< solid one for inside, cavity for outside; -1: exterior or none near
};

class Islands
{
public:
  Islands(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
    std::vector<char>& inside)
    : Graph(graph)
    , Distances(distances)
    , Surface(surface)
    , Inside(inside)
    , PieceOf(inside.size(), -1)
  {
    this->FindPieces();
    this->AssignShells();
  }

  Index Run()
  {
    // The largest piece of each label and shell stays.
    std::map<std::pair<char, Index>, Index> largest;
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      const auto [entry, fresh] = largest.insert({ this->Group(p), static_cast<Index>(p) });
      const Piece& best = this->Pieces[entry->second];
      const Piece& piece = this->Pieces[p];
      if (!fresh &&
        (piece.Border > best.Border || (piece.Border == best.Border && piece.Size > best.Size)))
      {
        entry->second = static_cast<Index>(p);
      }
    }
    Index flips = 0;
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      const Index target = largest[this->Group(p)];
      if (target != static_cast<Index>(p) && !this->Pieces[p].Border)
      {
        flips += this->Join(static_cast<Index>(p), target);
      }
    }
    return flips;
  }

private:
  std::pair<char, Index> Group(std::size_t piece) const
  {
    return { this->Pieces[piece].Inside, this->Pieces[piece].Shell };
  }

  void FindPieces()
  {
    std::vector<Index> stack;
    for (std::size_t start = 0; start < this->Inside.size(); ++start)
    {
      if (this->PieceOf[start] >= 0)
      {
        continue;
      }
      const Index id = static_cast<Index>(this->Pieces.size());
      Piece piece;
      piece.First = static_cast<Index>(start);
      piece.Inside = this->Inside[start];
      this->PieceOf[start] = id;
      stack.assign(1, static_cast<Index>(start));
      while (!stack.empty())
      {
        const Index h = stack.back();
        stack.pop_back();
        ++piece.Size;
        for (Index other : this->Graph.Neighbors[h])
        {
          piece.Border = piece.Border || other < 0;
          if (other >= 0 && this->PieceOf[other] < 0 && this->Inside[other] == piece.Inside)
          {
            this->PieceOf[other] = id;
            stack.push_back(other);
          }
        }
      }
      this->Pieces.push_back(piece);
    }
  }

  /// The shell to which most hexes of a piece are nearest, among those it can fill.
  void AssignShells()
  {
    std::map<std::pair<Index, Index>, Index> votes;
    for (std::size_t h = 0; h < this->Inside.size(); ++h)
    {
      if (this->Distances.Triangles[h] < 0)
      {
        continue;
      }
      const Index shell = this->Surface.OfFace[this->Distances.Triangles[h]];
      if (this->Surface.List[shell].Cavity() != static_cast<bool>(this->Inside[h]))
      {
        ++votes[{ this->PieceOf[h], shell }];
      }
    }
    std::vector<Index> most(this->Pieces.size(), 0);
    for (const auto& [key, count] : votes)
    {
      if (count > most[key.first] && !this->Pieces[key.first].Border)
      {
        most[key.first] = count;
        this->Pieces[key.first].Shell = key.second;
      }
    }
  }

  double FlipCost(Index hex) const
  {
    const double distance = this->Distances.Signed[hex];
    const double wrong = this->Inside[hex] ? -distance : distance;
    return HexCost + std::max(0.0, wrong);
  }

  /// Dijkstra from the hexes of the piece through hexes of the other label to the target.
  Index Join(Index piece, Index target)
  {
    const char label = this->Pieces[piece].Inside;
    std::map<Index, std::pair<double, Index>> reached; // hex: cost so far, hex before
    std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
      std::greater<>> queue;
    const std::vector<Index> island = this->HexesOf(piece);
    for (Index h : island)
    {
      reached[h] = { 0.0, -1 };
      queue.push({ 0.0, h });
    }
    while (!queue.empty())
    {
      const auto [cost, h] = queue.top();
      queue.pop();
      if (cost > reached[h].first)
      {
        continue;
      }
      if (this->PieceOf[h] == target && this->Inside[h] == label)
      {
        return this->FlipPath(h, reached, label);
      }
      for (Index other : this->Graph.Neighbors[h])
      {
        if (other < 0)
        {
          continue;
        }
        const double next = this->Inside[other] == label ? cost : cost + this->FlipCost(other);
        const auto found = reached.find(other);
        if (next <= MaximumPathCost && (found == reached.end() || next < found->second.first))
        {
          // Of the target one hex is enough, and other pieces are no way through.
          if (this->Inside[other] != label || this->PieceOf[other] == target)
          {
            reached[other] = { next, h };
            queue.push({ next, other });
          }
        }
      }
    }
    return this->Drop(piece, island);
  }

  std::vector<Index> HexesOf(Index piece) const
  {
    std::vector<Index> hexes = { this->Pieces[piece].First };
    std::set<Index> found(hexes.begin(), hexes.end());
    for (std::size_t i = 0; i < hexes.size(); ++i)
    {
      for (Index other : this->Graph.Neighbors[hexes[i]])
      {
        if (other >= 0 && this->PieceOf[other] == piece && found.insert(other).second)
        {
          hexes.push_back(other);
        }
      }
    }
    return hexes;
  }

  Index FlipPath(
    Index last, const std::map<Index, std::pair<double, Index>>& reached, char label)
  {
    Index flips = 0;
    for (Index h = last; h >= 0; h = reached.at(h).second)
    {
      if (this->Inside[h] != label)
      {
        this->Inside[h] = label;
        ++flips;
      }
    }
    return flips;
  }

  Index Drop(Index piece, const std::vector<Index>& hexes)
  {
    if (this->Pieces[piece].Size > MaximumDroppedHexes)
    {
      return 0;
    }
    for (Index h : hexes)
    {
      this->Inside[h] = !this->Pieces[piece].Inside;
    }
    return static_cast<Index>(hexes.size());
  }

  const HexGraph& Graph;
  const HexDistances& Distances;
  const Shells& Surface;
  std::vector<char>& Inside;
  std::vector<Index> PieceOf;
  std::vector<Piece> Pieces;
};
}

Index RepairIslands(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
  std::vector<char>& inside)
{
  return Islands(graph, distances, surface, inside).Run();
}
}
