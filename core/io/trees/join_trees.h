#pragma once

#include <memory>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/pieces/read_tree.h"

namespace noonmark {

/// The trees of a city's files, on its ground and complete (completeTree); null where there are none. Of
/// trees that stand within half a metre of each other the first stays, with a warning for each other one;
/// trees more than `farAwayM` from the middle of the city's buildings are left out with a warning. Leaf days
/// are those assumed for the city's latitude. O(trees log trees).
std::shared_ptr<const Trees> joinTrees(const std::vector<ReadTree>& read, const City& city, double farAwayM,
                                       Warnings& warnings);

}  // namespace noonmark
