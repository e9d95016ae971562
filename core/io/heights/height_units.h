#pragma once

#include <optional>
#include <string>

#include "core/io/settings/read_settings.h"

namespace noonmark {

/// The unit of heights that are so much for each storey, which is 2.2 to 6.5 m high: 7.2 to 21.5 are feet.
/// Nothing for numbers between.
std::optional<LengthUnit> unitPerStorey(double perStorey);

/// The unit of heights that are `ratio` times the same heights in metres.
std::optional<LengthUnit> unitBeside(double ratio);

/// Whether half of a town's buildings can be lower than this, and half higher: 2.5 to 60 m.
bool isTypicalHeight(double medianM);

/// What to say of heights whose median, in the unit that they were read in, is more than that of a town: the
/// units that would make it typical, the likeliest first, with the option that states each. Else nothing.
std::optional<std::string> doubtUnit(double median, LengthUnit readIn);

}  // namespace noonmark
