#pragma once

#include <cstdint>

namespace visibility {

/// The layers of a filtered predicate, in the order in which they are asked.
enum class Layer : std::uint8_t { filter, interval, exact };

/// How many signs each layer decided.
struct LayerCounts {
  std::uint64_t filter = 0, interval = 0, exact = 0;
  std::uint64_t total() const { return filter + interval + exact; }
};

/// Tally policy that costs nothing.
struct NoTally {
  static void count(Layer) {}
};

/// Tally policy that counts per thread: `ThreadTally::counts` is the calling thread's own.
struct ThreadTally {
  inline static thread_local LayerCounts counts{};
  static void reset() { counts = {}; }
  static void count(Layer layer)
  {
    switch (layer) {
    case Layer::filter: ++counts.filter; break;
    case Layer::interval: ++counts.interval; break;
    case Layer::exact: ++counts.exact; break;
    }
  }
};

}  // namespace visibility
