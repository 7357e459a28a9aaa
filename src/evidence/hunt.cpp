#include "hunt.hpp"

#include "bandit.hpp"

#include "visibility/scene/meets_cell.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace visibility::detail {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t chunk_rays = 1024;
constexpr std::size_t first_round = 2 * chunk_rays, largest_round = 64 * chunk_rays;
constexpr std::size_t candidates_per_object = 4;  // and round
constexpr std::size_t patient_failures = 16;      // afterwards an object's candidates are taken ever more rarely
constexpr std::size_t remembered_blocks = 1U << 14;
constexpr std::size_t blocks_per_chunk = 64;

/// A candidate and the strategy that proposed it.
struct Proposal {
  Candidate candidate;
  Strategy strategy;
};

/// What one chunk of rays brings home.
struct Catch {
  std::vector<Proposal> proposals;
  std::vector<std::pair<Knowledge::Sighting, Strategy>> first_sights;  // of known objects
  std::vector<Knowledge::Blocked> blocked;
  std::array<std::uint64_t, strategies> cast{};
  std::uint64_t hits = 0;
};

class Hunt {
public:
  Hunt(RayScene const& rays, ViewCell const& cell, std::span<std::uint32_t const> known, HuntLimits const& limits)
    : scene_(rays.scene()), rays_(rays), cell_(cell), limits_(limits), points_(cell, rays),
      planner_(scene_, points_, knowledge_), arena_(limits.threads > 0 ? limits.threads : tbb::task_arena::automatic),
      seen_(scene_.scene().objects.size()), sighted_(seen_.size()), failures_(seen_.size())
  {
    knowledge_.wanted.assign(seen_.size(), 1);
    for (auto const id : known) {
      knowledge_.wanted[id] = 0;
      knowledge_.found.push_back(id);
    }
  }

  HuntReport run()
  {
    auto const start = Clock::now();
    auto const elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    find_touching();
    list_unfound();
    std::size_t size = first_round;
    for (std::uint64_t round = 0; left_ > 0 && report_.rays < limits_.rays; ++round) {
      if (limits_.seconds > 0 && elapsed() >= limits_.seconds) break;
      auto const n = static_cast<std::size_t>(std::min<std::uint64_t>(size, limits_.rays - report_.rays));
      std::uint64_t const before = report_.rays;
      play(round, n);
      if (limits_.progress) limits_.progress(report_.rays - before);
      size = std::min(largest_round, size + size / 2);
    }
    finish();
    report_.seconds = elapsed();
    return std::move(report_);
  }

private:
  /// Objects that meet the closed cell are visible.
  void find_touching()
  {
    scene_.object_hierarchy().any_meeting(cell_.bounds(), [&](std::uint32_t id) {
      if (knowledge_.wanted[id] != 0 && meets_cell(scene_, cell_, id)) found(id);
      return false;
    });
  }

  void found(std::uint32_t id)
  {
    knowledge_.wanted[id] = 0;
    knowledge_.found.push_back(id);
    report_.found.push_back(id);
  }

  void list_unfound()
  {
    auto& list = knowledge_.unfound;
    list.clear();
    for (std::uint32_t id = 0; id < knowledge_.wanted.size(); ++id)
      if (knowledge_.wanted[id] != 0) list.push_back(id);
    left_ = list.size();
  }

  void play(std::uint64_t round, std::size_t n)
  {
    std::vector<Catch> catches((n + chunk_rays - 1) / chunk_rays);
    arena_.execute([&] {
      tbb::parallel_for(std::size_t{0}, catches.size(), [&](std::size_t c) {
        Random random(limits_.seed, round * largest_round + c);
        cast_chunk(random, std::min(chunk_rays, n - c * chunk_rays), catches[c]);
      });
    });
    std::array<std::uint64_t, strategies> cast{};
    std::array<double, strategies> worth{};
    for (auto const& c : catches) {
      report_.hits += c.hits;
      for (std::size_t i = 0; i < strategies; ++i) cast[i] += c.cast[i];
    }
    for (std::size_t i = 0; i < strategies; ++i) report_.cast[i] += cast[i];
    report_.rays += n;
    judge(round, catches, worth);
    remember(catches, worth);
    bandit_.learn(cast, worth);
  }

  void cast_chunk(Random& random, std::size_t n, Catch& out)
  {
    for (std::size_t i = 0; i < n; ++i) {
      Strategy const strategy = bandit_.choose(random);
      ++out.cast[static_cast<std::size_t>(strategy)];
      Plan const plan = planner_.plan(random, strategy);
      if (plan.direction == Point3d{0, 0, 0} || !is_finite(plan.direction)) continue;
      RayHit const hit = rays_.first_hit(plan.origin, plan.direction);
      if (hit.hit()) note_hit(plan, hit, strategy, out);
      if (plan.aim) note_aim(plan, hit, strategy, out);
    }
  }

  void note_hit(Plan const& plan, RayHit const& hit, Strategy strategy, Catch& out)
  {
    ++out.hits;
    if (hit.from_inside) return;
    if (seen_[hit.object].load(std::memory_order_relaxed) == 0) seen_[hit.object].store(1, std::memory_order_relaxed);
    if (knowledge_.wanted[hit.object] != 0)
      out.proposals.push_back({{hit.object, hit.face, plan.origin, hit.point}, strategy});
    else if (sighted_[hit.object] == 0)
      out.first_sights.push_back({{hit.object, plan.origin, hit.point}, strategy});
  }

  /// An aimed ray that reaches its aim proposes it even if another face coincides with it or it is no occluder.
  /// How near is near enough is a choice, single precision in mind: the exact predicate decides every proposal.
  void note_aim(Plan const& plan, RayHit const& hit, Strategy strategy, Catch& out) const
  {
    Aim const& aim = *plan.aim;
    if (knowledge_.wanted[aim.object] == 0 || hit.object == aim.object) return;
    constexpr double near_enough = 1 - 1e-5;
    if (!hit.from_inside && hit.distance > near_enough)
      out.proposals.push_back({{aim.object, aim.face, plan.origin, aim.point}, strategy});
    else if (!hit.from_inside && out.blocked.size() < blocks_per_chunk)
      out.blocked.push_back({aim.object, hit.object, plan.origin});
  }

  /// Lets the exact predicate decide: object by object in parallel, candidates of an object in the order of their rays.
  void judge(std::uint64_t round, std::vector<Catch> const& catches, std::array<double, strategies>& worth)
  {
    std::vector<Proposal const*> proposals;
    for (auto const& c : catches)
      for (auto const& p : c.proposals) proposals.push_back(&p);
    std::ranges::stable_sort(proposals, {}, [](Proposal const* p) { return p->candidate.object; });

    struct Case {
      std::size_t first, last;
      std::optional<Witness> witness;
      std::size_t tried = 0;
    };
    std::vector<Case> cases;
    Random patience(~limits_.seed, round);
    for (std::size_t i = 0, j = 0; i < proposals.size(); i = j) {
      std::uint32_t const id = proposals[i]->candidate.object;
      while (j < proposals.size() && proposals[j]->candidate.object == id) ++j;
      if (failures_[id] > patient_failures && !patience.chance(double(patient_failures) / failures_[id])) continue;
      cases.push_back({i, std::min(j, i + candidates_per_object), {}, 0});
    }
    arena_.execute([&] {
      tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
        Case& c = cases[i];
        while (!c.witness && c.first + c.tried < c.last)
          c.witness = find_witness(scene_, proposals[c.first + c.tried++]->candidate);
      });
    });
    for (auto& c : cases) {
      Proposal const& decisive = *proposals[c.first + c.tried - 1];
      std::uint32_t const id = decisive.candidate.object;
      std::size_t const refused = c.tried - (c.witness ? 1 : 0);
      report_.rejected += refused;
      failures_[id] += static_cast<std::uint32_t>(refused);
      if (!c.witness) continue;
      auto const strategy = static_cast<std::size_t>(decisive.strategy);
      ++report_.finds[strategy];
      worth[strategy] += 1;
      found(id);
      sighted_[id] = 1;
      knowledge_.sightings.push_back({id, decisive.candidate.from, decisive.candidate.near});
      report_.witnesses.push_back(std::move(*c.witness));
      --left_;
    }
  }

  void remember(std::vector<Catch> const& catches, std::array<double, strategies>& worth)
  {
    constexpr double worth_of_known = 0.25;  // shows that the strategy reaches what is hard to see
    for (auto const& c : catches) {
      for (auto const& [sight, strategy] : c.first_sights) {
        if (sighted_[sight.object] != 0) continue;
        sighted_[sight.object] = 1;
        knowledge_.sightings.push_back(sight);
        worth[static_cast<std::size_t>(strategy)] += worth_of_known;
      }
      for (auto const& b : c.blocked) {
        if (knowledge_.blocked.size() < remembered_blocks)
          knowledge_.blocked.push_back(b);
        else
          knowledge_.blocked[next_block_++ % remembered_blocks] = b;
      }
    }
    std::erase_if(knowledge_.blocked, [&](auto const& b) { return knowledge_.wanted[b.wanted] == 0; });
    // Refresh the list when a tenth of it has been found.
    if (knowledge_.unfound.size() > left_ + left_ / 8) list_unfound();
  }

  void finish()
  {
    std::ranges::sort(report_.found);
    std::ranges::sort(report_.witnesses, {}, &Witness::object);
    for (std::uint32_t id = 0; id < seen_.size(); ++id)
      if (seen_[id] != 0) report_.seen.push_back(id);
  }

  PreparedScene const& scene_;
  RayScene const& rays_;
  ViewCell const& cell_;
  HuntLimits limits_;
  CellPoints points_;
  Knowledge knowledge_;
  Planner planner_;
  Bandit bandit_;
  tbb::task_arena arena_;
  std::vector<std::atomic<std::uint8_t>> seen_;
  std::vector<std::uint8_t> sighted_;
  std::vector<std::uint32_t> failures_;
  std::size_t left_ = 0, next_block_ = 0;
  HuntReport report_;
};

}  // namespace

HuntReport hunt(RayScene const& rays, ViewCell const& cell, std::span<std::uint32_t const> known,
                HuntLimits const& limits)
{
  return Hunt(rays, cell, known, limits).run();
}

}  // namespace visibility::detail
