#pragma once

#include "report.hpp"

namespace visibility::bench::extended_projection {

enum class Size { smoke, full };

void resolution(Report&, Size);    ///< figure 12
void growth(Report&, Size);        ///< figure 13
void improved(Report&, Size);      ///< the gain of the improved Projection, section 7.1
void reprojection(Report&, Size);  ///< windows against the paper's convolution, section 5.1
void lim(Report&, Size);           ///< planes at infinity, section 7.4
void city(Report&, Size);          ///< the 1.8 M polygon city, and strong occlusion on the same cells, section 7.1
void oriented(Report&, Size);      ///< planes along turned streets, section 2.4
void tilted(Report&, Size);        ///< planes along cells that rise along their street
void streets(Report&, Size);       ///< the adaptive preprocess of a district's streets, with cars, section 7.1
void truth(Report&, Size);         ///< what guided rays see from the cells of `city` and `forest`
void forest(Report&, Size);        ///< section 7.2
void error(Report&, Size);         ///< overestimation against the exact set over resolution

}  // namespace visibility::bench::extended_projection
