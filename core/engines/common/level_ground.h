#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Error, for engines that know no other, where the ground is not flat or receivers do not all lie on it; it
/// names those that do. `engineFalls`: "Projected shadows fall".
Result<void> checkLevelGround(const City& city, const Receivers& receivers, std::string_view engineFalls);

}  // namespace noonmark
