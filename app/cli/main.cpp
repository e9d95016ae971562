#include <iostream>

#include "app/cli/command_line.h"
#include "core/base/process.h"

// Read by jemalloc, if it is linked: memory in huge pages, a tenth faster for studies of cities.
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always";

int main(int argc, char** argv) {
    return noonmark::cli::runCommandLine(
        argc, argv, {std::cout, std::cerr, noonmark::isTerminal(noonmark::StandardStream::error)});
}
