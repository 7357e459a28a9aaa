#include "writers.hpp"

#include "readers/numbers.hpp"
#include "readers/readers.hpp"

#include <cstdio>

namespace visibility::writers {

using readers::shortest;

namespace {

/// The members of a JSON object or the items of a list, with commas between.
class List {
public:
  List(std::ostream& out, char open, char close) : out_(out), close_(close) { out_ << open; }
  ~List() { out_ << close_; }
  std::ostream& next()
  {
    if (!first_) out_ << ',';
    first_ = false;
    return out_;
  }

private:
  std::ostream& out_;
  char close_;
  bool first_ = true;
};

template <class Range, class Write>
void write_list(List& members, char const* key, Range first, Range last, Write&& write)
{
  if (first == last) return;
  List list(members.next() << '"' << key << "\":", '[', ']');
  for (auto i = first; i != last; ++i) write(list, i);
}

void put(List& list, Point3d const& p)
{
  for (double const c : {p.x, p.y, p.z}) list.next() << shortest(c);
}

void write_prism(std::ostream& out, Prism const& p)
{
  List members(out, '{', '}');
  members.next() << "\"bottom\":" << shortest(p.bottom);
  members.next() << "\"top\":" << shortest(p.top);
  List rings(members.next() << "\"rings\":", '[', ']');
  for (auto const& r : p.rings) {
    List ring(rings.next(), '[', ']');
    for (auto const& v : r) ring.next() << shortest(v.x), ring.next() << shortest(v.y);
  }
}

void write_polyhedron(std::ostream& out, ConvexPolyhedron const& p)
{
  List members(out, '{', '}');
  {
    List vertices(members.next() << "\"vertices\":", '[', ']');
    for (auto const& v : p.vertices) put(vertices, v);
  }
  List facets(members.next() << "\"facets\":", '[', ']');
  for (auto const& f : p.facets)
    for (auto const v : f.vertices) facets.next() << v;
}

void write_object(std::ostream& out, Scene const& scene, Object const& o)
{
  List members(out, '{', '}');
  members.next() << "\"name\":" << json_string(o.name);
  write_list(members, "boxes", o.boxes.first, o.boxes.last, [&](List& list, std::uint32_t i) {
    put(list, scene.boxes[i].min);
    put(list, scene.boxes[i].max);
  });
  write_list(members, "balls", o.balls.first, o.balls.last, [&](List& list, std::uint32_t i) {
    put(list, scene.balls[i].centre);
    list.next() << shortest(scene.balls[i].radius);
  });
  write_list(members, "prisms", o.prisms.first, o.prisms.last,
             [&](List& list, std::uint32_t i) { write_prism(list.next(), scene.prisms[i]); });
  write_list(members, "polyhedra", o.polyhedra.first, o.polyhedra.last,
             [&](List& list, std::uint32_t i) { write_polyhedron(list.next(), scene.polyhedra[i]); });
  write_list(members, "triangles", o.triangles.first, o.triangles.last, [&](List& list, std::uint32_t i) {
    for (auto const v : scene.triangles[i]) list.next() << v;
  });
}

}  // namespace

std::string json_string(std::string const& text)
{
  std::string out = "\"";
  for (char const c : text)
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      out += escape;
    } else
      out += c;
  return out += '"';
}

void write_native(std::ostream& out, Scene const& scene)
{
  out << "{\"format\":\"visibility-scene/1\",\n\"source\":" << json_string(scene.source) << ",\n\"notes\":[";
  for (std::size_t i = 0; i < scene.notes.size(); ++i) out << (i > 0 ? "," : "") << json_string(scene.notes[i]);
  out << "],\n\"objects\":[";
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    out << (i > 0 ? ",\n" : "\n");
    write_object(out, scene, scene.objects[i]);
  }
  out << "],\n\"vertices\":";
  {
    List vertices(out, '[', ']');
    for (auto const& v : scene.vertices) put(vertices, v);
  }
  out << "}\n";
}

}  // namespace visibility::writers
