#pragma once

namespace visibility {

/// Whether a segment from p to q contains q. A sight line does not contain its target (design: visible means that the
/// half-open segment [p, s) meets no occluder), so that two coinciding faces do not hide each other.
enum class End { excluded, included };

}  // namespace visibility
