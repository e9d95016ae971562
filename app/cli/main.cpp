#include <unistd.h>

#include <iostream>

#include "app/cli/command_line.h"

int main(int argc, char** argv) {
    return noonmark::cli::runCommandLine(argc, argv, {std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0});
}
