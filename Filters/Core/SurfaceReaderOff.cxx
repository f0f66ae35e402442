// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFormats.h"

namespace featurehex
{
namespace
{
/// Object File Format: [C][N][ST]OFF, counts, one line a point, one line a face.
class OffParser
{
public:
  OffParser(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
    : Scanner(bytes)
    , Builder(name, "line", surface)
  {
  }

  Status Parse()
  {
    Status status = this->Header();
    for (std::int64_t i = 0; i < this->Points && status.Ok(); ++i)
    {
      status = this->Point();
    }
    for (std::int64_t i = 0; i < this->Faces && status.Ok(); ++i)
    {
      status = this->Face();
    }
    return status.Ok() ? this->Builder.Finish() : status;
  }

private:
  Status Error(const std::string& what)
  {
    return this->Builder.ParseError(this->Scanner.Line(), what);
  }

  Status Header()
  {
    std::string_view word;
    this->Scanner.Word(word);
    for (std::string_view prefix : { "ST", "C", "N" })
    {
      if (word.substr(0, prefix.size()) == prefix)
      {
        word.remove_prefix(prefix.size());
      }
    }
    if (word != "OFF")
    {
      return this->Error("the file starts with " + Quoted(word) +
                         ", not with \"OFF\"; four- and n-dimensional OFF files are not read.");
    }
    if (!this->Scanner.Word(word) || !ParseInteger(word, this->Points) || this->Points < 0 ||
        !this->Scanner.IntegerOnLine(this->Faces) || this->Faces < 0)
    {
      return this->Error(
        Quoted(word) +
        " where the numbers of points and faces are expected (binary OFF files are not read).");
    }
    this->Scanner.SkipLine();
    // The shortest point is "0 0 0" and a line end, the shortest face "3 0 0 0".
    const std::int64_t room = static_cast<std::int64_t>(this->Scanner.Remaining()) + 1;
    if (this->Points > room / 6 || this->Faces > room / 8 ||
        6 * this->Points + 8 * this->Faces > room)
    {
      return this->Error("truncated: the header promises " + std::to_string(this->Points) +
                         " points and " + std::to_string(this->Faces) + " faces, " +
                         std::to_string(room - 1) + " bytes follow.");
    }
    this->Builder.ReservePoints(this->Points);
    this->Builder.ReserveTriangles(this->Faces);
    return {};
  }

  Status Point()
  {
    Vec3 point;
    std::string_view word;
    bool good = this->Scanner.Word(word) && ParseReal(word, point[0]);
    for (int i = 1; i < 3 && good; ++i)
    {
      good = this->Scanner.WordOnLine(word) && ParseReal(word, point[i]);
    }
    if (!good)
    {
      return this->Bad(word, "a point with three coordinates");
    }
    this->Builder.AddPoint(point);
    this->Scanner.SkipLine();
    return {};
  }

  Status Face()
  {
    std::string_view word;
    std::int64_t count = 0;
    if (!this->Scanner.Word(word) || !ParseInteger(word, count))
    {
      return this->Bad(word, "a face");
    }
    if (count < 3)
    {
      return this->Error("a face needs at least three points, not " + std::to_string(count) + ".");
    }
    this->Builder.BeginPolygon(this->Scanner.Line());
    for (std::int64_t i = 0; i < count; ++i)
    {
      std::int64_t id = 0;
      if (!this->Scanner.WordOnLine(word) || !ParseInteger(word, id))
      {
        return this->Bad(word, "a face with " + std::to_string(count) + " point ids");
      }
      if (id >= this->Builder.NumberOfPoints() || !this->Builder.AddCorner(id))
      {
        return this->Builder.IndexError(id, this->Scanner.Line());
      }
    }
    this->Scanner.SkipLine();
    return {};
  }

  Status Bad(std::string_view word, const std::string& expected)
  {
    if (word.empty() && this->Scanner.Remaining() == 0)
    {
      return this->Error("truncated: the file ends where " + expected + " is expected.");
    }
    return this->Error((word.empty() ? std::string("the line ends") : Quoted(word)) + " where " +
                       expected + " is expected.");
  }

  TextScanner Scanner;
  SurfaceBuilder Builder;
  std::int64_t Points = 0;
  std::int64_t Faces = 0;
};
} // namespace

Status ParseOff(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
{
  return OffParser(bytes, name, surface).Parse();
}
} // namespace featurehex
