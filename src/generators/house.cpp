#include "house.hpp"

#include "mesh.hpp"

namespace visibility::generators {

namespace {

using Index = std::uint32_t;

/// Builds one house. Columns are counted around the plan, counterclockwise from the corner (-x, -y); column c is the
/// left edge of bay c seen from outside.
class Builder {
public:
  Builder(SceneBuilder& scene, House const& house, Placement const& placement)
    : scene_(scene), h_(house), placement_(placement), around_(2 * (house.bays_along + house.bays_across))
  {
  }

  void build()
  {
    for (Index row = 0; row <= h_.floors; ++row)
      for (Index c = 0; c < around_; ++c) grid_.push_back(vertex(on_wall(c, 0, row * h_.storey, 0)));
    for (Index row = 0; row < h_.floors; ++row)
      for (Index c = 0; c < around_; ++c) h_.window() ? add_window(c, row) : add_blank(c, row);
    add_roof();
    add_floor();
    for (auto const& box : h_.chimneys) add_chimney(box);
  }

private:
  Index vertex(Point3d const& p) { return scene_.add_vertex(placement_(p)); }
  Index at(Index column, Index row) const { return grid_[row * around_ + column % around_]; }
  void quad(Index a, Index b, Index c, Index d)
  {
    scene_.add_triangle(a, b, c);
    scene_.add_triangle(a, c, d);
  }

  /// The point `along` (0 to 1) of the way through the bay, at height z, `inward` behind the wall.
  Point3d on_wall(Index column, double along, double z, double inward) const
  {
    double const x = h_.length / 2, y = h_.width / 2;
    auto const part = [along](Index bay, Index bays, double side) { return -side + (bay + along) / bays * 2 * side; };
    Index const nx = h_.bays_along, ny = h_.bays_across;
    if (column < nx) return {part(column, nx, x), -y + inward, z};
    if (column < nx + ny) return {x - inward, part(column - nx, ny, y), z};
    if (column < 2 * nx + ny) return {-part(column - nx - ny, nx, x), y - inward, z};
    return {-x + inward, -part(column - 2 * nx - ny, ny, y), z};
  }

  void add_blank(Index c, Index row) { quad(at(c, row), at(c + 1, row), at(c + 1, row + 1), at(c, row + 1)); }

  void add_window(Index c, Index row)
  {
    std::array<Index, 4> const cell{at(c, row), at(c + 1, row), at(c + 1, row + 1), at(c, row + 1)};
    double const low = (row + 0.3) * h_.storey, high = (row + 0.8) * h_.storey;
    std::array<Index, 4> frame{}, pane{};
    for (auto [corners, inward] : {std::pair(&frame, 0.0), std::pair(&pane, h_.recess)})
      *corners = {vertex(on_wall(c, 0.3, low, inward)), vertex(on_wall(c, 0.7, low, inward)),
                  vertex(on_wall(c, 0.7, high, inward)), vertex(on_wall(c, 0.3, high, inward))};
    for (std::size_t i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4) {
      quad(cell[i], cell[j], frame[j], frame[i]);
      quad(frame[i], frame[j], pane[j], pane[i]);
    }
    quad(pane[0], pane[1], pane[2], pane[3]);
  }

  /// Every stretch of the eaves goes to one end of the ridge; on the long sides the stretch in the middle changes over.
  void add_roof()
  {
    double const eaves = h_.floors * h_.storey, end = h_.length / 2 - h_.hip;
    Index const west = vertex({-end, 0, eaves + h_.roof}), east = vertex({end, 0, eaves + h_.roof});
    Index const nx = h_.bays_along, ny = h_.bays_across, top = h_.floors;
    auto const slope = [&](Index first, Index last, Index ridge) {
      for (Index c = first; c < last; ++c) scene_.add_triangle(at(c, top), at(c + 1, top), ridge);
    };
    Index const south = nx / 2, north = nx + ny + (nx + 1) / 2;
    slope(0, south, west);
    scene_.add_triangle(at(south, top), east, west);
    slope(south, north, east);
    scene_.add_triangle(at(north, top), west, east);
    slope(north, around_, west);
  }

  void add_floor()
  {
    Index const middle = vertex({0, 0, 0});
    for (Index c = 0; c < around_; ++c) scene_.add_triangle(at(c + 1, 0), at(c, 0), middle);
  }

  void add_chimney(Box const& box)
  {
    auto corners = box.corners();
    for (auto& p : corners) p = placement_(p);
    add_hexahedron(scene_, corners);
  }

  SceneBuilder& scene_;
  House const& h_;
  Placement const& placement_;
  Index around_;
  std::vector<Index> grid_;
};

}  // namespace

void add_house(SceneBuilder& scene, House const& house, Placement const& placement)
{
  Builder(scene, house, placement).build();
}

}  // namespace visibility::generators
