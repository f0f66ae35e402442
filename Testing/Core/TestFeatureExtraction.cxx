// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureExtraction.h"

#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace featurehex;

namespace
{
struct Extracted
{
  explicit Extracted(
    const FeatureExtractionOptions& options, const FeatureAnnotation* annotation = nullptr)
  {
    const Status status =
      ExtractFeatures(CubeSurface(), annotation, options, this->Features, this->Report);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }
  std::array<std::size_t, 3> Counts() const
  {
    return { this->Features.Corners.size(), this->Features.Curves.size(),
      static_cast<std::size_t>(this->Features.NumberOfPatches) };
  }

  SurfaceFeatures Features;
  FeatureExtractionReport Report;
};

using Three = std::array<std::size_t, 3>;
} // namespace

TEST(FeatureExtraction, ByAngleOrNotAtAll)
{
  FeatureExtractionOptions options;
  EXPECT_EQ(Extracted(options).Counts(), (Three{ 8, 12, 6 }));
  options.PreserveFeatures = false;
  const FeatureAnnotation annotation = { { { 0, 1 } }, { 7 } };
  EXPECT_EQ(Extracted(options, &annotation).Counts(), (Three{ 0, 0, 1 }));
}

TEST(FeatureExtraction, Modes)
{
  FeatureExtractionOptions options;
  // A diagonal that the angle doesn't find.
  const FeatureAnnotation diagonal = { { { 3, 0 } }, {} };
  EXPECT_EQ(Extracted(options, &diagonal).Counts(), (Three{ 2, 1, 1 }));
  options.Mode = AnnotationMode::Add;
  EXPECT_EQ(Extracted(options, &diagonal).Counts(), (Three{ 8, 13, 7 }));
  options.Mode = AnnotationMode::Remove;
  EXPECT_EQ(Extracted(options, &diagonal).Counts(), (Three{ 8, 12, 6 }));
  const FeatureAnnotation edge = { { { 1, 0 } }, { 1 } };
  EXPECT_EQ(Extracted(options, &edge).Counts(), (Three{ 7, 10, 5 }));
  const FeatureAnnotation empty;
  EXPECT_EQ(Extracted(options, &empty).Counts(), (Three{ 8, 12, 6 }));
  options.Mode = AnnotationMode::Replace;
  EXPECT_EQ(Extracted(options, &empty).Counts(), (Three{ 0, 0, 1 }));
}

TEST(FeatureExtraction, AnnotationsAreCleanedOnRequest)
{
  const FeatureAnnotation crumb = { { { 0, 1 } }, {} };
  FeatureExtractionOptions options;
  EXPECT_EQ(Extracted(options, &crumb).Counts(), (Three{ 2, 1, 1 }));
  options.CleanUpAnnotation = true;
  const Extracted cleaned(options, &crumb);
  EXPECT_EQ(cleaned.Counts(), (Three{ 0, 0, 1 }));
  ASSERT_EQ(cleaned.Report.Notes.size(), 1u);
  EXPECT_NE(cleaned.Report.Notes[0].find("1 short chain with a loose end dropped, 1 edge, the "
                                         "first at (0.5, 0, 0)."),
    std::string::npos)
    << cleaned.Report.Notes[0];
}

TEST(FeatureExtraction, FlawsAreWarnings)
{
  // The diagonal and its neighbours leave point 0 at 45 degrees; with five curves.
  const FeatureAnnotation all = { { { 0, 1 }, { 0, 2 }, { 0, 4 }, { 0, 3 }, { 0, 5 }, { 0, 6 } },
    {} };
  FeatureExtractionOptions options;
  EXPECT_TRUE(Extracted(options, &all).Report.Warnings.empty());
  SurfaceMesh flat = CubeSurface();
  for (Vec3& p : flat.Points)
  {
    p[1] *= 0.4; // the diagonal leaves at 22 degrees
  }
  SurfaceFeatures features;
  FeatureExtractionReport report;
  ASSERT_TRUE(ExtractFeatures(flat, &all, options, features, report).Ok());
  ASSERT_EQ(report.Warnings.size(), 1u);
  EXPECT_NE(
    report.Warnings[0].find("1 feature corner is not enforced: two curves meet at less than "
                            "30 degrees, the first at (0, 0, 0)."),
    std::string::npos)
    << report.Warnings[0];
  options.Graph.EnforceAll = true;
  ASSERT_TRUE(ExtractFeatures(flat, &all, options, features, report).Ok());
  EXPECT_TRUE(report.Warnings.empty());
}

TEST(FeatureExtraction, LooseFeaturesAreDoubtful)
{
  // A tent whose ridge fades out; the rims bound patches.
  SurfaceMesh tent;
  for (int i = 0; i < 8; ++i)
  {
    const double height = i < 5 ? 0.5 : 0.05;
    tent.Points.insert(tent.Points.end(), { Vec3(i, -1, 0), Vec3(i, 0, height), Vec3(i, 1, 0) });
  }
  for (Index a = 0; a < 21; a += 3)
  {
    const Index b = a + 3;
    tent.Triangles.insert(
      tent.Triangles.end(), { { a, b, b + 1 }, { a, b + 1, a + 1 }, { a + 1, b + 1, b + 2 },
                              { a + 1, b + 2, a + 2 }, { a, a + 2, b + 2 }, { a, b + 2, b } });
  }
  tent.Triangles.push_back({ 0, 1, 2 });
  tent.Triangles.push_back({ 21, 23, 22 });
  FeatureExtractionOptions options;
  SurfaceFeatures features;
  FeatureExtractionReport report;
  ASSERT_TRUE(ExtractFeatures(tent, nullptr, options, features, report).Ok());
  EXPECT_GT(report.LooseShare, 0.1);
  EXPECT_LT(report.LooseShare, 0.4);
  const auto doubtful = [&]
  {
    return std::any_of(report.Warnings.begin(), report.Warnings.end(),
      [](const std::string& text) { return text.find("doubtful") != std::string::npos; });
  };
  EXPECT_FALSE(doubtful());
  // The ridge alone, found and not given: all else is taken away.
  FeatureAnnotation rims = { { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 21, 22 }, { 22, 23 }, { 21, 23 } },
    {} };
  for (Index a = 0; a < 21; a += 3)
  {
    rims.Edges.push_back({ a, a + 3 });
    rims.Edges.push_back({ a + 2, a + 5 });
  }
  options.Mode = AnnotationMode::Remove;
  ASSERT_TRUE(ExtractFeatures(tent, &rims, options, features, report).Ok());
  EXPECT_GT(report.LooseShare, 0.5);
  EXPECT_TRUE(doubtful());
  options.Mode = AnnotationMode::Replace;
  const FeatureAnnotation ridge = { { { 1, 4 }, { 4, 7 }, { 7, 10 } }, {} };
  ASSERT_TRUE(ExtractFeatures(tent, &ridge, options, features, report).Ok());
  EXPECT_EQ(report.LooseShare, 1.0);
  EXPECT_FALSE(doubtful()); // somebody wants it
}

TEST(FeatureExtraction, ErrorsOfTheAnnotation)
{
  SurfaceFeatures features;
  FeatureExtractionReport report;
  FeatureExtractionOptions options;
  for (const AnnotationMode mode :
    { AnnotationMode::Replace, AnnotationMode::Add, AnnotationMode::Remove })
  {
    options.Mode = mode;
    FeatureAnnotation annotation = { { { 0, 7 } }, {} };
    EXPECT_EQ(ExtractFeatures(CubeSurface(), &annotation, options, features, report).Code,
      StatusCode::IndexOutOfRange);
    annotation = { {}, { 8 } };
    EXPECT_EQ(ExtractFeatures(CubeSurface(), &annotation, options, features, report).Code,
      StatusCode::IndexOutOfRange);
  }
}
