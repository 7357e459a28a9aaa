#include "visibility/viewspace/sets_file.hpp"

#include "byte_stream.hpp"
#include "result_json.hpp"

#include "visibility/scene/scene_builder.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <unordered_set>

namespace visibility {

namespace {

using detail::ByteReader;
using detail::ByteWriter;
using Entry = DeltaSets::Entry;

constexpr std::string_view magic = "visibility-sets/1\n";

/// Small numbers for small differences of either sign; none for zero, which no cell has to its origin.
std::uint64_t zigzag(std::int64_t x)
{
  return x < 0 ? 2 * static_cast<std::uint64_t>(-x) - 1 : 2 * static_cast<std::uint64_t>(x);
}
std::int64_t from_zigzag(std::uint64_t x)
{
  auto const half = static_cast<std::int64_t>(x / 2);
  return x % 2 == 0 ? half : -half - 1;
}

void write(ByteWriter& out, std::span<std::uint32_t const> ascending)
{
  out.number(ascending.size());
  for (std::size_t i = 0; i < ascending.size(); ++i)
    out.number(i == 0 ? ascending[0] : ascending[i] - ascending[i - 1] - 1);
}

DeltaSets::Objects read_ascending(ByteReader& in, std::uint32_t objects)
{
  DeltaSets::Objects out(in.count("the objects of a set", 1));
  std::uint64_t next = 0;
  for (auto& o : out) {
    auto const gap = in.number("the objects of a set");
    if (gap >= objects || next + gap >= objects) in.fail("a set names an object that is not there");
    o = static_cast<std::uint32_t>(next + gap);
    next = std::uint64_t{o} + 1;
  }
  return out;
}

/// What stands before the list of changes.
std::uint64_t origin_code(std::size_t cell, Entry const& e)
{
  return e.from == Entry::key ? 0 : zigzag(std::int64_t{e.from} - static_cast<std::int64_t>(cell));
}

void write(ByteWriter& out, ViewCell const& cell)
{
  if (cell.is_box()) {
    out.number(0);
    for (auto const* p : {&cell.bounds().min, &cell.bounds().max})
      for (double const c : {p->x, p->y, p->z}) out.real(c);
    return;
  }
  // In an order that does not depend on how the hull was found.
  std::vector<Point3d> vertices(cell.vertices().begin(), cell.vertices().end());
  std::ranges::sort(vertices, {}, [](Point3d const& v) { return std::tuple(v.x, v.y, v.z); });
  out.number(vertices.size());
  for (auto const& v : vertices)
    for (double const c : {v.x, v.y, v.z}) out.real(c);
}

Point3d read_point(ByteReader& in)
{
  double const x = in.real("a cell"), y = in.real("a cell"), z = in.real("a cell");
  return {x, y, z};
}

ViewCell read_cell(ByteReader& in)
{
  auto const vertices = in.count("the vertices of a cell", 24);
  try {
    if (vertices == 0) {
      Point3d const min = read_point(in), max = read_point(in);
      return ViewCell(Box{min, max});
    }
    std::vector<Point3d> points(vertices);
    for (auto& p : points) p = read_point(in);
    return ViewCell::hull(points);
  } catch (std::invalid_argument const& e) {
    in.fail(e.what());
  }
}

Result read_about(ByteReader& in, std::string const& name)
{
  auto const text = in.text(in.count("the header", 1), "the header");
  auto results = results_from_json(text, name + ", header");
  if (results.size() != 1) in.fail("the header is not one object");
  Result& r = results.front();
  r.visible.clear();
  r.cell.clear();
  r.cell_box.reset();
  r.witnesses.clear();
  return std::move(r);
}

/// A name that JSON can hold.
std::string read_name(ByteReader& in)
{
  std::string name(in.text(in.count("the name of an object", 1), "the name of an object"));
  try {
    (void)detail::Json(name).dump();
  } catch (nlohmann::json::exception const&) {
    in.fail("the name of an object is not UTF-8");
  }
  return name;
}

}  // namespace

Result StoredSets::result(std::size_t cell, DeltaSets::Objects const& visible) const
{
  Result r = about;
  ViewCell const& c = sets.cells()[cell];
  r.cell.assign(c.vertices().begin(), c.vertices().end());
  if (c.is_box()) r.cell_box = c.bounds();
  for (auto const o : visible) r.visible.push_back(names[o]);
  std::ranges::sort(r.visible);
  return r;
}

StoredSizes stored_sizes(DeltaSets const& sets)
{
  StoredSizes out;
  auto const whole = sets.all();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    auto const& e = sets.entries()[i];
    out.differences += encoded_size(origin_code(i, e)) + encoded_size(e.changed);
    out.whole += encoded_size(whole[i]);
  }
  return out;
}

std::string to_bytes(StoredSets const& stored)
{
  if (stored.names.size() != stored.sets.object_count() || stored.polygons.size() != stored.names.size() ||
      stored.initial.size() != stored.sets.size())
    throw std::logic_error("StoredSets: not one name and count for each object, or not one initial cell for each cell");
  ByteWriter out;
  out.text(magic);
  auto const header = to_json({stored.about});
  out.number(header.size());
  out.text(header);
  out.number(stored.names.size());
  for (auto const& name : stored.names) {
    out.number(name.size());
    out.text(name);
  }
  for (auto const n : stored.polygons) out.number(n);
  out.number(stored.sets.size());
  for (auto const& cell : stored.sets.cells()) write(out, cell);
  for (auto const i : stored.initial) out.number(i);
  for (std::size_t i = 0; i < stored.sets.size(); ++i) {
    auto const& e = stored.sets.entries()[i];
    out.number(origin_code(i, e));
    write(out, e.changed);
  }
  out.checksum();
  return out.take();
}

StoredSets stored_sets_from_bytes(std::string_view bytes, std::string const& name)
{
  if (!bytes.starts_with(magic)) throw BadInput(name + ": not a file of format visibility-sets/1");
  ByteReader in(bytes, name);
  in.verify_checksum();
  (void)in.text(magic.size(), "the format");
  Result about = read_about(in, name);

  auto const object_count = in.count("the objects", 2);
  if (object_count >= UINT32_MAX) in.fail("more objects than 2^32");
  auto const objects = static_cast<std::uint32_t>(object_count);
  std::vector<std::string> names;
  std::unordered_set<std::string> taken;
  for (std::uint32_t i = 0; i < objects; ++i) {
    names.push_back(read_name(in));
    if (!taken.insert(names.back()).second) in.fail("two objects share a name");
  }
  std::vector<std::uint64_t> polygons(objects);
  for (auto& n : polygons) n = in.number("the polygons of an object");

  auto const size = in.count("the cells", 1 + 48 + 1 + 2);
  if (size == 0) in.fail("no cells");
  std::vector<ViewCell> cells;
  for (std::uint64_t i = 0; i < size; ++i) cells.push_back(read_cell(in));
  std::vector<std::uint32_t> initial(size);
  for (auto& i : initial) {
    auto const n = in.number("the initial cells");
    if (n >= UINT32_MAX) in.fail("an initial cell is out of range");
    i = static_cast<std::uint32_t>(n);
  }
  std::vector<Entry> entries(size);
  for (std::uint64_t i = 0; i < size; ++i) {
    auto const code = in.number("the origin of a set");
    if (code != 0) {
      if (code > 2 * size) in.fail("a set is derived from that of a cell that is not there");
      auto const from = static_cast<std::int64_t>(i) + from_zigzag(code);
      if (from < 0 || from >= static_cast<std::int64_t>(size))
        in.fail("a set is derived from that of a cell that is not there");
      entries[i].from = static_cast<std::uint32_t>(from);
    }
    entries[i].changed = read_ascending(in, objects);
  }
  if (in.left() > 0) in.fail("there is more than the sets");
  try {
    return {std::move(about), std::move(names), std::move(polygons), std::move(initial),
            DeltaSets(std::move(cells), std::move(entries), objects)};
  } catch (std::invalid_argument const& e) {
    throw BadInput(name + ": " + e.what());
  }
}

StoredSets read_stored_sets(std::filesystem::path const& file)
{
  return stored_sets_from_bytes(detail::read_text(file.string()), file.string());
}

}  // namespace visibility
