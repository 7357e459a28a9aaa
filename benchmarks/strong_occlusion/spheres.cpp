#include "experiments.hpp"

#include "visibility/methods/strong_occlusion/method.hpp"
#include "visibility/methods/strong_occlusion/survey.hpp"
#include "visibility/scene/generators.hpp"

namespace visibility::bench::strong_occlusion {

void spheres(Report& report, Size size)
{
  struct Published {
    double side, rays, hidden, visible;
  };
  bool const full = size == Size::full;
  Scene const scene = generate(full ? "spheres" : "spheres,n=8");
  PreparedScene const prepared(scene);
  double const middle = full ? 3100 : 900;
  auto& table =
    report.table("Table 5: 27,000 balls of radius 50, occluders exact, occludees by their boxes (paper | ours)",
                 {"side", "ray/ball", "as published", "ours", "hidden", "ours", "visible", "ours", "ours, ms"});
  for (auto const& p :
       {Published{50, 463204, 119, 26880}, Published{40, 558874, 811, 26188}, Published{30, 678895, 2334, 24665},
        Published{20, 819622, 4611, 22388}, Published{10, 971410, 7481, 19518}, Published{5, 1052048, 9169, 17830}}) {
    double const h = p.side / 2;
    ViewCell const cell(Box{{-h, -h, middle - h}, {h, h, middle + h}});
    using visibility::strong_occlusion::survey;
    auto const plain = survey<Filtered>(prepared, cell, as_published()),
               all = survey<Filtered>(prepared, cell, Options{});
    double const seconds = median_seconds(full ? 5 : 1, 5, [&] { StrongOcclusion<>()(prepared, cell); });
    table.add({p.side, p.rays, double(plain.counts.rays - plain.counts.face_rays),
               double(all.counts.rays - all.counts.face_rays), p.hidden, double(all.hidden_bodies), p.visible,
               double(all.bodies - all.hidden_bodies), 1e3 * seconds});
  }
  table.notes = {"The spacing of the balls is not in the paper: docs/generators.md."};
}

}  // namespace visibility::bench::strong_occlusion
