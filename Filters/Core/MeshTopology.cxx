// SPDX-License-Identifier: BSD-3-Clause

#include "MeshTopology.h"

#include "DisjointSets.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace featurehex
{
namespace
{
/// Coincidence of points, fraction of the bounding box diagonal.
constexpr double Coincidence = 1e-12;

/// Values sorted into buckets by a key in [0, keys): a counting sort.
struct Buckets
{
  std::vector<std::uint32_t> Offsets; ///< of each bucket in Values; one more at the end
  std::vector<std::uint32_t> Values;

  /// visit(emit) calls emit(key, value) for every value; it runs twice.
  template <typename Visit>
  Buckets(std::size_t keys, const Visit& visit)
    : Offsets(keys + 2, 0)
  {
    visit([this](Index key, std::uint32_t) { ++this->Offsets[key + 2]; });
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    this->Values.resize(this->Offsets.back());
    visit([this](Index key, std::uint32_t value) {
      this->Values[this->Offsets[key + 1]++] = value;
    });
    this->Offsets.pop_back();
  }

  std::size_t Size() const { return this->Offsets.size() - 1; }
};

template <std::size_t N>
bool RepeatsId(std::array<Index, N> ids)
{
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) != ids.end();
}

// ---------------------------------------------------------------------------- surfaces

/// An edge as a corner of a face sees it.
struct EdgeUse
{
  Index Low, High;
  Index Corner; ///< face * N + k: the edge from corner k to the next
  bool Forward; ///< from Low to High

  bool operator<(const EdgeUse& o) const
  {
    return this->Low != o.Low ? this->Low < o.Low
      : this->High != o.High  ? this->High < o.High
                              : this->Corner < o.Corner;
  }
};

Vec3 TwiceArea(const std::vector<Vec3>& p, const Triangle& t)
{
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

Vec3 TwiceArea(const std::vector<Vec3>& p, const Quad& q)
{
  return (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]);
}

double SixVolume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c)
{
  return (a - o).dot((b - o).cross(c - o));
}

double SixVolume(const std::vector<Vec3>& p, const Triangle& t, const Vec3& o)
{
  return SixVolume(o, p[t[0]], p[t[1]], p[t[2]]);
}

/// The volume under a bilinear patch is the mean of those under its two diagonal splits.
double SixVolume(const std::vector<Vec3>& p, const Quad& q, const Vec3& o)
{
  const Vec3 &a = p[q[0]], &b = p[q[1]], &c = p[q[2]], &d = p[q[3]];
  return 0.5 * (SixVolume(o, a, b, c) + SixVolume(o, a, c, d) + SixVolume(o, a, b, d) +
    SixVolume(o, b, c, d));
}

template <std::size_t N>
std::vector<EdgeUse> SortedEdgeUses(const std::vector<std::array<Index, N>>& faces)
{
  std::vector<EdgeUse> uses;
  uses.reserve(faces.size() * N);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t k = 0; k < N; ++k)
    {
      const Index a = faces[f][k], b = faces[f][(k + 1) % N];
      uses.push_back(
        { std::min(a, b), std::max(a, b), static_cast<Index>(f * N + k), a < b });
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// Classifies the edges, joins faces across them into sheets and face corners into umbrellas.
template <std::size_t N>
void AnalyzeSurfaceEdges(const std::vector<std::array<Index, N>>& faces, SurfaceTopology& t,
  DisjointSets& sheets, DisjointSets& umbrellas, std::vector<Index>& faceOfEdge)
{
  const std::vector<EdgeUse> uses = SortedEdgeUses(faces);
  const auto cornerAt = [&](const EdgeUse& u, bool low) {
    const Index face = u.Corner / static_cast<Index>(N), k = u.Corner % static_cast<Index>(N);
    const bool here = low == u.Forward;
    return here ? u.Corner
                : face * static_cast<Index>(N) + (k + 1) % static_cast<Index>(N);
  };
  for (std::size_t i = 0; i < uses.size();)
  {
    std::size_t j = i + 1;
    while (j < uses.size() && uses[j].Low == uses[i].Low && uses[j].High == uses[i].High)
    {
      const Index n = static_cast<Index>(N);
      sheets.Join(uses[i].Corner / n, uses[j].Corner / n);
      umbrellas.Join(cornerAt(uses[i], true), cornerAt(uses[j], true));
      umbrellas.Join(cornerAt(uses[i], false), cornerAt(uses[j], false));
      ++j;
    }
    const bool misoriented = j - i == 2 && uses[i].Forward == uses[i + 1].Forward;
    t.OpenEdges += j - i == 1;
    t.NonManifoldEdges += j - i > 2;
    t.MisorientedEdges += misoriented;
    if (j - i != 2 || misoriented)
    {
      t.BadEdges.push_back({ uses[i].Low, uses[i].High });
    }
    faceOfEdge.push_back(uses[i].Corner / static_cast<Index>(N));
    i = j;
  }
  t.Edges = static_cast<Index>(faceOfEdge.size());
}

template <std::size_t N>
SurfaceTopology Analyze(
  const std::vector<Vec3>& points, const std::vector<std::array<Index, N>>& faces)
{
  SurfaceTopology t;
  t.Faces = static_cast<Index>(faces.size());
  DisjointSets sheets(faces.size());
  DisjointSets umbrellas(faces.size() * N);
  std::vector<Index> faceOfEdge;
  AnalyzeSurfaceEdges(faces, t, sheets, umbrellas, faceOfEdge);

  // Euler characteristic and volume by the root of the component.
  std::vector<Index> euler(faces.size(), 0);
  std::vector<double> volume(faces.size(), 0.0);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Index root = sheets.Find(static_cast<Index>(f));
    ++euler[root];
    volume[root] += SixVolume(points, faces[f], points[faces[root][0]]) / 6.0;
    t.Area += 0.5 * TwiceArea(points, faces[f]).norm();
    t.DegenerateFaces += RepeatsId(faces[f]);
  }
  for (Index f : faceOfEdge)
  {
    --euler[sheets.Find(f)];
  }
  std::vector<unsigned char> fans(points.size(), 0);
  for (std::size_t c = 0; c < faces.size() * N; ++c)
  {
    if (umbrellas.Find(static_cast<Index>(c)) == static_cast<Index>(c))
    {
      const Index v = faces[c / N][c % N];
      fans[v] = static_cast<unsigned char>(std::min(fans[v] + 1, 2));
      ++euler[sheets.Find(static_cast<Index>(c / N))];
    }
  }
  for (std::size_t v = 0; v < fans.size(); ++v)
  {
    t.Vertices += fans[v] > 0;
    if (fans[v] > 1)
    {
      t.BadVertices.push_back(static_cast<Index>(v));
    }
  }
  t.NonManifoldVertices = static_cast<Index>(t.BadVertices.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (sheets.Find(static_cast<Index>(f)) == static_cast<Index>(f))
    {
      ++t.Components;
      t.EulerCharacteristic += euler[f];
      t.Genus.push_back((2 - euler[f]) / 2);
      t.Volume += volume[f];
      t.Cavities += volume[f] < 0.0;
    }
  }
  std::sort(t.Genus.begin(), t.Genus.end());
  return t;
}

// ---------------------------------------------------------------------------- hexes

Quad FaceOf(const HexMesh& mesh, std::uint32_t code)
{
  const Hex& hex = mesh.Hexes[code / 6];
  const int* corners = HexFaces[code % 6];
  return { hex[corners[0]], hex[corners[1]], hex[corners[2]], hex[corners[3]] };
}

/// A face in its bucket: all ids but the lowest, ascending, and hex * 6 + face.
struct FaceUse
{
  std::array<Index, 3> Key;
  std::uint32_t Code;

  bool operator<(const FaceUse& o) const
  {
    return this->Key != o.Key ? this->Key < o.Key : this->Code < o.Code;
  }
};

enum class Cycle
{
  Same,
  Reversed,
  Twisted
};

Cycle CompareCycles(const Quad& a, const Quad& b)
{
  for (int shift = 0; shift < 4; ++shift)
  {
    bool same = true, reversed = true;
    for (int k = 0; k < 4; ++k)
    {
      same = same && a[k] == b[(shift + k) % 4];
      reversed = reversed && a[k] == b[(shift + 4 - k) % 4];
    }
    if (same || reversed)
    {
      return reversed ? Cycle::Reversed : Cycle::Same;
    }
  }
  return Cycle::Twisted;
}

/// What lies behind a face; written per face code, so that the parallel loop has no shared state.
enum FaceState : std::uint8_t
{
  Boundary = 0,
  Interior = 1,
  OverusedFace = 2,
  TwistedFace = 4,
  MisorientedFace = 8,
  FirstUse = 16 ///< set on the use with the lowest code: counts faces once
};

/// State of every face and, for all but the first use, the hex of the first use.
struct FaceTable
{
  std::vector<std::uint8_t> States; ///< by hex * 6 + face
  std::vector<std::uint32_t> First; ///< code of the first use of the same face

  explicit FaceTable(const HexMesh& mesh)
    : States(mesh.Hexes.size() * 6)
    , First(mesh.Hexes.size() * 6)
  {
    const auto codes = static_cast<std::uint32_t>(this->States.size());
    const Buckets buckets(mesh.Points.size(), [&](const auto& emit) {
      for (std::uint32_t code = 0; code < codes; ++code)
      {
        const Quad q = FaceOf(mesh, code);
        emit(*std::min_element(q.begin(), q.end()), code);
      }
    });
    constexpr std::size_t block = 1024;
    ParallelFor((buckets.Size() + block - 1) / block, 1, [&](std::size_t b) {
      std::vector<FaceUse> uses;
      const std::size_t end = std::min(buckets.Size(), (b + 1) * block);
      for (std::size_t v = b * block; v < end; ++v)
      {
        this->MatchBucket(mesh, buckets, v, uses);
      }
    });
  }

private:
  void MatchBucket(
    const HexMesh& mesh, const Buckets& buckets, std::size_t bucket, std::vector<FaceUse>& uses)
  {
    uses.clear();
    for (std::uint32_t i = buckets.Offsets[bucket]; i < buckets.Offsets[bucket + 1]; ++i)
    {
      Quad q = FaceOf(mesh, buckets.Values[i]);
      std::sort(q.begin(), q.end());
      uses.push_back({ { q[1], q[2], q[3] }, buckets.Values[i] });
    }
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 0; i < uses.size();)
    {
      std::size_t j = i + 1;
      int state = Boundary;
      const Quad first = FaceOf(mesh, uses[i].Code);
      for (; j < uses.size() && uses[j].Key == uses[i].Key; ++j)
      {
        const Cycle cycle = CompareCycles(first, FaceOf(mesh, uses[j].Code));
        state |= Interior | (j - i > 1 ? OverusedFace : 0) |
                 (cycle == Cycle::Twisted ? TwistedFace : 0) |
                 (cycle == Cycle::Same ? MisorientedFace : 0);
      }
      for (std::size_t k = i; k < j; ++k)
      {
        this->States[uses[k].Code] = static_cast<std::uint8_t>(state | (k == i ? FirstUse : 0));
        this->First[uses[k].Code] = uses[i].Code;
      }
      i = j;
    }
  }
};

HexBoundary CollectBoundary(const HexMesh& mesh, const FaceTable& table)
{
  HexBoundary boundary;
  for (std::uint32_t code = 0; code < table.States.size(); ++code)
  {
    if (!(table.States[code] & Interior))
    {
      boundary.Quads.push_back(FaceOf(mesh, code));
      boundary.Owners.push_back(static_cast<Index>(code / 6));
    }
  }
  return boundary;
}

void AppendOnce(std::vector<Index>& ids, Index id)
{
  if (ids.empty() || ids.back() != id)
  {
    ids.push_back(id);
  }
}

void AnalyzeFaces(const HexMesh& mesh, HexTopology& t)
{
  const FaceTable table(mesh);
  DisjointSets cells(mesh.Hexes.size());
  for (std::uint32_t code = 0; code < table.States.size(); ++code)
  {
    const int state = table.States[code];
    const auto hex = static_cast<Index>(code / 6);
    if (state & FirstUse)
    {
      ++t.Faces;
      t.InteriorFaces += (state & Interior) != 0;
      t.OverusedFaces += (state & OverusedFace) != 0;
      t.TwistedFaces += (state & TwistedFace) != 0;
      t.MisorientedFaces += (state & MisorientedFace) != 0;
    }
    else
    {
      cells.Join(hex, static_cast<Index>(table.First[code] / 6));
    }
    if (state & OverusedFace)
    {
      AppendOnce(t.Defects.Overused, hex);
    }
    if (state & TwistedFace)
    {
      AppendOnce(t.Defects.Twisted, hex);
    }
    if (state & MisorientedFace)
    {
      AppendOnce(t.Defects.Misoriented, hex);
    }
  }
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    t.Bodies += cells.Find(static_cast<Index>(h)) == static_cast<Index>(h);
  }
  t.Boundary = CollectBoundary(mesh, table);
}

/// Counts singular edges: the hexes at each edge, and whether a boundary quad has it.
void AnalyzeHexEdges(const HexMesh& mesh, HexTopology& t)
{
  // Value: the higher id, doubled, + 1 for the use by a boundary quad.
  Buckets buckets(mesh.Points.size(), [&](const auto& emit) {
    const auto edge = [&](Index a, Index b, std::uint32_t mark) {
      emit(std::min(a, b), 2 * static_cast<std::uint32_t>(std::max(a, b)) + mark);
    };
    for (const Hex& hex : mesh.Hexes)
    {
      for (const auto& e : HexEdges)
      {
        edge(hex[e[0]], hex[e[1]], 0);
      }
    }
    for (const Quad& q : t.Boundary.Quads)
    {
      for (int k = 0; k < 4; ++k)
      {
        edge(q[k], q[(k + 1) % 4], 1);
      }
    }
  });
  ParallelFor(buckets.Size(), 4096, [&](std::size_t b) {
    std::sort(buckets.Values.begin() + buckets.Offsets[b],
      buckets.Values.begin() + buckets.Offsets[b + 1]);
  });
  for (std::size_t b = 0; b < buckets.Size(); ++b)
  {
    for (std::uint32_t i = buckets.Offsets[b]; i < buckets.Offsets[b + 1];)
    {
      const std::uint32_t high = buckets.Values[i] / 2;
      int hexes = 0;
      bool boundary = false;
      for (; i < buckets.Offsets[b + 1] && buckets.Values[i] / 2 == high; ++i)
      {
        const bool mark = buckets.Values[i] & 1;
        boundary = boundary || mark;
        hexes += !mark;
      }
      ++t.Edges;
      t.BoundaryEdges += boundary;
      t.SingularBoundaryEdges += boundary && hexes != 2;
      t.SingularInteriorEdges += !boundary && hexes != 4;
    }
  }
}

std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
  return hash ^ (hash >> 29);
}

/// A hash and who has it; equal hashes are compared in full.
struct HashedId
{
  std::uint64_t Hash;
  Index Id;

  bool operator<(const HashedId& o) const
  {
    return this->Hash != o.Hash ? this->Hash < o.Hash : this->Id < o.Id;
  }
};

void FindBadHexes(const HexMesh& mesh, HexTopology& t)
{
  const auto sorted = [&](Index id) {
    Hex h = mesh.Hexes[id];
    std::sort(h.begin(), h.end());
    return h;
  };
  std::vector<HashedId> hashes(mesh.Hexes.size());
  for (std::size_t i = 0; i < hashes.size(); ++i)
  {
    const Hex h = sorted(static_cast<Index>(i));
    std::uint64_t hash = 0;
    for (Index v : h)
    {
      hash = Mix(hash, static_cast<std::uint64_t>(v));
    }
    hashes[i] = { hash, static_cast<Index>(i) };
    if (std::adjacent_find(h.begin(), h.end()) != h.end())
    {
      t.DegenerateHexIds.push_back(static_cast<Index>(i));
    }
  }
  std::sort(hashes.begin(), hashes.end());
  for (std::size_t i = 1; i < hashes.size(); ++i)
  {
    if (hashes[i].Hash == hashes[i - 1].Hash && sorted(hashes[i].Id) == sorted(hashes[i - 1].Id))
    {
      t.DuplicateHexIds.push_back(hashes[i].Id);
    }
  }
  std::sort(t.DuplicateHexIds.begin(), t.DuplicateHexIds.end());
  t.DuplicateHexes = static_cast<Index>(t.DuplicateHexIds.size());
  t.DegenerateHexes = static_cast<Index>(t.DegenerateHexIds.size());
}

void AnalyzePoints(const HexMesh& mesh, HexTopology& t)
{
  std::vector<char> used(mesh.Points.size(), 0);
  for (const Hex& h : mesh.Hexes)
  {
    for (Index v : h)
    {
      used[v] = 1;
    }
  }
  std::vector<Vec3> points;
  Box box;
  for (std::size_t v = 0; v < used.size(); ++v)
  {
    if (used[v] && mesh.Points[v].allFinite())
    {
      points.push_back(mesh.Points[v]);
      box.Extend(mesh.Points[v]);
    }
    t.OrphanPoints += !used[v];
  }
  t.DuplicatePoints = CountCoincidentPoints(points, Coincidence * box.Diagonal());
}
}

SurfaceTopology AnalyzeSurface(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  return Analyze(points, triangles);
}

SurfaceTopology AnalyzeSurface(const std::vector<Vec3>& points, const std::vector<Quad>& quads)
{
  return Analyze(points, quads);
}

bool SameTopology(const SurfaceTopology& a, const SurfaceTopology& b)
{
  const auto cavities = [](const SurfaceTopology& t) {
    return t.Volume < 0.0 ? t.Components - t.Cavities : t.Cavities;
  };
  return a.ClosedManifold() && b.ClosedManifold() && a.Genus == b.Genus &&
    cavities(a) == cavities(b);
}

HexTopology AnalyzeHexMesh(const HexMesh& mesh)
{
  HexTopology t;
  t.Points = static_cast<Index>(mesh.Points.size());
  t.Hexes = static_cast<Index>(mesh.Hexes.size());
  AnalyzePoints(mesh, t);
  FindBadHexes(mesh, t);
  AnalyzeFaces(mesh, t);
  AnalyzeHexEdges(mesh, t);
  t.Surface = AnalyzeSurface(mesh.Points, t.Boundary.Quads);
  return t;
}

HexBoundary ExtractBoundary(const HexMesh& mesh)
{
  return CollectBoundary(mesh, FaceTable(mesh));
}

Index CountCoincidentPoints(const std::vector<Vec3>& points, double tolerance)
{
  Box box;
  for (const Vec3& p : points)
  {
    if (p.allFinite())
    {
      box.Extend(p);
    }
  }
  // Each point is filed in all cells that its tolerance box meets: mostly one, at most eight. Cells
  // of 16 tolerances bound the number of distinct points in one.
  const double cell = std::max(16.0 * tolerance, 1e-300);
  std::vector<HashedId> entries;
  entries.reserve(points.size() + points.size() / 2);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!points[i].allFinite())
    {
      continue;
    }
    std::int64_t low[3], high[3];
    for (int d = 0; d < 3; ++d)
    {
      const double x = points[i][d] - box.Low[d];
      low[d] =
        static_cast<std::int64_t>(std::clamp(std::floor((x - tolerance) / cell), -9e18, 9e18));
      high[d] =
        static_cast<std::int64_t>(std::clamp(std::floor((x + tolerance) / cell), -9e18, 9e18));
    }
    for (std::int64_t a = low[0]; a <= high[0]; ++a)
    {
      for (std::int64_t b = low[1]; b <= high[1]; ++b)
      {
        for (std::int64_t c = low[2]; c <= high[2]; ++c)
        {
          const std::uint64_t hash =
            Mix(Mix(Mix(0, static_cast<std::uint64_t>(a)), static_cast<std::uint64_t>(b)),
              static_cast<std::uint64_t>(c));
          entries.push_back({ hash, static_cast<Index>(i) });
        }
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  std::vector<char> coincides(points.size(), 0);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    for (std::size_t j = i; j-- > 0 && entries[j].Hash == entries[i].Hash;)
    {
      if (entries[j].Id != entries[i].Id &&
        (points[entries[j].Id] - points[entries[i].Id]).norm() <= tolerance)
      {
        coincides[entries[i].Id] = 1;
        break;
      }
    }
  }
  return static_cast<Index>(std::count(coincides.begin(), coincides.end(), 1));
}
}
