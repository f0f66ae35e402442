// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureExtraction.h"

#include "MessageText.h"
#include "RedundantCurves.h"
#include "SurfaceFlaws.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace featurehex
{
namespace
{
/// Beyond this LooseShare features are noise. Measured: CAD parts 0 to 0.43, scans 0.53 to 1.
constexpr double DoubtfulShare = 0.5;

std::vector<PointPair> Sorted(std::vector<PointPair> edges)
{
  for (PointPair& edge : edges)
  {
    edge = { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Index> Sorted(std::vector<Index> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

template <typename T>
std::vector<T> Without(const std::vector<T>& all, const std::vector<T>& some)
{
  std::vector<T> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

std::string FirstPlace(const std::vector<Vec3>& places)
{
  return places.empty() ? "." : ", the first at " + PlaceText(places.front()) + ".";
}

void DescribeCleanUp(const FeatureDetectionReport& found, std::vector<std::string>& notes)
{
  if (found.NumberOfContinuedEdges > 0)
  {
    notes.push_back(CountText(found.NumberOfContinuedEdges, "edge", "edges") +
                    " less sharp than the angle taken to continue sharp chains" +
                    FirstPlace(found.Continued));
  }
  if (found.NumberOfGaps > 0)
  {
    notes.push_back(CountText(found.NumberOfGaps, "gap", "gaps") +
                    " of feature curves closed with " +
                    CountText(found.NumberOfGapEdges, "edge", "edges") + FirstPlace(found.Gaps));
  }
  if (found.NumberOfSpurs > 0)
  {
    notes.push_back(CountText(found.NumberOfSpurs, "short chain", "short chains") +
                    " with a loose end dropped, " +
                    CountText(found.NumberOfSpurEdges, "edge", "edges") + FirstPlace(found.Spurs));
  }
}

void DescribeFlaws(
  const SurfaceMesh& surface, const SurfaceFeatures& features, std::vector<std::string>& warnings)
{
  for (const CornerFlaw flaw : { CornerFlaw::ManyCurves, CornerFlaw::AcuteCurves })
  {
    std::vector<Vec3> places;
    for (const FeatureCorner& corner : features.Corners)
    {
      if (corner.Flaw == flaw)
      {
        places.push_back(surface.Points[corner.Point]);
      }
    }
    if (!places.empty())
    {
      warnings.push_back(
        CountText(places.size(), "feature corner is", "feature corners are") + " not enforced: " +
        (flaw == CornerFlaw::ManyCurves ? "more than six curves meet"
                                        : "two curves meet at less than 30 degrees") +
        FirstPlace(places));
    }
  }
}

double LooseShareOf(const SurfaceMesh& surface, const SurfaceFeatures& features)
{
  double all = 0.0;
  double loose = 0.0;
  for (const FeatureCurve& curve : features.Curves)
  {
    double length = 0.0;
    for (std::size_t i = 1; i < curve.Points.size(); ++i)
    {
      length += (surface.Points[curve.Points[i]] - surface.Points[curve.Points[i - 1]]).norm();
    }
    all += length;
    loose += curve.LeftPatch == curve.RightPatch ? length : 0.0;
  }
  return all > 0.0 ? loose / all : 0.0;
}

/// Edges and corners that are asked for, before the graph is built.
class Selection
{
public:
  Selection(const SurfaceMesh& surface, const FeatureExtractionOptions& options,
    FeatureExtractionReport& report)
    : Surface(surface)
    , Options(options)
    , Report(report)
    , Graph(options.Graph)
  {
  }

  void Detect()
  {
    this->Edges = FindSharpEdges(this->Surface, this->Options.Detection, this->Report.Detection);
  }

  Status Annotate(const FeatureAnnotation& annotation);
  Status DropRedundant(SurfaceFeatures& features);
  Status Build(SurfaceFeatures& features)
  {
    return BuildSurfaceFeatures(
      this->Surface, this->Edges, this->Corners, this->Graph, features, this->Report.Graph);
  }

private:
  Status Remove(const std::vector<PointPair>& edges, std::vector<Index> corners);

  const SurfaceMesh& Surface;
  const FeatureExtractionOptions& Options;
  FeatureExtractionReport& Report;
  FeatureGraphOptions Graph;
  std::vector<PointPair> Edges; ///< ascending
  std::vector<Index> Corners;
};

Status Selection::Annotate(const FeatureAnnotation& annotation)
{
  // As edges of the surface, and checked, whatever is done with them.
  SurfaceFeatures named;
  const Status status = BuildSurfaceFeatures(this->Surface, annotation.Edges, annotation.Corners,
    FeatureGraphOptions(), named, this->Report.Graph);
  if (!status.Ok())
  {
    return status;
  }
  const std::vector<PointPair> edges = Sorted(FeatureEdges(named));
  if (this->Options.Mode == AnnotationMode::Remove)
  {
    return this->Remove(edges, annotation.Corners);
  }
  this->Edges.insert(this->Edges.end(), edges.begin(), edges.end());
  this->Edges = Sorted(this->Edges);
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
  this->Corners = annotation.Corners;
  if (this->Options.CleanUpAnnotation)
  {
    CleanFeatureEdges(this->Surface, this->Options.Detection, this->Edges, this->Report.Detection);
  }
  return status;
}

Status Selection::Remove(const std::vector<PointPair>& edges, std::vector<Index> corners)
{
  this->Edges = Without(Sorted(this->Edges), edges);
  if (corners.empty())
  {
    return Status();
  }
  // Kinks are listed and no longer found by angle: those that are taken away stay away.
  SurfaceFeatures features;
  const Status status = this->Build(features);
  this->Corners.clear();
  for (const FeatureCorner& corner : features.Corners)
  {
    this->Corners.push_back(corner.Point);
  }
  this->Corners = Without(this->Corners, Sorted(std::move(corners)));
  this->Graph.CornerAngle = 0.0;
  return status;
}
/// Until nothing changes: without a double a kink of the other curve is no corner any more.
Status Selection::DropRedundant(SurfaceFeatures& features)
{
  const double distance =
    this->Options.RedundantDistance * BoundingBox(this->Surface).Diagonal();
  for (;;)
  {
    const std::vector<Index> redundant = this->Graph.EnforceAll
                                           ? std::vector<Index>()
                                           : FindRedundantCurves(this->Surface, features, distance);
    if (redundant.empty())
    {
      return Status();
    }
    std::set<Index> left; // points that keep a curve
    std::vector<PointPair> dropped;
    for (Index c = 0; c < static_cast<Index>(features.Curves.size()); ++c)
    {
      const std::vector<Index>& points = features.Curves[c].Points;
      if (!std::binary_search(redundant.begin(), redundant.end(), c))
      {
        left.insert(points.begin(), points.end());
        continue;
      }
      this->Report.RedundantCurves.push_back(this->Surface.Points[points[points.size() / 2]]);
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        dropped.push_back({ points[i - 1], points[i] });
      }
    }
    std::set<Index> lost; // corners whose curves are all dropped
    for (const PointPair& edge : dropped)
    {
      for (Index v : edge)
      {
        if (left.count(v) == 0)
        {
          lost.insert(v);
        }
      }
    }
    this->Edges = Without(Sorted(this->Edges), Sorted(dropped));
    this->Corners = Without(Sorted(this->Corners), std::vector<Index>(lost.begin(), lost.end()));
    if (Status status = this->Build(features); !status.Ok())
    {
      return status;
    }
  }
}
} // namespace

Status ExtractFeatures(const SurfaceMesh& surface, const FeatureAnnotation* annotation,
  const FeatureExtractionOptions& options, SurfaceFeatures& features,
  FeatureExtractionReport& report)
{
  report = FeatureExtractionReport();
  features = SurfaceFeatures();
  Selection selection(surface, options, report);
  if (options.PreserveFeatures && (!annotation || options.Mode != AnnotationMode::Replace))
  {
    selection.Detect();
  }
  if (options.PreserveFeatures && annotation)
  {
    const Status status = selection.Annotate(*annotation);
    if (!status.Ok())
    {
      return status;
    }
  }
  Status status = selection.Build(features);
  if (status.Ok())
  {
    status = selection.DropRedundant(features);
  }
  DescribeCleanUp(report.Detection, report.Notes);
  if (!report.RedundantCurves.empty())
  {
    report.Notes.push_back(
      CountText(report.RedundantCurves.size(), "curve", "curves") +
      " dropped that can't be told from others beside" + FirstPlace(report.RedundantCurves));
  }
  DescribeFlaws(surface, features, report.Warnings);
  report.LooseShare = LooseShareOf(surface, features);
  if (report.LooseShare > DoubtfulShare && report.Detection.NumberOfSharpEdges > 0)
  {
    report.Warnings.push_back(
      "The features are doubtful: " + std::to_string(std::lround(100.0 * report.LooseShare)) +
      " % of their length bounds no patch. Scans and other organic shapes are best meshed without "
      "features; where creases fade out, a larger angle hysteresis closes them.");
  }
  return status;
}
} // namespace featurehex
