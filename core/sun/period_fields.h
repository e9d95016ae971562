#pragma once

#include "core/describe/field.h"
#include "core/sun/period.h"

namespace noonmark {

const Fields<Period>& periodFields();

}  // namespace noonmark
