#include "hard_case.hpp"

#include <iterator>

namespace visibility::hard_cases {

void Stage::begin(std::string const& name)
{
  if (name == last_) return;
  builder_.begin_object(name);
  last_ = name;
}

Stage& Stage::box(std::string const& name, Box const& b)
{
  begin(name);
  builder_.add(b);
  return *this;
}

Stage& Stage::box(std::string const& name, Point2d const& low, Point2d const& high, double top)
{
  return box(name, Box{{low.x, low.y, 0}, {high.x, high.y, top}});
}

Stage& Stage::prism(std::string const& name, std::vector<Point2d> ring, double top)
{
  begin(name);
  builder_.add(Prism{{std::move(ring)}, 0, top});
  return *this;
}

Stage& Stage::curtain(std::string const& name, Point3d const& p, Point3d const& q, double bottom)
{
  begin(name);
  auto const a = builder_.add_vertex(p), b = builder_.add_vertex(q), c = builder_.add_vertex({q.x, q.y, bottom}),
             d = builder_.add_vertex({p.x, p.y, bottom});
  builder_.add_triangle(a, b, c);
  builder_.add_triangle(a, c, d);
  return *this;
}

Stage& Stage::triangle(std::string const& name, Point3d const& p, Point3d const& q, Point3d const& r)
{
  begin(name);
  auto const a = builder_.add_vertex(p), b = builder_.add_vertex(q), c = builder_.add_vertex(r);
  builder_.add_triangle(a, b, c);
  return *this;
}

Stage& Stage::ball(std::string const& name, Ball const& b)
{
  begin(name);
  builder_.add(b);
  return *this;
}

Cases all()
{
  Cases out;
  for (auto const kind : {grazing, abutting, collinear, coincident, slits, cyclic, far_offsets, extreme, slivers,
                          heights, cells, slanting, reguli, small}) {
    auto cases = kind();
    out.insert(out.end(), std::make_move_iterator(cases.begin()), std::make_move_iterator(cases.end()));
  }
  return out;
}

}  // namespace visibility::hard_cases
