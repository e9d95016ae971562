#pragma once

#include <string>

namespace noonmark {

/// Returns `name`, or else the first of "name (2)", "name (3)"... for which `isTaken` is false.
template <class IsTaken>
std::string findFreeName(const std::string& name, IsTaken&& isTaken) {
    std::string free = name;
    for (int copy = 2; isTaken(free); ++copy) free = name + " (" + std::to_string(copy) + ")";
    return free;
}

}  // namespace noonmark
