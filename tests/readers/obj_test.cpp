#include "reading.hpp"

using namespace visibility;
using namespace visibility::test;

namespace {
std::string const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
}

TEST_CASE("obj: o and g start objects; a file without them is one object", "[readers][obj]")
{
  CHECK(names(read_obj(square + "f 1 2 3\n")) == Names{"object 1"});
  CHECK(names(read_obj(square + "o a\nf 1 2 3\no b\nf 1 3 4\n")) == Names{"a", "b"});
  CHECK(names(read_obj(square + "g a\nf 1 2 3\ng b c\nf 1 3 4\n")) == Names{"a", "b c"});
  CHECK(names(read_obj(square + "o a\nf 1 2 3\no a\nf 1 3 4\n")) == Names{"a", "a#2"});
}

TEST_CASE("obj: a group taken up again continues; within an o it is named after both", "[readers][obj]")
{
  Scene const s = read_obj(square + "g a\nf 1 2 3\ng b\nf 1 3 4\ng a\nf 2 3 4\n");
  CHECK(names(s) == Names{"a", "b"});
  CHECK(s.objects[0].triangles.size() == 2);
  CHECK(names(read_obj(square + "o h\ng w\nf 1 2 3\no k\ng w\nf 1 3 4\n")) == Names{"h/w", "k/w"});
}

TEST_CASE("obj: all forms of indices, negative ones from the latest vertex", "[readers][obj]")
{
  Scene const s = read_obj(square + "f 1/9 2/8/7 3//6\nf -4 -3 -2\nv 5 5 5\nf -1 1 2\n");
  REQUIRE(s.triangles.size() == 3);
  CHECK(s.triangles[0] == std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK(s.triangles[1] == s.triangles[0]);
  CHECK(s.triangles[2] == std::array<std::uint32_t, 3>{4, 0, 1});
}

TEST_CASE("obj: comments, CRLF, continued lines, tabs, appearance", "[readers][obj]")
{
  Scene const s =
    read_obj("# c\r\nv 0 0 0 # origin\r\nv\t1 0 \\\r\n 0\r\nv 1 1 0 0.5 0.5 0.5\r\nvt 0 0\r\nvn 0 0 1\r\ns off\r\n"
             "usemtl m\r\no house#2 # named\r\nf 1 2 \\\r\n3\r\n");
  CHECK(names(s) == Names{"house#2"});
  CHECK(s.triangles.size() == 1);
}

TEST_CASE("obj: coordinates are the nearest doubles", "[readers][obj]")
{
  Scene const s = read_obj("v 0.1 9007199254740993 1.00000000000000011102230246251565404236316680908203125\n"
                           "v +2.5e0 -1e-400 4.9406564584124654e-324\nv 1 1 .5\nf 1 2 3\n");
  CHECK(s.vertices[0] == Point3d{0.1, 9007199254740992.0, 1.0});  // both halfway cases go to even
  CHECK(s.vertices[1].y == 0);
  CHECK(s.vertices[1] == Point3d{2.5, 0, 4.9406564584124654e-324});
}

TEST_CASE("obj: concave polygons are triangulated inside, crossing ones left out", "[readers][obj]")
{
  Scene const s = read_obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
  CHECK(s.triangles.size() == 3);
  Scene const bow = read_obj(square + "f 1 3 2 4\nf 1 2 3\n");
  CHECK(bow.triangles.size() == 1);
  CHECK(has_note(bow, "1 polygons whose rings cross"));
}
