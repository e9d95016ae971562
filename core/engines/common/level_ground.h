#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// For engines that support level ground only: error if the ground is not flat or receivers do not all lie on
/// it. The error names engines that support these cases. `engineFalls`: subject and verb of the message,
/// "Projected shadows fall".
Result<void> checkLevelGround(const City& city, const Receivers& receivers, std::string_view engineFalls);

}  // namespace noonmark
