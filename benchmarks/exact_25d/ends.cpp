#include "ends.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace visibility::bench::exact_25d {

template <Arithmetic A>
bool ends(HeightField const& field, ViewCell const& cell, unsigned seconds)
{
  pid_t const child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    rlimit const limit{seconds, seconds}, none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_CPU, &limit);
    try {
      Exact25d<A>()(field, cell);
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

template bool ends<Filtered>(HeightField const&, ViewCell const&, unsigned);
template bool ends<Double>(HeightField const&, ViewCell const&, unsigned);

std::vector<ViewCell> answered_cells(Model const& m, CellShape const& shape, int count, std::vector<std::string>& notes)
{
  auto cells = free_cells(*m.field, shape, count);
  auto const late = std::erase_if(cells, [&](ViewCell const& c) { return !ends<Filtered>(*m.field, c, 5); });
  if (late > 0)
    notes.push_back(m.name + ", perimeter " + std::to_string(static_cast<int>(shape.perimeter)) + ": left out " +
                    std::to_string(late) + " cells without an answer within 5 s");
  return cells;
}

}  // namespace visibility::bench::exact_25d
