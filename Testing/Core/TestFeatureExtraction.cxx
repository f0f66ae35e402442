// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureExtraction.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// Points by bits of their id: 1 x, 2 y, 4 z.
SurfaceMesh Cube()
{
  SurfaceMesh cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.Points.push_back(Vec3(i & 1, i >> 1 & 1, i >> 2));
  }
  cube.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return cube;
}

struct Extracted
{
  explicit Extracted(
    const FeatureExtractionOptions& options, const FeatureAnnotation* annotation = nullptr)
  {
    const Status status =
      ExtractFeatures(Cube(), annotation, options, this->Features, this->Report);
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
  SurfaceMesh flat = Cube();
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
    EXPECT_EQ(ExtractFeatures(Cube(), &annotation, options, features, report).Code,
      StatusCode::IndexOutOfRange);
    annotation = { {}, { 8 } };
    EXPECT_EQ(ExtractFeatures(Cube(), &annotation, options, features, report).Code,
      StatusCode::IndexOutOfRange);
  }
}
