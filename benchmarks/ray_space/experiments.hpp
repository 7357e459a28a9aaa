#pragma once

#include "report.hpp"

#include "visibility/evidence/ray_scene.hpp"
#include "visibility/methods/ray_space/method.hpp"

#include <memory>
#include <string>

/// The tables of [Leyvand03, 6], and our own, each one file: fills a report with ours beside the paper's numbers.
namespace visibility::bench::ray_space {

enum class Size { full, smoke };  ///< smoke: small scenes, to see that it runs

void urban(Report&, Size);       ///< table 1
void tightness(Report&, Size);   ///< the same cells in a city of which there is an exact set
void box_field(Report&, Size);   ///< table 2
void umbrae(Report&, Size);      ///< table 3: half and full umbra
void resolution(Report&, Size);  ///< table 4
void city(Report&, Size);        ///< table 5: a real city, with the exact set
void components(Report&, Size);  ///< what more umbrae for each direction buy
void bounds(Report&, Size);      ///< exact and linear bounds; granularity

using Options = visibility::ray_space::Options;

/// A scene ready for queries; stays where it is.
struct Model {
  /// A generator specification; with rays only if something is to be sampled.
  Model(std::string const& specification, bool with_rays);
  Model(Model const&) = delete;
  Model& operator=(Model const&) = delete;

  Scene scene;
  double build_seconds = 0;
  std::unique_ptr<PreparedScene> prepared;
  std::unique_ptr<RayScene> rays;
};

struct Measured {
  double objects = 0, triangles = 0, seconds = 0;  ///< seconds of the set; triangles are tested one by one afterwards
};
Measured measure(PreparedScene const& scene, ViewCell const& cell, Options const& options, bool triangles = true);

/// One run, for queries of many seconds; no triangles.
Measured measure_once(PreparedScene const& scene, ViewCell const& cell, Options const& options);

/// Objects that guided rays see: fewer than there are.
double sampled(Model const& model, ViewCell const& cell, Size size);

/// A square cell on the ground.
ViewCell cell_at(double x, double y, double side, double height);

}  // namespace visibility::bench::ray_space
