#pragma once

#include "core/describe/field.h"
#include "core/io/read_city.h"

namespace noonmark {

/// All settings of reading a city but the frame, which no user sets; the two tables below are part of it.
const Fields<ReadSettings>& readSettingsFields();

/// Where buildings stand: also of a proposal being read.
const Fields<ReadSettings>& standFields();

/// The axis and the unit of a mesh's coordinates: also of a proposal being read.
const Fields<ReadSettings>& meshAxesFields();

}  // namespace noonmark
