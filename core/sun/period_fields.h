#pragma once

#include "core/describe/command_options.h"
#include "core/sun/period.h"

namespace noonmark {

const Fields<Period>& periodFields();

/// Its flags on commands that compare scenarios, where `--from` names one.
FlagNames periodFlagsBesideScenarios();

}  // namespace noonmark
