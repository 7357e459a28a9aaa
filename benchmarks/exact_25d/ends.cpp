#include "ends.hpp"

#include "visibility/methods/exact_25d/method.hpp"

#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace visibility::bench::exact_25d {

bool double_ends(HeightField const& field, ViewCell const& cell, unsigned seconds)
{
  pid_t const child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    rlimit const limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    try {
      Exact25d<Double>()(field, cell);
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace visibility::bench::exact_25d
