// SPDX-License-Identifier: BSD-3-Clause
#include "UcdWriter.h"

#include "SolverMeshes.h"

using namespace featurehex;

TEST(UcdWriter, RoundTrip)
{
  const SolverMesh mesh = TwoBodies();
  std::istringstream file(TextOf(mesh, WriteUcd));
  std::string line, word;
  std::getline(file, line);
  EXPECT_EQ(line[0], '#');
  std::size_t points = 0, cells = 0;
  int zeros[3];
  file >> points >> cells >> zeros[0] >> zeros[1] >> zeros[2];
  ASSERT_EQ(points, mesh.Points.size());
  EXPECT_EQ(cells, 2u + 10u + 8u);
  for (std::size_t i = 0; i < points; ++i)
  {
    std::size_t id = 0;
    Vec3 p;
    file >> id;
    for (int k = 0; k < 3; ++k)
    {
      file >> word;
      p[k] = std::stod(word);
    }
    EXPECT_EQ(id, i + 1);
    EXPECT_EQ(p, mesh.Points[i]);
  }
  std::map<std::pair<std::string, int>, int> counts;
  const std::map<std::string, int> lengths = { { "hex", 8 }, { "quad", 4 }, { "line", 2 } };
  for (std::size_t c = 0; c < cells; ++c)
  {
    std::size_t id = 0;
    int material = -1;
    file >> id >> material >> word;
    EXPECT_EQ(id, c + 1);
    ++counts[{ word, material }];
    for (int k = 0; k < lengths.at(word); ++k)
    {
      std::size_t node = 0;
      file >> node;
      ASSERT_TRUE(node >= 1 && node <= points);
      EXPECT_TRUE(word != "quad" || material != 1 || mesh.Points[node - 1].z() == 0.0);
    }
  }
  EXPECT_TRUE(file.good());
  EXPECT_EQ(counts, (std::map<std::pair<std::string, int>, int>{ { { "hex", 1 }, 1 },
                      { { "hex", 2 }, 1 }, { { "quad", 1 }, 1 }, { { "quad", 2 }, 1 },
                      { { "quad", 5 }, 8 }, { { "line", 1 }, 4 }, { { "line", 3 }, 4 } }));
}

TEST(UcdWriter, SaysWhatIsWrong)
{
  EXPECT_EQ(WriteUcd("/nowhere/x.ucd", TwoBodies()).Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteUcd("/nowhere/x.ucd", TwoBodies(20)).Code, StatusCode::InvalidMesh);
  EXPECT_EQ(WriteUcd("/nowhere/x.ucd", SolverMesh()).Code, StatusCode::EmptySurface);
  SolverMesh mesh = TwoBodies();
  mesh.Segments[0].Curve = -2;
  EXPECT_EQ(WriteUcd("/nowhere/x.ucd", mesh).Code, StatusCode::InvalidMesh);
}
