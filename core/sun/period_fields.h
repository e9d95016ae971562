#pragma once

#include "core/describe/command_options.h"
#include "core/sun/period.h"

namespace noonmark {

const Fields<Period>& periodFields();

/// The hours of a day from sunrise to sunset one by one, for forms: files and commands state them as one
/// text. Their flags only name the rows.
const Fields<SolarHours>& solarHoursFields();

/// Its flags on commands that compare scenarios, where `--from` names one.
FlagNames periodFlagsBesideScenarios();

}  // namespace noonmark
