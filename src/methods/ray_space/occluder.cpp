#include "visibility/methods/ray_space/occluder.hpp"

#include "visibility/methods/ray_space/crossing.hpp"
#include "visibility/methods/ray_space/footprint.hpp"

#include <array>
#include <optional>
#include <ranges>
#include <span>
#include <tuple>
#include <utility>

namespace visibility::ray_space {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float nowhere = std::numeric_limits<float>::infinity();  ///< what a gate that hides nothing holds beyond

/// Whether the box is so narrow that no pixel has all its lines cross it. At slope t it is at most v1 - v0 + |t| (u1 -
/// u0) wide, and the lines of a pixel are a column and, at the distance of the box, a row apart. Rounded: a choice.
bool is_narrower_than_pixels(Frame const& frame, LocalBox const& b)
{
  double const widest = b.v1 - b.v0 + frame.t(frame.rows()) * (b.u1 - b.u0);
  return widest < frame.s(1) - frame.s(0) + (frame.t(1) - frame.t(0)) * std::max(0.0, b.u0);
}

}  // namespace

bool OccluderWriter::localize(Chords const& body, Frame const& frame)
{
  points_.clear();
  margin_.clear();
  ground_.clear();
  stands_ = false;
  bool ahead = false;
  for (auto const& p : body.points) {
    LocalPoint const q = frame.local(p);
    if (!(std::fabs(q.u) < Frame::reach && std::fabs(q.v) < Frame::reach && std::fabs(q.z) < Frame::reach))
      return false;
    ahead |= q.u > -frame.half_length();
    points_.push_back(q);
    margin_.push_back(frame.margin(q));
    ground_.push_back(p.z <= floor_);
    stands_ |= ground_.back();
  }
  return ahead;
}

void OccluderWriter::cross_row(Frame const& frame, int row, RowChord const& chord, int from, int to)
{
  LocalPoint const &p = points_[chord.i], &q = points_[chord.j];
  double const margins = margin_[chord.i] + margin_[chord.j], scale = frame.half_length() + frame.height();
  double const t0 = frame.t(row), t1 = frame.t(row + 1);
  Crossing const first(p, q, margins, scale, t0), second(p, q, margins, scale, t1);
  std::optional<LinearCrossing> linear;
  if (options_.bounds == Bounds::linear) linear.emplace(frame, p, q, margins);
  auto const at = [&](int line, Crossing const& crossing, double t) {
    return linear ? (*linear)(frame.s(line), t) : crossing(frame.s(line));
  };
  std::array<SlicePoint, 4> corner;
  int last = -1;  // the pixel whose upper corners are known
  for (int c = from; c < to; ++c) {
    if (open_[static_cast<std::size_t>(c)] == 0 || (chord.only_gaps && !is_gap(c))) continue;
    auto const* const k = frame.cell_slice(row, c);
    if (k == nullptr) continue;
    if (last == c - 1 && last >= 0)
      corner[0] = corner[2], corner[1] = corner[3];
    else
      corner[0] = at(c, first, t0), corner[1] = at(c, second, t1);
    corner[2] = at(c + 1, first, t0);
    corner[3] = at(c + 1, second, t1);
    last = c;
    SlicePoint all = corner[0];
    for (auto const& x : corner) {
      all.u_low = std::min(all.u_low, x.u_low), all.u_high = std::max(all.u_high, x.u_high);
      all.z_low = std::min(all.z_low, x.z_low), all.z_high = std::max(all.z_high, x.z_high);
    }
    if (!(all.u_low - k->u_out > 0x1p-30 * frame.half_length())) continue;
    // At constant height the tangents are extreme where the distance is.
    std::span<SlicePoint const> const extremes = p.z == q.z ? std::span(&all, 1) : std::span<SlicePoint const>(corner);
    auto& ends = ends_[static_cast<std::size_t>(c)];
    if (chord.top) ends.take_top(*k, extremes, all.u_high);
    if (chord.ground)
      ends.take_ground(all.u_high);
    else if (chord.bottom && options_.umbra == Umbra::full)
      ends.take_bottom(*k, extremes, all.u_high);
  }
}

/// At a constant height every tangent is monotone in the distance, so of the chords that all lines of a pixel cross the
/// nearest or the farthest gives each end of the gate.
void OccluderWriter::cross_upright_row(std::vector<Chord> const& chords, Frame const& frame, int row, int first,
                                       int last)
{
  double const scale = frame.half_length() + frame.height(), least_ahead = 0x1p-30 * frame.half_length();
  double const* const s = frame.column_lines();
  double const* const exit = frame.exits(row);
  for (auto const& chord : chords)
    for (auto const& [i, j] : {std::pair(chord.from, chord.to), std::pair(chord.to, chord.from)}) {
      int const from = std::max(above_[j], first), to = std::min(below_[i], last);
      if (from >= to) continue;
      LocalPoint const &p = points_[i], &q = points_[j];
      double const margins = margin_[i] + margin_[j];
      if (options_.bounds == Bounds::exact) {
        for (int const end : {0, 1}) {
          Crossing const crossing(p, q, margins, scale, frame.t(row + end));
          double *const low = line_[end].low.data(), *const high = line_[end].high.data();
          for (int c = from; c <= to; ++c) {
            auto const at = crossing(s[c]);
            low[c] = at.u_low, high[c] = at.u_high;
          }
        }
      } else {
        LinearCrossing const crossing(frame, p, q, margins);
        for (int const end : {0, 1})
          for (int c = from; c <= to; ++c) {
            auto const at = crossing(s[c], frame.t(row + end));
            line_[end].low[static_cast<std::size_t>(c)] = at.u_low;
            line_[end].high[static_cast<std::size_t>(c)] = at.u_high;
          }
      }
      double const *const low0 = line_[0].low.data(), *const low1 = line_[1].low.data();
      double const *const high0 = line_[0].high.data(), *const high1 = line_[1].high.data();
      double *const near_low = near_.low.data(), *const near_high = near_.high.data();
      double *const far_low = far_.low.data(), *const far_high = far_.high.data();
      auto const less = [](double x, double y) { return x < y ? x : y; };
      auto const more = [](double x, double y) { return x > y ? x : y; };
      for (int c = from; c < to; ++c) {
        double const low = less(less(low0[c], low0[c + 1]), less(low1[c], low1[c + 1]));
        double const high = more(more(high0[c], high0[c + 1]), more(high1[c], high1[c + 1]));
        bool const ahead = low - exit[c] > least_ahead;
        bool const nearest = ahead & (high < near_high[c]), farthest = ahead & (low > far_low[c]);
        near_low[c] = nearest ? low : near_low[c];
        near_high[c] = nearest ? high : near_high[c];
        far_low[c] = farthest ? low : far_low[c];
        far_high[c] = farthest ? high : far_high[c];
      }
    }
}

std::size_t OccluderWriter::write_upright_row(Chords const& body, Frame const& frame, OcclusionMap& map, int row,
                                              int from, int to)
{
  std::fill(near_.high.begin() + from, near_.high.begin() + to, infinity);
  std::fill(far_.low.begin() + from, far_.low.begin() + to, -infinity);
  cross_upright_row(body.edges, frame, row, from, to);
  // Other chords are crossed where no edge is: in pixels of vertices.
  auto const lacks = [&](int c) {
    return open_[static_cast<std::size_t>(c)] != 0 && near_.high[static_cast<std::size_t>(c)] == infinity;
  };
  if (std::ranges::any_of(std::views::iota(from, to), lacks)) cross_upright_row(body.others, frame, row, from, to);
  double const back = frame.half_length(), scale = back + frame.height();
  double const bottom = points_.front().z, top = points_.back().z;
  bool const open_below = ground_.front();
  if (!open_below && options_.umbra == Umbra::half) return 0;
  std::size_t written = 0;
  for (int column = from; column < to; ++column) {
    auto const c = static_cast<std::size_t>(column);
    gates_[c].beyond = nowhere;
    if (open_[c] == 0 || near_.high[c] == infinity) continue;
    auto const& k = *frame.cell_slice(row, column);
    auto const at = [&](Crossed const& x) { return SlicePoint{x.low[c], x.high[c], 0, 0}; };
    auto const ends = GateEnds::of_upright(k, at(near_), at(far_), bottom, top, open_below, scale);
    float const beyond = std::max(beyond_, ends.distance(back));
    if (map.reaches(row, column, {ends.top.slope, ends.bottom.slope, beyond})) continue;
    gates_[c] = ends.gate(k, back, beyond);
    ++written;
  }
  if (written > 0)
    map.insert(row, from,
               std::span(gates_).subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)));
  return written;
}

/// Of the open pixels leaves those in which the box that holds the body, as near or as far in it as is best, might
/// reach higher or lower than the largest gate. Returns the columns from the first to the last of them. Rounded: a
/// choice.
std::pair<int, int> OccluderWriter::leave_open(LocalBox const& box, Frame const& frame, OcclusionMap const& map,
                                               int row, int from, int to)
{
  double const beyond = std::max(beyond_, box.extent.far);
  int first = to, last = from;
  for (int c = from; c < to; ++c) {
    auto& open = open_[static_cast<std::size_t>(c)];
    if (open == 0) continue;
    auto const* const k = frame.cell_slice(row, c);
    auto const reaches = [&] {
      auto const reach = reach_of(box, stands_, *k);
      return map.reaches(row, c, {reach.top, reach.bottom, beyond});
    };
    if (k == nullptr || reaches()) open = 0;
    if (open == 0) continue;
    first = std::min(first, c);
    last = c + 1;
  }
  return {first, last};
}

bool OccluderWriter::is_gap(int column) const { return ends_[static_cast<std::size_t>(column)].lacks_one(); }

void OccluderWriter::add_chords(std::vector<Chord> const& chords, Frame const& frame, int row, int first, int last,
                                bool only_gaps)
{
  for (auto const& chord : chords) {
    std::size_t const a = chord.from, b = chord.to;
    for (auto const& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
      int const from = std::max(above_[j], first), to = std::min(below_[i], last);
      if (from >= to) continue;
      cross_row(frame, row, {i, j, chord.top, chord.bottom, ground_[a] && ground_[b], only_gaps}, from, to);
    }
  }
}

std::size_t OccluderWriter::write(Chords const& body, Box const& bounds, Frame const& frame, OcclusionMap& map,
                                  RefinedMap* refined, Box const* inside)
{
  if (!in_reach(frame, inside != nullptr ? *inside : bounds)) return 0;
  auto const box = local_box(frame, bounds);
  if (!box) return 0;
  bool const is_narrow = is_narrower_than_pixels(frame, *box);
  if (is_narrow && refined == nullptr) return 0;
  auto const [first, last] = rows_of(frame, *box);
  if (first >= last || !localize(body, frame)) return 0;
  beyond_ = inside != nullptr ? local_box(frame, *inside)->extent.far : 0;
  std::size_t const columns = static_cast<std::size_t>(frame.columns());
  for (auto* const limits : {&below_limit_, &above_limit_}) limits->resize(points_.size());
  for (auto* const columns_of : {&below_, &above_}) columns_of->resize(points_.size());
  ends_.resize(columns);
  open_.resize(columns);
  gates_.resize(columns);
  for (auto* const crossed : {&near_, &far_, &line_[0], &line_[1]})
    for (auto* const bound : {&crossed->low, &crossed->high}) bound->resize(columns + 1);
  std::size_t const plan_points = body.upright ? points_.size() / 2 : points_.size();
  std::size_t written = 0;
  std::optional<std::uint32_t> number;
  for (int row = first; row < last; ++row) {
    double const t0 = frame.t(row), t1 = frame.t(row + 1);
    double least_below = infinity, most_below = -infinity, least_above = infinity, most_above = -infinity;
    for (std::size_t i = 0; i < plan_points; ++i) {
      auto const& p = points_[i];
      double const x = t0 * p.u, y = t1 * p.u;
      below_limit_[i] = p.v - std::max(x, y) - margin_[i];
      above_limit_[i] = p.v - std::min(x, y) + margin_[i];
      least_below = std::min(least_below, below_limit_[i]);
      most_below = std::max(most_below, below_limit_[i]);
      least_above = std::min(least_above, above_limit_[i]);
      most_above = std::max(most_above, above_limit_[i]);
    }
    // Pixels that the body covers, or for parts of pixels those that it touches.
    int from = refined != nullptr ? frame.columns_below(least_below) : frame.columns_from(least_above);
    int to = refined != nullptr ? frame.columns_from(most_above) : frame.columns_below(most_below);
    if (from >= to || !map.visible_pixels(row, from, to, box->extent, &open_[static_cast<std::size_t>(from)])) continue;
    std::tie(from, to) = leave_open(*box, frame, map, row, from, to);
    if (from >= to) continue;
    if (refined != nullptr) {
      if (!number) number = refined->bodies().add(body, points_, margin_, ground_, *box, beyond_);
      for (int c = from; c < to; ++c)
        if (open_[static_cast<std::size_t>(c)] != 0) refined->note(row, c, *number);
      from = std::max(from, frame.columns_from(least_above));
      to = std::min(to, frame.columns_below(most_below));
    }
    if (is_narrow || from >= to) continue;
    for (std::size_t i = 0; i < plan_points; ++i) {
      below_[i] = frame.columns_below(below_limit_[i]);
      above_[i] = frame.columns_from(above_limit_[i]);
    }
    written +=
      body.upright ? write_upright_row(body, frame, map, row, from, to) : write_row(body, frame, map, row, from, to);
  }
  return written;
}

std::size_t OccluderWriter::write_row(Chords const& body, Frame const& frame, OcclusionMap& map, int row, int from,
                                      int to)
{
  std::fill(ends_.begin() + from, ends_.begin() + to, GateEnds{});
  add_chords(body.edges, frame, row, from, to, false);
  add_chords(body.others, frame, row, from, to, true);
  std::size_t written = 0;
  double const back = frame.half_length();
  for (int c = from; c < to; ++c) {
    gates_[static_cast<std::size_t>(c)].beyond = nowhere;
    if (is_gap(c)) continue;
    auto const& k = *frame.cell_slice(row, c);
    auto const& ends = ends_[static_cast<std::size_t>(c)];
    float const beyond = std::max(beyond_, ends.distance(back));
    if (map.reaches(row, c, {ends.top.slope, ends.bottom.slope, beyond})) continue;
    gates_[static_cast<std::size_t>(c)] = ends.gate(k, back, beyond);
    ++written;
  }
  if (written > 0)
    map.insert(row, from,
               std::span(gates_).subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)));
  return written;
}

}  // namespace visibility::ray_space
