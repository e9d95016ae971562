#pragma once

#include <fmt/format.h>

#include <string>

namespace noonmark::tests {

/// An OBJ file of a closed box of x by z by y units, y up, with one corner at the origin; z is negative
/// inside it.
inline std::string boxObj(int x, int z, int y) {
    return fmt::format(
        "o box\n"
        "v 0 0 0\nv {0} 0 0\nv {0} 0 -{1}\nv 0 0 -{1}\n"
        "v 0 {2} 0\nv {0} {2} 0\nv {0} {2} -{1}\nv 0 {2} -{1}\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
        x, z, y);
}

}  // namespace noonmark::tests
