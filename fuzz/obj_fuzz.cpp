#include "read_or_refuse.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
  visibility::fuzz::read_or_refuse(data, size, visibility::SceneFormat::obj);
  return 0;
}
