// SPDX-License-Identifier: BSD-3-Clause
#include "HandleRepair.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace featurehex
{
namespace
{
/// Centres of flipped hexes may lie this far on the wrong side, in cells.
constexpr double MaximumWrongDistance = 1.0;
constexpr std::size_t LargestSet = 3;

/// More sets than this are not looked at: finer hexes are the better way then.
constexpr std::size_t MaximumSets = 50000;

using HexSet = std::vector<Index>; ///< sorted

class Handles
{
public:
  Handles(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
    const std::function<bool(Index, Index)>& seesOther, std::vector<Index>& excess,
    std::vector<char>& inside)
    : Graph(graph)
    , Distances(distances)
    , Surface(surface)
    , SeesOther(seesOther)
    , Excess(excess)
    , Inside(inside)
    , Mark(inside.size(), 0)
  {
  }

  Index Run()
  {
    Index flips = 0;
    for (const bool spare : { true, false })
    {
      this->SpareReal = spare;
      for (std::size_t size = 1; size <= LargestSet && this->AnyExcess(); ++size)
      {
        for (const HexSet& set : this->Candidates(size))
        {
          flips += this->TryFlip(set);
        }
      }
    }
    return flips;
  }

private:
  bool AnyExcess() const
  {
    return std::any_of(this->Excess.begin(), this->Excess.end(), [](Index e) { return e > 0; });
  }

  /// How far the centre is on the wrong side after a flip.
  double WrongDistance(Index hex) const
  {
    const double distance = this->Distances.Signed[hex];
    return std::max(0.0, this->Inside[hex] ? -distance : distance);
  }

  Index ShellOf(Index hex) const
  {
    const Index triangle = this->Distances.Triangles[hex];
    return triangle < 0 ? -1 : this->Surface.OfFace[triangle];
  }

  bool MayFlip(Index hex) const
  {
    const Index shell = this->ShellOf(hex);
    if (shell < 0 || this->Excess[shell] <= 0 || this->WrongDistance(hex) > MaximumWrongDistance)
    {
      return false;
    }
    int others = 0;
    for (Index other : this->Graph.Neighbors[hex])
    {
      if (other < 0)
      {
        return false;
      }
      others += this->Inside[other] != this->Inside[hex];
    }
    // Part of a window or of a bridge of at most LargestSet hexes.
    return others >= 2;
  }

  /// Face-connected sets of hexes with one label, the least wrong ones first.
  std::vector<HexSet> Candidates(std::size_t size) const
  {
    std::set<HexSet> sets;
    for (std::size_t h = 0; h < this->Inside.size(); ++h)
    {
      if (this->MayFlip(static_cast<Index>(h)))
      {
        sets.insert({ static_cast<Index>(h) });
      }
    }
    for (std::size_t grown = 1; grown < size; ++grown)
    {
      std::set<HexSet> larger;
      for (const HexSet& set : sets)
      {
        for (Index h : set)
        {
          for (Index other : this->Graph.Neighbors[h])
          {
            if (this->Inside[other] == this->Inside[h] && this->MayFlip(other) &&
              !std::binary_search(set.begin(), set.end(), other))
            {
              HexSet next = set;
              next.insert(std::upper_bound(next.begin(), next.end(), other), other);
              larger.insert(std::move(next));
            }
          }
        }
        if (larger.size() > MaximumSets)
        {
          return {};
        }
      }
      sets = std::move(larger);
    }
    std::vector<std::pair<double, HexSet>> ranked;
    for (const HexSet& set : sets)
    {
      if (!this->CutsSomething(set))
      {
        continue;
      }
      double wrong = 0.0;
      for (Index h : set)
      {
        wrong += this->WrongDistance(h);
      }
      ranked.push_back({ wrong, set });
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<HexSet> result;
    for (auto& entry : ranked)
    {
      result.push_back(std::move(entry.second));
    }
    return result;
  }

  /// Neighbours of the set with its own label: a window or a bridge has two groups of them.
  std::vector<Index> Ends(const HexSet& set) const
  {
    std::vector<Index> ends;
    for (Index h : set)
    {
      for (Index other : this->Graph.Neighbors[h])
      {
        if (other >= 0 && this->Inside[other] == this->Inside[h] &&
          !std::binary_search(set.begin(), set.end(), other))
        {
          ends.push_back(other);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  bool CutsSomething(const HexSet& set) const
  {
    const std::size_t count = this->Ends(set).size();
    return count >= 2 && count <= 2 * set.size();
  }

  Index TryFlip(const HexSet& set)
  {
    const char label = this->Inside[set[0]];
    for (Index h : set)
    {
      if (this->Inside[h] != label || !this->MayFlip(h))
      {
        return 0;
      }
    }
    const std::vector<Index> ends = this->Ends(set);
    if (ends.size() < 2 || (this->SpareReal && this->IsOfSurface(set)))
    {
      return 0;
    }
    const int before = this->LocalEuler(set);
    this->Flip(set);
    // One handle less: the Euler characteristic of the interface grows by 2. So it does when the
    // flip tears off a component, which the last test excludes.
    const bool good =
      this->Manifold(set) && this->LocalEuler(set) == before + 2 && this->Connected(ends);
    if (!good)
    {
      this->Flip(set);
      return 0;
    }
    --this->Excess[this->ShellOf(set[0])];
    return static_cast<Index>(set.size());
  }

  /// A piece of a beam or tunnel that the surface has, too: it is on its side and sees two ends
  /// that are apart.
  bool IsOfSurface(const HexSet& set) const
  {
    std::vector<Index> seen;
    for (Index h : set)
    {
      if ((this->Distances.Signed[h] < 0) != (this->Inside[h] != 0))
      {
        return false;
      }
      for (Index other : this->Graph.Neighbors[h])
      {
        if (this->Inside[other] == this->Inside[h] &&
          !std::binary_search(set.begin(), set.end(), other) && this->SeesOther(h, other))
        {
          seen.push_back(other);
        }
      }
    }
    return !seen.empty() && this->Apart(seen);
  }

  /// Not all of the hexes are reached from the first through common faces.
  bool Apart(std::vector<Index> hexes) const
  {
    std::sort(hexes.begin(), hexes.end());
    hexes.erase(std::unique(hexes.begin(), hexes.end()), hexes.end());
    std::vector<Index> reached = { hexes[0] };
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      for (Index other : this->Graph.Neighbors[reached[i]])
      {
        if (std::binary_search(hexes.begin(), hexes.end(), other) &&
          std::find(reached.begin(), reached.end(), other) == reached.end())
        {
          reached.push_back(other);
        }
      }
    }
    return reached.size() < hexes.size();
  }

  void Flip(const HexSet& set)
  {
    for (Index h : set)
    {
      this->Inside[h] ^= 1;
    }
  }

  bool Manifold(const HexSet& set) const
  {
    for (Index h : set)
    {
      for (Index v : this->Graph.Mesh.Hexes[h])
      {
        if (IsNonManifold(this->Graph, this->Inside, v))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Vertices - edges + faces of the interface among those of the set.
  int LocalEuler(const HexSet& set) const
  {
    std::set<Index> vertices;
    std::set<std::pair<Index, Index>> edges;
    std::set<std::pair<Index, Index>> faces;
    for (Index h : set)
    {
      const Hex& hex = this->Graph.Mesh.Hexes[h];
      vertices.insert(hex.begin(), hex.end());
      for (const int* edge : HexEdges)
      {
        edges.insert(std::minmax(hex[edge[0]], hex[edge[1]]));
      }
      for (Index other : this->Graph.Neighbors[h])
      {
        if (this->Inside[other] != this->Inside[h])
        {
          faces.insert({ h, other });
        }
      }
    }
    int euler = static_cast<int>(faces.size());
    for (Index v : vertices)
    {
      euler += this->Mixed(v, v);
    }
    for (const auto& [a, b] : edges)
    {
      euler -= this->Mixed(a, b);
    }
    return euler;
  }

  /// Do the hexes at both vertices have different labels?
  bool Mixed(Index a, Index b) const
  {
    bool found[2] = { false, false };
    for (Index h : this->Graph.HexesOfVertex[a])
    {
      const Hex& hex = this->Graph.Mesh.Hexes[h];
      if (a == b || std::find(hex.begin(), hex.end(), b) != hex.end())
      {
        found[static_cast<int>(this->Inside[h])] = true;
      }
    }
    return found[0] && found[1];
  }

  /// Can the hexes still reach each other through hexes of their label?
  bool Connected(const std::vector<Index>& ends)
  {
    ++this->Stamp;
    std::size_t left = ends.size() - 1;
    std::vector<Index> queue = { ends[0] };
    this->Mark[ends[0]] = this->Stamp;
    for (std::size_t i = 0; i < queue.size() && left > 0; ++i)
    {
      for (Index other : this->Graph.Neighbors[queue[i]])
      {
        if (other >= 0 && this->Mark[other] != this->Stamp &&
          this->Inside[other] == this->Inside[ends[0]])
        {
          this->Mark[other] = this->Stamp;
          queue.push_back(other);
          left -= std::binary_search(ends.begin(), ends.end(), other);
        }
      }
    }
    return left == 0;
  }

  const HexGraph& Graph;
  const HexDistances& Distances;
  const Shells& Surface;
  const std::function<bool(Index, Index)>& SeesOther;
  std::vector<Index>& Excess;
  std::vector<char>& Inside;
  std::vector<int> Mark;
  int Stamp = 0;
  bool SpareReal = true; ///< handles that the surface has
};
}

Index RepairHandles(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
  const std::function<bool(Index, Index)>& seesOther, std::vector<Index>& excess,
  std::vector<char>& inside)
{
  return Handles(graph, distances, surface, seesOther, excess, inside).Run();
}
}
