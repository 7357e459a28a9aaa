#pragma once

#include <cstdint>

namespace visibility::detail {

__extension__ typedef __int128 Int128;  // GCC and Clang; -Wpedantic needs telling

inline Int128 product(std::int64_t a, std::int64_t b) { return static_cast<Int128>(a) * b; }

}  // namespace visibility::detail
