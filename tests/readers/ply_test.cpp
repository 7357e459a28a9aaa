#include "reading.hpp"

#include <bit>
#include <limits>

using namespace visibility;
using namespace visibility::test;

namespace {

std::string const header = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n";
std::string const rows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ascii(std::string const& face_properties, std::string const& faces)
{
  return "ply\nformat ascii 1.0\ncomment none\n" + header + face_properties + "end_header\n" + rows + faces;
}

/// Appends the low bytes of `bits`.
void put(std::string& out, std::uint64_t bits, int bytes, bool big)
{
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(bits >> (8 * (big ? bytes - 1 - i : i)));
}

}  // namespace

TEST_CASE("ply: ascii, objects by a face property in ascending order", "[readers][ply]")
{
  auto const text =
    ascii("property list uchar int vertex_indices\nproperty int building\n", "3 0 1 2 17\n3 0 2 3 -2\n4 0 1 2 3 17\n");
  Scene const s = read_ply(text);
  CHECK(names(s) == Names{"building -2", "building 17"});
  CHECK(s.objects[1].triangles.size() == 3);
}

TEST_CASE("ply: object, object_id and a named property; none is one object", "[readers][ply]")
{
  for (std::string const word : {"object", "object_id", "floor"}) {
    auto const text =
      ascii("property uchar " + word + "\nproperty list uchar int vertex_index\n", "1 3 0 1 2\n2 3 0 2 3\n1 3 0 1 3\n");
    ReadOptions options;
    if (word == "floor") {
      CHECK(names(read_ply(text)) == Names{"object 1"});
      options.object_property = word;
    }
    CHECK(names(read_ply(text, options)) == Names{word + " 1", word + " 2"});
  }
}

TEST_CASE("ply: binary of either byte order, every scalar type, other elements skipped", "[readers][ply]")
{
  for (bool const big : {false, true}) {
    std::string file =
      std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement camera 1\nproperty list short double pose\nelement vertex 3\nproperty double x\nproperty float y\n"
      "property short z\nproperty uchar a\nproperty char b\nproperty ushort c\nproperty uint d\nelement face 1\n"
      "property list ushort int vertex_indices\nproperty int building\nend_header\n";
    put(file, 1, 2, big);
    put(file, std::bit_cast<std::uint64_t>(0.5), 8, big);
    double const xs[] = {0.1, -1e300, 7};
    float const ys[] = {0.1f, 2, 3};
    int const zs[] = {-5, 300, 0};
    for (int i = 0; i < 3; ++i) {
      put(file, std::bit_cast<std::uint64_t>(xs[i]), 8, big);
      put(file, std::bit_cast<std::uint32_t>(ys[i]), 4, big);
      put(file, static_cast<std::uint64_t>(zs[i]), 2, big);
      put(file, 1, 1, big), put(file, 2, 1, big), put(file, 3, 2, big), put(file, 4, 4, big);
    }
    put(file, 3, 2, big);
    for (int i = 0; i < 3; ++i) put(file, static_cast<std::uint64_t>(i), 4, big);
    put(file, static_cast<std::uint64_t>(-9), 4, big);
    Scene const s = read_ply(file);
    CHECK(names(s) == Names{"building -9"});
    CHECK(s.vertices[0] == Point3d{0.1, static_cast<double>(0.1f), -5});
    CHECK(s.vertices[1] == Point3d{-1e300, 2, 300});
    for (std::size_t n = 0; n < file.size(); ++n) CHECK(refusal(file.substr(0, n), SceneFormat::ply) != "(was read)");
  }
}

TEST_CASE("ply: a claimed size is checked against the bytes present", "[readers][ply]")
{
  for (std::string const encoding : {"ascii", "binary_little_endian"}) {
    auto const message = refusal(
      "ply\nformat " + encoding +
        " 1.0\nelement vertex 1000000000\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4000000000\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n",
      SceneFormat::ply);
    CHECK(message.find("claims 1000000000 vertex") != std::string::npos);
  }
}
