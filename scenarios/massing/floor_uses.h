#pragma once

#include <span>
#include <vector>

#include "scenarios/massing/massing.h"

namespace noonmark {

/// Error: a use without a name, a number of storeys out of range, or "all storeys above" below another use.
Result<void> checkUses(const std::vector<FloorUse>& uses);

/// Gives each use its storeys, from the ground floor up. Storeys above the last use get an entry without a
/// use; a use above the tower's top has 0 storeys. Empty where no use is stated.
std::vector<UseArea> sumByUse(const std::vector<FloorUse>& uses, std::span<const double> storeyM2);

}  // namespace noonmark
