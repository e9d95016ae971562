#pragma once

#include "core/describe/field.h"
#include "scenarios/project/title_block.h"

namespace noonmark {

/// The texts of the title block; the logo is a picture and no field. The keys are those of the table
/// `sheet_settings` of a project.
const Fields<TitleBlock>& titleFields();

}  // namespace noonmark
