#pragma once

#include "core/describe/field.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// The texts of the title block; the logo is a picture and no field. The keys are those of the table
/// `sheet_settings` of a project.
const Fields<TitleBlock>& titleFields();

/// The same with the units of results.
const Fields<SheetSettings>& sheetFields();

}  // namespace noonmark
