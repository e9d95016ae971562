#pragma once

#include <limits>
#include <string>

#include "core/study/elements/element_study.h"

namespace noonmark {

/// The noonmark-cli command line that repeats a study at points, as makeRepeatCommand() of repeat_command.h.
Result<std::string> makeRepeatCommand(const ElementStudy& study,
                                      std::size_t width = std::numeric_limits<std::size_t>::max());

}  // namespace noonmark
