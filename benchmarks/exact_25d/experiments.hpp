#pragma once

#include "report.hpp"

/// The experiments of [Bittner05, 6], and our own, each one file: fills a report with ours beside the paper's numbers.
namespace visibility::bench::exact_25d {

enum class Size { full, smoke };  ///< smoke: small scenes and few cells, to see that it runs

void models(Report&, Size);             ///< table 1: the scenes
void cells(Report&, Size);              ///< table 2: sets and times by size of the cell; exact and Double
void stages(Report&, Size);             ///< table 3: what decides; line space; building and memory
void wedges(Report&, Size);             ///< section 6.2: one penumbra wedge at a time
void sampling(Report&, Size);           ///< table 4: sampled line space
void grid(Report&, Size);               ///< section 6.3: occluders on a grid of the plan
void growth(Report&, Size);             ///< figure 6: work against what is visible; time against the scene
void embree(Report&, Size);             ///< what guided rays find in the time of the exact method and in more
void double_arithmetic(Report&, Size);  ///< wrong verdicts of plain floating point on small hard scenes

}  // namespace visibility::bench::exact_25d
