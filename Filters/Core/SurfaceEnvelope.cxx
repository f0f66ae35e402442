// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceEnvelope.h"

#include "Parallel.h"
#include "QuadSearch.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr std::size_t SamplesPerRun = 256;

Vec3 Weighted(const HexMesh& mesh, const Quad& quad, const std::array<double, 4>& weights)
{
  return weights[0] * mesh.Points[quad[0]] + weights[1] * mesh.Points[quad[1]] +
    weights[2] * mesh.Points[quad[2]] + weights[3] * mesh.Points[quad[3]];
}
}

SurfaceEnvelope::SurfaceEnvelope(const SurfaceGeometry& surface, const std::vector<Vec3>& samples,
  const HexMesh& mesh, const HexStars& stars, int grid, Monitor* monitor)
  : Surface(surface)
  , Samples(samples)
  , Mesh(mesh)
  , Stars(stars)
  , Progress(monitor)
  , FirstSample(stars.Quads.size(), -1)
  , Forward(stars.Quads.size(), 1e300)
  , Reverse(stars.Quads.size(), 1e300)
{
  for (int i = 0; i < grid; ++i)
  {
    for (int j = 0; j < grid; ++j)
    {
      const double u = static_cast<double>(i) / (grid - 1);
      const double v = static_cast<double>(j) / (grid - 1);
      this->GridWeights.push_back({ (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v });
    }
  }
  this->Hints.assign(stars.Quads.size() * this->GridWeights.size(), -1);
}

Vec3 SurfaceEnvelope::GridPoint(Index quad, int i) const
{
  return Weighted(this->Mesh, this->Stars.Quads[quad], this->GridWeights[i]);
}

EnvelopeContact SurfaceEnvelope::ClosestOnQuad(Index sample, Index quad) const
{
  const Quad& q = this->Stars.Quads[quad];
  const Vec3& p = this->Samples[sample];
  const Vec3 center = Weighted(this->Mesh, q, { 0.25, 0.25, 0.25, 0.25 });
  TrianglePoint best;
  int side = 0;
  for (int k = 0; k < 4; ++k)
  {
    const TrianglePoint found = ClosestPointOnTriangle(
      p, this->Mesh.Points[q[k]], this->Mesh.Points[q[(k + 1) % 4]], center);
    if (found.Distance < best.Distance)
    {
      best = found;
      side = k;
    }
  }
  EnvelopeContact contact;
  contact.Quad = quad;
  contact.Weights.fill(0.25 * best.Barycentric[2]);
  contact.Weights[side] += best.Barycentric[0];
  contact.Weights[(side + 1) % 4] += best.Barycentric[1];
  contact.QuadPoint = best.Point;
  contact.SurfacePoint = p;
  contact.Distance = best.Distance;
  return contact;
}

/// The point of the quad that was closest the last time; infinitely far when it was on another
/// quad.
EnvelopeContact SurfaceEnvelope::AtWitness(Index sample, Index quad) const
{
  const Witness& witness = this->Witnesses[sample];
  EnvelopeContact contact;
  contact.Quad = quad;
  contact.SurfacePoint = this->Samples[sample];
  contact.Distance = 1e300;
  if (witness.Quad == quad)
  {
    for (int k = 0; k < 4; ++k)
    {
      contact.Weights[k] = witness.Weights[k];
    }
    contact.QuadPoint = Weighted(this->Mesh, this->Stars.Quads[quad], contact.Weights);
    contact.Distance = (contact.QuadPoint - contact.SurfacePoint).norm();
  }
  return contact;
}

/// Closest on the quad itself; when that is not near enough and lies on an edge, also on the quads
/// next to it.
EnvelopeContact SurfaceEnvelope::ClosestNear(Index sample, Index quad, double enough)
{
  EnvelopeContact best = this->AtWitness(sample, quad);
  if (best.Distance <= enough)
  {
    return best;
  }
  best = this->ClosestOnQuad(sample, quad);
  const bool onEdge = *std::min_element(best.Weights.begin(), best.Weights.end()) == 0;
  if (best.Distance > enough && onEdge)
  {
    for (Index other : this->Stars.QuadNeighbors[quad])
    {
      const EnvelopeContact found = this->ClosestOnQuad(sample, other);
      if (found.Distance < best.Distance)
      {
        best = found;
      }
    }
  }
  this->Witnesses[sample].Quad = best.Quad;
  for (int k = 0; k < 4; ++k)
  {
    this->Witnesses[sample].Weights[k] = static_cast<float>(best.Weights[k]);
  }
  return best;
}

double SurfaceEnvelope::MeasureForward(
  Index quad, double enough, Purpose purpose, std::vector<EnvelopeContact>* contacts)
{
  double largest = 0;
  Index near = -1; // the triangle of the point before: a point that has none yet looks there first
  const int count = static_cast<int>(this->GridWeights.size());
  for (int i = 0; i < count; ++i)
  {
    const Vec3 p = this->GridPoint(quad, i);
    Index& hint = this->Hints[static_cast<std::size_t>(quad) * count + i];
    TrianglePoint found;
    if (hint >= 0)
    {
      found = this->Surface.Search().ClosestOn(p, hint);
    }
    if (found.Distance > enough)
    {
      found = this->Surface.Search().Closest(p, hint >= 0 ? hint : near);
      hint = found.Triangle;
    }
    near = hint;
    largest = std::max(largest, found.Distance);
    if (purpose == Purpose::Decision && largest > enough)
    {
      return largest;
    }
    if (contacts && found.Distance > enough)
    {
      contacts->push_back({ quad, this->GridWeights[i], p, found.Point, found.Distance });
    }
  }
  return largest;
}

double SurfaceEnvelope::MeasureReverse(Index quad, double enough, Purpose purpose,
  std::vector<Transfer>& transfers, std::vector<EnvelopeContact>* contacts)
{
  double largest = 0;
  for (Index s = this->FirstSample[quad]; s >= 0; s = this->NextSample[s])
  {
    const EnvelopeContact found = this->ClosestNear(s, quad, enough);
    if (found.Quad != quad)
    {
      transfers.push_back({ s, quad, found.Quad, found.Distance });
    }
    largest = std::max(largest, found.Distance);
    if (purpose == Purpose::Decision && largest > enough)
    {
      return largest;
    }
    if (contacts && found.Distance > enough)
    {
      contacts->push_back(found);
    }
  }
  return largest;
}

void SurfaceEnvelope::Apply(const std::vector<Transfer>& transfers)
{
  for (const Transfer& t : transfers)
  {
    Index* link = &this->FirstSample[t.From];
    while (*link != t.Sample)
    {
      link = &this->NextSample[*link];
    }
    *link = this->NextSample[t.Sample];
    this->NextSample[t.Sample] = this->FirstSample[t.To];
    this->FirstSample[t.To] = t.Sample;
    this->Reverse[t.To] = std::max(this->Reverse[t.To], t.Distance);
  }
}

void SurfaceEnvelope::LinkSamples(const std::vector<Index>& owners)
{
  std::fill(this->FirstSample.begin(), this->FirstSample.end(), -1);
  for (std::size_t s = owners.size(); s-- > 0;)
  {
    this->NextSample[s] = this->FirstSample[owners[s]];
    this->FirstSample[owners[s]] = static_cast<Index>(s);
  }
  std::fill(this->Reverse.begin(), this->Reverse.end(), 1e300);
}

void SurfaceEnvelope::Measure(double enough)
{
  std::vector<std::vector<Transfer>> transfers(this->Stars.Quads.size());
  ParallelFor(this->Stars.Quads.size(), 64, this->Progress, [&](std::size_t q) {
    const Index quad = static_cast<Index>(q);
    if (this->Forward[q] > enough)
    {
      this->Forward[q] = this->MeasureForward(quad, enough, Purpose::Distance, nullptr);
    }
    if (this->Reverse[q] > enough)
    {
      this->Reverse[q] =
        this->MeasureReverse(quad, enough, Purpose::Distance, transfers[q], nullptr);
    }
  });
  for (const std::vector<Transfer>& list : transfers)
  {
    this->Apply(list);
  }
}

void SurfaceEnvelope::Rebuild()
{
  if (this->Stars.Quads.empty())
  {
    return;
  }
  const QuadSearch search(this->Mesh, this->Stars.Quads);
  this->Closest.resize(this->Samples.size(), -1);
  this->Witnesses.resize(this->Samples.size());
  this->NextSample.resize(this->Samples.size(), -1);
  std::vector<Index> owners(this->Samples.size());
  const std::size_t runs = (this->Samples.size() + SamplesPerRun - 1) / SamplesPerRun;
  ParallelFor(runs, 4, this->Progress, [&](std::size_t run) {
    const std::size_t last = std::min((run + 1) * SamplesPerRun, this->Samples.size());
    Index near = -1; // samples in a row are often near each other
    for (std::size_t s = run * SamplesPerRun; s < last; ++s)
    {
      near = this->Closest[s] >= 0 ? this->Closest[s] : near;
      owners[s] = search.Closest(this->Samples[s], near);
      this->Closest[s] = near;
    }
  });
  this->LinkSamples(owners);
}

void SurfaceEnvelope::Update(double enough)
{
  std::vector<Index> owners(this->Samples.size());
  ParallelFor(this->Stars.Quads.size(), 64, this->Progress, [&](std::size_t q) {
    for (Index s = this->FirstSample[q]; s >= 0; s = this->NextSample[s])
    {
      owners[s] = static_cast<Index>(q);
      for (int steps = 0; steps < 8; ++steps)
      {
        const Index next = this->ClosestNear(s, owners[s], enough).Quad;
        if (next == owners[s])
        {
          break;
        }
        owners[s] = next;
      }
    }
  });
  this->LinkSamples(owners);
}

double SurfaceEnvelope::BoundAround(Index vertex) const
{
  double bound = 0;
  for (Index q : this->Stars.QuadsOfVertex[vertex])
  {
    bound = std::max({ bound, this->Forward[q], this->Reverse[q] });
  }
  return bound;
}

bool SurfaceEnvelope::AcceptMove(IdLists::Range quads, double shift, double limit)
{
  static thread_local std::vector<std::array<double, 2>> bounds;
  static thread_local std::vector<Transfer> transfers;
  bounds.clear();
  transfers.clear();
  for (Index q : quads)
  {
    std::array<double, 2> bound = { this->Forward[q] + shift, this->Reverse[q] + shift };
    if (bound[0] > limit)
    {
      bound[0] = this->MeasureForward(q, limit, Purpose::Decision, nullptr);
    }
    if (bound[0] <= limit && bound[1] > limit)
    {
      bound[1] = this->MeasureReverse(q, limit, Purpose::Decision, transfers, nullptr);
    }
    if (bound[0] > limit || bound[1] > limit)
    {
      return false;
    }
    bounds.push_back(bound);
  }
  for (Index i = 0; i < quads.size(); ++i)
  {
    this->Forward[quads[i]] = bounds[i][0];
    this->Reverse[quads[i]] = bounds[i][1];
  }
  this->Apply(transfers);
  return true;
}

void SurfaceEnvelope::Collect(
  Index quad, double threshold, std::vector<EnvelopeContact>& contacts)
{
  if (this->Forward[quad] > threshold)
  {
    this->Forward[quad] = this->MeasureForward(quad, threshold, Purpose::Distance, &contacts);
  }
  if (this->Reverse[quad] > threshold)
  {
    std::vector<Transfer> transfers;
    this->Reverse[quad] =
      this->MeasureReverse(quad, threshold, Purpose::Distance, transfers, &contacts);
    this->Apply(transfers);
  }
}

EnvelopeContact SurfaceEnvelope::WorstReverse(Index quad, double threshold) const
{
  EnvelopeContact worst;
  if (this->Reverse[quad] > threshold)
  {
    worst.Distance = threshold;
    for (Index s = this->FirstSample[quad]; s >= 0; s = this->NextSample[s])
    {
      if (this->AtWitness(s, quad).Distance <= worst.Distance)
      {
        continue;
      }
      const EnvelopeContact found = this->ClosestOnQuad(s, quad);
      if (found.Distance > worst.Distance)
      {
        worst = found;
      }
    }
  }
  return worst;
}

double SurfaceEnvelope::ForwardMaximum() const
{
  return this->Forward.empty() ? 0.0
                               : *std::max_element(this->Forward.begin(), this->Forward.end());
}

double SurfaceEnvelope::ReverseMaximum() const
{
  return this->Reverse.empty() ? 0.0
                               : *std::max_element(this->Reverse.begin(), this->Reverse.end());
}
}
