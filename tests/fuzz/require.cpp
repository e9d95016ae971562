#include "tests/fuzz/require.h"

#include <cstdio>
#include <cstdlib>

namespace noonmark::tests {

void require(bool holds, std::string_view words) {
    if (holds) return;
    std::fprintf(stderr, "Not as promised: %.*s\n", int(words.size()), words.data());
    std::abort();
}

}  // namespace noonmark::tests
