#pragma once

#include <string>

namespace noonmark::bench {

/// The machine's properties that times depend on.
struct Machine {
    std::string processor;  ///< the model's name from the system; "unknown processor" if it gives none
    int threads = 1;        ///< number of threads that the engines use
};

/// The machine that runs the program.
Machine detectMachine();

/// "AMD EPYC, 2 threads"
std::string describeMachine(const Machine& machine);

}  // namespace noonmark::bench
