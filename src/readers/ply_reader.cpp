#include "numbers.hpp"
#include "ply_header.hpp"
#include "polygon_triangulation.hpp"
#include "readers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace visibility::readers {

namespace {

/// Takes values one after the other, whatever the encoding. Every type of PLY fits in a double exactly; a number in
/// ascii becomes the nearest double, also where the header says `float`: rounding it twice would only lose.
class Values {
public:
  Values(std::string_view bytes, PlyHeader const& header, std::string const& source)
    : rest_(bytes.substr(header.length)), encoding_(header.encoding), line_(header.lines), source_(source)
  {
  }

  double take(PlyType type, std::string_view what)
  {
    return encoding_ == PlyEncoding::ascii ? take_ascii(type, what) : take_binary(type, what);
  }
  std::size_t bytes_left() const { return rest_.size(); }

  [[noreturn]] void bad(std::string const& what) const
  {
    fail(source_, encoding_ == PlyEncoding::ascii ? "line " + std::to_string(line_ + 1) + ", " + where : where, what);
  }
  std::string where;  ///< "vertex 7": what is being read, for messages

private:
  double take_ascii(PlyType type, std::string_view what)
  {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t' || rest_[0] == '\r' || rest_[0] == '\n')) {
      line_ += rest_[0] == '\n';
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) bad("the file ends before its " + std::string(what) + "; it is truncated");
    auto const word = rest_.substr(0, std::min(rest_.find_first_of(" \t\r\n"), rest_.size()));
    auto const value = parse_double(word);
    if (!value || (is_integer(type) && *value != std::floor(*value)))
      bad("'" + std::string(word.substr(0, 40)) + "' is not a value for " + std::string(what));
    rest_.remove_prefix(word.size());
    return *value;
  }

  double take_binary(PlyType type, std::string_view what)
  {
    std::size_t const n = size_of(type);
    if (rest_.size() < n) bad("the file ends before its " + std::string(what) + "; it is truncated");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t const at = encoding_ == PlyEncoding::little_endian ? n - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(rest_[at]);
    }
    rest_.remove_prefix(n);
    switch (type) {
    case PlyType::int8: return static_cast<std::int8_t>(bits);
    case PlyType::uint8: return static_cast<std::uint8_t>(bits);
    case PlyType::int16: return static_cast<std::int16_t>(bits);
    case PlyType::uint16: return static_cast<std::uint16_t>(bits);
    case PlyType::int32: return static_cast<std::int32_t>(bits);
    case PlyType::uint32: return static_cast<std::uint32_t>(bits);
    case PlyType::float32: return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case PlyType::float64: return std::bit_cast<double>(bits);
    }
    return 0;
  }

  std::string_view rest_;
  PlyEncoding encoding_;
  std::size_t line_;  // line ends passed
  std::string const& source_;
};

class PlyReader {
public:
  PlyReader(std::string_view bytes, std::string const& source, ReadOptions const& options)
    : header_(parse_ply_header(bytes, source)), values_(bytes, header_, source), source_(source), options_(options)
  {
  }

  Scene read()
  {
    for (auto const& e : header_.elements) {
      if (e.properties.empty()) continue;
      if (e.name == "vertex")
        read_vertices(e);
      else if (e.name == "face")
        read_faces(e);
      else
        skip(e);
    }
    return build();
  }

private:
  /// Reads one row; use(property, position of a list item or 0, value) for each value.
  template <class Use>
  void read_row(PlyElement const& e, Use&& use)
  {
    for (std::size_t p = 0; p < e.properties.size(); ++p) {
      auto const& property = e.properties[p];
      if (!property.is_list) {
        use(p, values_.take(property.type, property.name));
        continue;
      }
      double const n = values_.take(property.count_type, property.name);
      if (n < 0 || n > static_cast<double>(values_.bytes_left()))
        values_.bad("list '" + property.name + "' claims " + shortest(n) + " items, more than the file holds");
      for (double i = 0; i < n; ++i) use(p, values_.take(property.type, property.name));
    }
  }

  std::size_t require(PlyElement const& e, std::initializer_list<std::string_view> names, bool list) const
  {
    for (auto const name : names)
      if (auto const p = e.find(name); p < e.properties.size() && e.properties[p].is_list == list) return p;
    fail(source_, "element " + e.name,
         "has no " + std::string(list ? "list " : "") + "property '" + std::string(*names.begin()) +
           "'; add it to the file");
  }

  void read_vertices(PlyElement const& e)
  {
    std::size_t const axes[] = {require(e, {"x"}, false), require(e, {"y"}, false), require(e, {"z"}, false)};
    vertices_.reserve(vertices_.size() + e.count);
    std::vector<double> row(e.properties.size());
    for (std::uint64_t i = 0; i < e.count; ++i) {
      values_.where = "vertex " + std::to_string(i);
      read_row(e, [&](std::size_t p, double value) { row[p] = value; });
      Point3d const v{row[axes[0]], row[axes[1]], row[axes[2]]};
      if (!is_finite(v)) values_.bad("a coordinate is not finite");
      vertices_.push_back(v);
    }
  }

  /// The property that tells objects apart; none: properties.size().
  std::size_t object_property(PlyElement const& e) const
  {
    if (!options_.object_property.empty()) {
      auto const p = e.find(options_.object_property);
      if (p == e.properties.size() || e.properties[p].is_list) {
        std::string names;
        for (auto const& other : e.properties)
          if (!other.is_list) (names += names.empty() ? "" : ", ") += other.name;
        fail(source_, "element face",
             "has no property '" + options_.object_property +
               "' for objects; it has: " + (names.empty() ? "none" : names));
      }
      return p;
    }
    for (auto const name : {"building", "object", "object_id"})
      if (auto const p = e.find(name); p < e.properties.size() && !e.properties[p].is_list) return p;
    return e.properties.size();
  }

  void read_faces(PlyElement const& e)
  {
    std::size_t const corners = require(e, {"vertex_indices", "vertex_index"}, true);
    std::size_t const object = object_property(e);
    if (object < e.properties.size()) object_word_ = e.properties[object].name;
    for (std::uint64_t i = 0; i < e.count; ++i) {
      values_.where = "face " + std::to_string(i);
      double key = 0;
      auto const first = corners_.size();
      read_row(e, [&](std::size_t p, double value) {
        if (p == corners) {
          if (!(value >= 0 && value < UINT32_MAX)) values_.bad("a face names vertex " + shortest_or_nan(value));
          corners_.push_back(static_cast<VertexIndex>(value));
        }
        if (p == object) key = value;
      });
      if (std::isnan(key)) values_.bad("property '" + object_word_ + "' is not a number");
      faces_.push_back({key + 0.0, first, corners_.size()});  // -0 and 0 are one object
    }
  }

  void skip(PlyElement const& e)
  {
    for (std::uint64_t i = 0; i < e.count; ++i) {
      values_.where = e.name + " " + std::to_string(i);
      read_row(e, [](std::size_t, double) {});
    }
  }

  static std::string shortest_or_nan(double value) { return std::isfinite(value) ? shortest(value) : "NaN"; }

  std::string object_name(double key) const
  {
    if (object_word_.empty()) return "object 1";
    return printable(object_word_) + " " +
           (std::isinf(key) ? (key < 0 ? "-inf" : "inf")
            : key == 0      ? "0"
                            : shortest(key));
  }

  Scene build()
  {
    if (faces_.empty()) fail(source_, {}, "has no faces; a point cloud hides nothing, give a mesh");
    SceneBuilder builder(source_);
    for (auto const& v : vertices_) builder.add_vertex(v);
    std::ranges::stable_sort(faces_, {}, &Face::object);
    DroppedPolygons dropped;
    std::vector<std::vector<VertexIndex>> rings(1);
    std::vector<IndexTriangle> triangles;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      auto const& f = faces_[i];
      if (i == 0 || faces_[i - 1].object != f.object) builder.begin_object(object_name(f.object));
      auto& ring = rings[0];
      ring.assign(corners_.begin() + static_cast<std::ptrdiff_t>(f.first),
                  corners_.begin() + static_cast<std::ptrdiff_t>(f.last));
      for (auto const v : ring)
        if (v >= vertices_.size())
          fail(source_, "object '" + object_name(f.object) + "'",
               "a face names vertex " + std::to_string(v) + ", but there are " + std::to_string(vertices_.size()));
      if (ring.size() > 3) drop_repeats(vertices_, ring);
      triangles.clear();
      dropped.count(triangulate(vertices_, rings, triangles));
      for (auto const& t : triangles) builder.add_triangle(t[0], t[1], t[2]);
    }
    dropped.note(builder);
    return builder.finish();
  }

  struct Face {
    double object;
    std::size_t first, last;  // into corners_
  };

  PlyHeader header_;
  Values values_;
  std::string const& source_;
  ReadOptions const& options_;
  std::vector<Point3d> vertices_;
  std::vector<VertexIndex> corners_;
  std::vector<Face> faces_;
  std::string object_word_;
};

}  // namespace

Scene read_ply(std::string_view bytes, std::string const& source, ReadOptions const& options)
{
  return PlyReader(bytes, source, options).read();
}

}  // namespace visibility::readers
