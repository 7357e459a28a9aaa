#include "visibility/evidence/ray_scene.hpp"

#include "embree_api.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace visibility {

namespace {

constexpr float far = std::numeric_limits<float>::max();

struct FloatBox {
  float min[3], max[3];
};

/// A flat face of a triangulated solid and the object it belongs to.
struct NamedFace {
  std::uint32_t object;
  Face face;
};

struct Vertex {
  float x, y, z;
};

void box_bounds(RTCBoundsFunctionArguments const* args)
{
  FloatBox const& b = static_cast<FloatBox const*>(args->geometryUserPtr)[args->primID];
  RTCBounds& out = *args->bounds_o;
  out.lower_x = b.min[0], out.lower_y = b.min[1], out.lower_z = b.min[2];
  out.upper_x = b.max[0], out.upper_y = b.max[1], out.upper_z = b.max[2];
}

/// Slab test of one ray. The entered face goes into hit.u as its number (Face::part), -1 for a start inside.
void intersect_box(RTCIntersectFunctionNArguments const* args)
{
  if (args->valid[0] == 0) return;
  FloatBox const& b = static_cast<FloatBox const*>(args->geometryUserPtr)[args->primID];
  auto& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  RTCRay& ray = rayhit.ray;
  float const origin[3] = {ray.org_x, ray.org_y, ray.org_z}, direction[3] = {ray.dir_x, ray.dir_y, ray.dir_z};
  float enter = ray.tnear, leave = ray.tfar;
  int face = -1;
  for (int axis = 0; axis < 3; ++axis) {
    float const inverse = 1 / direction[axis];  // directions are kept away from zero
    float const a = (b.min[axis] - origin[axis]) * inverse, c = (b.max[axis] - origin[axis]) * inverse;
    float const first = std::min(a, c), last = std::max(a, c);
    if (first > enter) enter = first, face = 2 * axis + (inverse < 0 ? 1 : 0);
    leave = std::min(leave, last);
  }
  if (enter > leave) return;
  ray.tfar = enter;
  rayhit.hit.u = static_cast<float>(face);
  rayhit.hit.Ng_x = rayhit.hit.Ng_y = rayhit.hit.Ng_z = 0;
  rayhit.hit.primID = args->primID;
  rayhit.hit.geomID = args->geomID;
}

struct Release {
  void operator()(RTCDeviceTy* d) const { rtcReleaseDevice(d); }
  void operator()(RTCSceneTy* s) const { rtcReleaseScene(s); }
};

}  // namespace

struct RayScene::Parts {
  enum Group : unsigned { boxes, balls, solids, triangles };

  explicit Parts(PreparedScene const& s);

  /// Relative to the centre, in units of the scene's size: what single precision sees.
  Vertex vertex(Point3d const& p) const
  {
    return {static_cast<float>((p.x - centre.x) / unit), static_cast<float>((p.y - centre.y) / unit),
            static_cast<float>((p.z - centre.z) / unit)};
  }
  bool occludes(std::uint32_t object) const { return scene.objects[object].occludes; }
  void add_boxes();
  void add_balls();
  void add_solids();
  void add_triangles();
  void attach(RTCGeometry geometry, Group group);

  PreparedScene const& prepared;
  Scene const& scene;
  Point3d centre;
  double unit = 1;  // a power of two near the scene's size: dividing by it is exact
  std::unique_ptr<RTCDeviceTy, Release> device;
  std::unique_ptr<RTCSceneTy, Release> tree;
  std::vector<FloatBox> float_boxes;
  std::vector<std::uint32_t> box_object, ball_object, triangle_object;
  std::vector<NamedFace> solid_faces;
};

RayScene::Parts::Parts(PreparedScene const& s) : prepared(s), scene(s.scene())
{
  Box bounds;
  for (auto const& b : s.object_bounds()) bounds.extend(b);
  auto const half = [](double a, double b) { return 0.5 * a + 0.5 * b; };
  centre = {half(bounds.min.x, bounds.max.x), half(bounds.min.y, bounds.max.y), half(bounds.min.z, bounds.max.z)};
  double const size =
    std::max({bounds.max.x - centre.x, bounds.max.y - centre.y, bounds.max.z - centre.z, std::ldexp(1, -1000)});
  unit = std::ldexp(1, std::ilogb(size));
  device.reset(rtcNewDevice(nullptr));
  if (!device) throw std::runtime_error("Embree: no device (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
  tree.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_COMPACT);
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    Object const& o = scene.objects[id];
    box_object.insert(box_object.end(), o.boxes.size(), id);
    ball_object.insert(ball_object.end(), o.balls.size(), id);
    triangle_object.insert(triangle_object.end(), o.triangles.size(), id);
  }
  add_boxes();
  add_balls();
  add_solids();
  add_triangles();
  rtcCommitScene(tree.get());
  if (auto const e = rtcGetDeviceError(device.get()); e != RTC_ERROR_NONE)
    throw std::runtime_error("Embree: error " + std::to_string(e) + " while building the scene of rays");
}

void RayScene::Parts::attach(RTCGeometry geometry, Group group)
{
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(tree.get(), geometry, group);
  rtcReleaseGeometry(geometry);
}

void RayScene::Parts::add_boxes()
{
  if (scene.boxes.empty()) return;
  float_boxes.reserve(scene.boxes.size());
  for (auto const& b : scene.boxes) {
    Vertex lo = vertex(b.min), hi = vertex(b.max);
    if (!occludes(box_object[float_boxes.size()])) lo.x = far, hi.x = -far;  // an empty box is left out
    float_boxes.push_back({{lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z}});
  }
  RTCGeometry const g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(float_boxes.size()));
  rtcSetGeometryUserData(g, float_boxes.data());
  rtcSetGeometryBoundsFunction(
    g, [](RTCBoundsFunctionArguments const* args) { box_bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(g, [](RTCIntersectFunctionNArguments const* args) { intersect_box(args); });
  attach(g, boxes);
}

void RayScene::Parts::add_balls()
{
  if (scene.balls.empty()) return;
  RTCGeometry const g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* const out = static_cast<float*>(
    rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, scene.balls.size()));
  if (out == nullptr) throw std::runtime_error("Embree: out of memory");
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    Vertex const c = vertex(scene.balls[i].centre);
    float* const v = out + 4 * i;
    v[0] = c.x, v[1] = c.y, v[2] = c.z;
    v[3] = occludes(ball_object[i]) ? static_cast<float>(scene.balls[i].radius / unit) : -1;  // negative: left out
  }
  attach(g, balls);
}

/// Walls and caps of prisms and facets of polyhedra, as triangles that face outward.
void RayScene::Parts::add_solids()
{
  std::vector<Vertex> corners;
  auto const add = [&](std::uint32_t object, Face face, Point3d const& a, Point3d const& b, Point3d const& c) {
    solid_faces.push_back({object, face});
    for (auto const* p : {&a, &b, &c}) corners.push_back(vertex(*p));
  };
  auto const& bodies = prepared.bodies();
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    Object const& o = scene.objects[id];
    if (!o.occludes) continue;
    for (auto i = o.polyhedra.first; i < o.polyhedra.last; ++i) {
      auto const& p = scene.polyhedra[i];
      for (std::uint32_t k = 0; k < p.facets.size(); ++k) {
        auto const& v = p.facets[k].vertices;
        add(id, {Face::Kind::facet, i, k}, p.vertices[v[0]], p.vertices[v[1]], p.vertices[v[2]]);
      }
    }
    if (o.prisms.size() == 0) continue;
    // A prism without pieces occludes nothing; which ones have pieces is told by the bodies, in the order of prisms.
    bool const all_solid =
      std::ranges::all_of(bodies.bodies_of(id), [](ConvexBodies::Body const& b) { return b.occludes; });
    for (auto i = o.prisms.first; i < o.prisms.last; ++i) {
      auto const& prism = scene.prisms[i];
      if (!all_solid && convex_partition(prism).empty()) continue;
      std::uint32_t edge = 0;
      for (std::size_t r = 0; r < prism.rings.size(); ++r) {
        auto const& ring = prism.rings[r];
        double area = 0;
        for (std::size_t k = 0; k < ring.size(); ++k) {
          auto const &a = ring[k], &b = ring[(k + 1) % ring.size()];
          area += (a.x - ring[0].x) * (b.y - ring[0].y) - (b.x - ring[0].x) * (a.y - ring[0].y);
        }
        bool const solid_on_left = (area > 0) == (r == 0);
        for (std::size_t k = 0; k < ring.size(); ++k, ++edge) {
          auto a = ring[k], b = ring[(k + 1) % ring.size()];
          if (!solid_on_left) std::swap(a, b);
          Point3d const a0{a.x, a.y, prism.bottom}, b0{b.x, b.y, prism.bottom}, b1{b.x, b.y, prism.top},
            a1{a.x, a.y, prism.top};
          add(id, {Face::Kind::wall, i, edge}, a0, b0, b1);
          add(id, {Face::Kind::wall, i, edge}, a0, b1, a1);
        }
      }
    }
    auto const own = bodies.bodies_of(id);
    auto const first = static_cast<std::uint32_t>(own.data() - bodies.bodies().data());
    for (std::uint32_t k = 0; k < own.size(); ++k) {
      if (own[k].kind != ConvexBodies::Kind::prism) continue;
      auto const& piece = bodies.prism(own[k]);
      for (std::uint32_t t = 0; t + 2 < piece.footprint.size(); ++t) {
        auto const &a = piece.footprint[0], &b = piece.footprint[t + 1], &c = piece.footprint[t + 2];
        double const hi = piece.top, lo = piece.bottom;
        add(id, {Face::Kind::roof, first + k, t}, {a.x, a.y, hi}, {b.x, b.y, hi}, {c.x, c.y, hi});
        add(id, {Face::Kind::floor, first + k, t}, {a.x, a.y, lo}, {c.x, c.y, lo}, {b.x, b.y, lo});
      }
    }
  }
  if (corners.empty()) return;
  RTCGeometry const g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const v = static_cast<Vertex*>(
    rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex), corners.size()));
  auto* const index = static_cast<unsigned*>(
    rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, solid_faces.size()));
  if (v == nullptr || index == nullptr) throw std::runtime_error("Embree: out of memory");
  std::ranges::copy(corners, v);
  for (unsigned i = 0; i < corners.size(); ++i) index[i] = i;
  attach(g, solids);
}

void RayScene::Parts::add_triangles()
{
  if (scene.triangles.empty()) return;
  RTCGeometry const g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const v = static_cast<Vertex*>(
    rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex), scene.vertices.size()));
  // A copy, since Embree reads a few bytes past the last index.
  auto* const index = static_cast<std::uint32_t*>(
    rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, scene.triangles.size()));
  if (v == nullptr || index == nullptr) throw std::runtime_error("Embree: out of memory");
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) v[i] = vertex(scene.vertices[i]);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    std::ranges::copy(scene.triangles[i], index + 3 * i);
    if (!occludes(triangle_object[i])) index[3 * i] = RTC_INVALID_GEOMETRY_ID;  // no such vertex: left out
  }
  attach(g, triangles);
}

RayScene::RayScene(PreparedScene const& scene) : parts_(std::make_unique<Parts>(scene)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

PreparedScene const& RayScene::scene() const { return parts_->prepared; }

Point3d RayScene::snapped(Point3d const& p) const
{
  Vertex const v = parts_->vertex(p);
  Point3d const& c = parts_->centre;
  double const unit = parts_->unit;
  return {c.x + unit * double(v.x), c.y + unit * double(v.y), c.z + unit * double(v.z)};
}

RayHit RayScene::first_hit(Point3d const& origin, Point3d const& direction) const
{
  Vertex const o = parts_->vertex(origin);
  double const length = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  auto const component = [&](double d) {
    auto const f = static_cast<float>(d / length);
    return std::fabs(f) < 1e-18F ? std::copysign(1e-18F, f) : f;
  };
  RTCRayHit ray;
  ray.ray.org_x = o.x, ray.ray.org_y = o.y, ray.ray.org_z = o.z;
  ray.ray.dir_x = component(direction.x), ray.ray.dir_y = component(direction.y),
  ray.ray.dir_z = component(direction.z);
  ray.ray.tnear = 0, ray.ray.tfar = far, ray.ray.time = 0;
  ray.ray.mask = ~0U, ray.ray.id = 0, ray.ray.flags = 0;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  detail::intersect(parts_->tree.get(), ray);

  RayHit out;
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return out;
  double const t = parts_->unit * ray.ray.tfar;
  out.distance = t / length;
  out.point = {origin.x + t * ray.ray.dir_x, origin.y + t * ray.ray.dir_y, origin.z + t * ray.ray.dir_z};
  auto const leaving = [&] {
    return ray.hit.Ng_x * ray.ray.dir_x + ray.hit.Ng_y * ray.ray.dir_y + ray.hit.Ng_z * ray.ray.dir_z > 0;
  };
  auto const i = ray.hit.primID;
  switch (ray.hit.geomID) {
  case Parts::boxes:
    out.object = parts_->box_object[i];
    out.from_inside = ray.hit.u < 0;
    out.face = {Face::Kind::box, i, out.from_inside ? 0 : static_cast<std::uint32_t>(ray.hit.u)};
    break;
  case Parts::balls:
    out.object = parts_->ball_object[i];
    out.from_inside = leaving();
    out.face = {Face::Kind::sphere, i, 0};
    break;
  case Parts::solids:
    out.object = parts_->solid_faces[i].object;
    out.face = parts_->solid_faces[i].face;
    out.from_inside = leaving();
    break;
  default: out.object = parts_->triangle_object[i]; out.face = {Face::Kind::triangle, i, 0};
  }
  return out;
}

}  // namespace visibility
