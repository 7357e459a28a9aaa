// Wavefront OBJ. Not through tinyobjloader or Assimp: both hand out single precision (tinyobjloader in double mode
// still parses by repeated multiplication, off by an ulp or more), and the input of an exact library is the nearest
// double. What the format asks of a reader of geometry fits on two pages.
#include "numbers.hpp"
#include "polygon_triangulation.hpp"
#include "readers.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace visibility::readers {

namespace {

/// Words that may occur and do not matter here: appearance, free-form curves, display attributes.
constexpr std::string_view ignored_words[] = {
  "vt",   "vn",   "vp",     "s",     "mg",       "usemtl",   "mtllib",     "usemap",    "maplib",
  "l",    "p",    "lod",    "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "deg",
  "bmat", "step", "cstype", "curv",  "curv2",    "surf",     "parm",       "trim",      "hole",
  "scrv", "sp",   "end",    "con",   "ctech",    "stech",    "call",       "csh"};
constexpr std::string_view unread_shapes[] = {"l", "p", "curv", "surf"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view trim(std::string_view s)
{
  while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
  return s;
}

std::string_view take_word(std::string_view& line)
{
  line = trim(line);
  auto const end = std::ranges::find_if(line, is_blank) - line.begin();
  auto const word = line.substr(0, static_cast<std::size_t>(end));
  line.remove_prefix(word.size());
  return word;
}

/// Logical lines: without comments and line ends, continued lines joined.
class Lines {
public:
  explicit Lines(std::string_view bytes) : rest_(bytes) {}
  std::size_t number() const { return number_; }  ///< of the first physical line of the latest logical one

  bool next(std::string_view& line)
  {
    if (rest_.empty()) return false;
    number_ = next_number_;
    line = physical();
    if (!line.ends_with('\\')) return true;
    joined_.clear();
    for (; line.ends_with('\\'); line = rest_.empty() ? std::string_view() : physical())
      (joined_ += line.substr(0, line.size() - 1)) += ' ';
    line = joined_ += line;
    return true;
  }

private:
  std::string_view physical()
  {
    auto const end = std::min(rest_.find('\n'), rest_.size());
    auto line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++next_number_;
    // A '#' within a word belongs to it: names like "house#2" exist.
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
      if (at == 0 || is_blank(line[at - 1])) {
        line = line.substr(0, at);
        break;
      }
    return trim(line);
  }

  std::string_view rest_;
  std::size_t number_ = 0, next_number_ = 1;
  std::string joined_;
};

class ObjReader {
public:
  ObjReader(std::string_view bytes, std::string const& source) : lines_(bytes), source_(source) {}

  Scene read()
  {
    for (std::string_view line; lines_.next(line);) statement(line);
    SceneBuilder builder(source_);
    for (auto const& v : vertices_) builder.add_vertex(v);
    for (auto& o : objects_) {
      builder.begin_object(o.name);
      for (auto const& t : o.triangles) builder.add_triangle(t[0], t[1], t[2]);
      o.triangles = {};
    }
    dropped_.note(builder);
    if (shapes_ > 0) builder.note(std::to_string(shapes_) + " lines, points and free-form shapes left out");
    return builder.finish();
  }

private:
  struct ObjectTriangles {
    std::string name;
    std::vector<IndexTriangle> triangles;
  };

  [[noreturn]] void bad(std::string const& what) const
  {
    auto const where = "line " + std::to_string(lines_.number());
    fail(source_, objects_.empty() ? where : where + ", object '" + current().name + "'", what);
  }

  ObjectTriangles const& current() const { return objects_[current_]; }
  ObjectTriangles& current()
  {
    if (objects_.empty()) start("object 1");
    return objects_[current_];
  }

  void statement(std::string_view line)
  {
    auto const word = take_word(line);
    if (word.empty()) return;
    if (word == "v")
      vertex(line);
    else if (word == "f" || word == "fo")
      face(line);
    else if (word == "o") {
      object_ = name(line);
      groups_.clear();
      start(object_);
    } else if (word == "g")
      group(name(line));
    else if (std::ranges::find(ignored_words, word) == std::end(ignored_words))
      bad("unknown statement '" + std::string(word.substr(0, 40)) + "'; is this an OBJ file?");
    else
      shapes_ += std::ranges::find(unread_shapes, word) != std::end(unread_shapes);
  }

  std::string name(std::string_view rest) const
  {
    auto const given = trim(rest);
    return given.empty() ? "object " + std::to_string(objects_.size() + 1) : printable(given);
  }

  void start(std::string name)
  {
    current_ = objects_.size();
    objects_.push_back({std::move(name), {}});
  }

  /// A group taken up again continues; within an `o` it is named after both.
  void group(std::string const& given)
  {
    if (auto const it = groups_.find(given); it != groups_.end()) {
      current_ = it->second;
      return;
    }
    start(object_.empty() || object_ == given ? given : object_ + "/" + given);
    groups_[given] = current_;
  }

  void vertex(std::string_view line)
  {
    double c[3];
    for (double& x : c) {
      auto const word = take_word(line);
      auto const value = parse_double(word);
      if (!value) bad("a vertex needs three numbers, not '" + std::string(word.substr(0, 40)) + "'");
      if (!std::isfinite(*value)) bad("a coordinate is not finite: '" + std::string(word.substr(0, 40)) + "'");
      x = *value;
    }
    vertices_.push_back({c[0], c[1], c[2]});
  }

  /// "7", "7/1", "7//3", "7/1/3" or the same with negative numbers, which count back from the latest vertex.
  VertexIndex corner(std::string_view word) const
  {
    long index = 0;
    auto const r = std::from_chars(word.data(), word.data() + word.size(), index);
    bool const well_formed = r.ec == std::errc() && (r.ptr == word.data() + word.size() || *r.ptr == '/') &&
                             word.find_first_not_of("0123456789-/") == std::string_view::npos;
    if (!well_formed)
      bad("'" + std::string(word.substr(0, 40)) + "' is not a vertex of a face (expected like 7, 7/1 or 7/1/3)");
    auto const count = static_cast<long>(vertices_.size());
    long const at = index < 0 ? count + index : index - 1;
    if (index == 0 || at < 0 || at >= count)
      bad("a face names vertex " + std::to_string(index) + ", but " + std::to_string(count) + " are defined before it");
    return static_cast<VertexIndex>(at);
  }

  void face(std::string_view line)
  {
    auto& ring = rings_[0];
    ring.clear();
    for (auto word = take_word(line); !word.empty(); word = take_word(line)) ring.push_back(corner(word));
    if (ring.size() < 3) bad("a face needs three vertices or more");
    if (ring.size() > 3) drop_repeats(vertices_, ring);
    dropped_.count(triangulate(vertices_, rings_, current().triangles));
  }

  Lines lines_;
  std::string const& source_;
  std::vector<Point3d> vertices_;
  std::vector<ObjectTriangles> objects_;
  std::size_t current_ = 0;
  std::string object_;                         // the latest `o`
  std::map<std::string, std::size_t> groups_;  // of that `o`
  std::vector<std::vector<VertexIndex>> rings_{1};
  DroppedPolygons dropped_;
  std::size_t shapes_ = 0;
};

}  // namespace

Scene read_obj(std::string_view bytes, std::string const& source) { return ObjReader(bytes, source).read(); }

}  // namespace visibility::readers
