#include "commands.hpp"
#include "methods.hpp"
#include "scene_argument.hpp"

#include "visibility/scene/convex_bodies.hpp"
#include "visibility/scene/scene_report.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <iostream>
#include <memory>

namespace visibility::commands {

namespace {

void print_primitives(Scene const& scene)
{
  auto const line = [](char const* what, std::size_t n) {
    if (n > 0) std::cout << "  " << what << ": " << n << '\n';
  };
  std::cout << "primitives: " << scene.primitive_count() << '\n';
  line("boxes", scene.boxes.size());
  line("balls", scene.balls.size());
  line("prisms", scene.prisms.size());
  line("polyhedra", scene.polyhedra.size());
  line("triangles", scene.triangles.size());
}

void print_bodies(ConvexBodies const& bodies)
{
  using Kind = ConvexBodies::Kind;
  std::array<std::size_t, 5> count{};
  for (auto const& b : bodies.bodies())
    if (b.occludes) ++count[static_cast<std::size_t>(b.kind)];
  std::size_t occluders = 0;
  for (auto const n : count) occluders += n;
  std::cout << "convex occluders: " << occluders << " (" << count[std::size_t(Kind::box)] << " boxes, "
            << count[std::size_t(Kind::ball)] << " balls, " << count[std::size_t(Kind::prism)] << " prisms, "
            << count[std::size_t(Kind::polyhedron)] << " polyhedra, " << count[std::size_t(Kind::triangle)]
            << " triangles)\n";
  if (bodies.invalid_footprints() > 0)
    std::cout << "invalid footprints: " << bodies.invalid_footprints() << " (kept as objects, not used as occluders)\n";
}

}  // namespace

void add_info(CLI::App& app)
{
  auto const scene_argument = std::make_shared<SceneArgument>();
  auto* const command = app.add_subcommand("info", "Objects, primitives, bounds of a scene, and which methods apply");
  scene_argument->add_to(*command);
  command->callback([scene_argument] {
    Scene const scene = scene_argument->load();
    Box const b = bounding_box(scene);
    std::cout.precision(17);
    std::cout << "scene: " << scene.source << "\nobjects: " << scene.objects.size() << '\n';
    print_primitives(scene);
    std::cout << "bounds: [" << b.min.x << ", " << b.max.x << "] x [" << b.min.y << ", " << b.max.y << "] x ["
              << b.min.z << ", " << b.max.z << "] metres\n";
    SceneReport const odd = report(scene);
    std::cout << "zero-area triangles: " << odd.zero_area_triangles << "\nduplicate faces: " << odd.duplicate_faces
              << "\nflat boxes: " << odd.flat_boxes << '\n';
    print_bodies(ConvexBodies(scene));
    for (auto const& note : scene.notes) std::cout << "note: " << note << '\n';
    std::cout << "methods:";
    for (auto const& name : applicable_methods(scene)) std::cout << ' ' << name;
    std::cout << '\n';
  });
}

}  // namespace visibility::commands
