#pragma once

#include "report.hpp"

#include "visibility/methods/strong_occlusion/options.hpp"
#include "visibility/scene/view_cell.hpp"

#include <string>

/// The experiments of [CohenOr98, 6], and our own, each one file: fills a report with ours beside the paper's numbers.
namespace visibility::bench::strong_occlusion {

enum class Size { full, smoke };  ///< smoke: a small scene, to see that it runs

void cell_sizes(Report&, Size);     ///< tables 1 and 2, figure 5: the set and its cost over the cell's size
void ranks(Report&, Size);          ///< table 3: how near the strong occluder is
void levels(Report&, Size);         ///< table 4: one level and two
void spheres(Report&, Size);        ///< table 5: balls
void optimizations(Report&, Size);  ///< section 5: each optimization alone, left out, all together
void cities(Report&, Size);         ///< real cities, with and without inner bodies
void scale(Report&, Size);          ///< 10^4 to 10^6 boxes

/// The city of the paper; small for a smoke run.
std::string city(Size);
/// Its cells: squares in the middle of the free ground, 50 high.
ViewCell ground_cell(double side, double x = 0, double y = 0);

using Options = visibility::strong_occlusion::Options;
/// What the paper implemented: the leading ray, and 64 sight lines for every verdict.
Options as_published();

}  // namespace visibility::bench::strong_occlusion
