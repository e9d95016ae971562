#pragma once

#include "core/base/display_units.h"

class QSettings;

namespace noonmark {

// The units in which the window shows areas, lengths and heights, and in which lengths are typed
// (app/gui/base/widgets/length_field.h). Results are in minutes and square metres; sheets have the units of
// their project.

/// The units saved in the settings; metric at first.
UnitSystem readUnits(const QSettings& settings);
void saveUnits(UnitSystem units, QSettings& settings);

/// For the whole application. Texts already shown do not change.
void applyUnits(UnitSystem units);
UnitSystem unitsInUse();  ///< metric before applyUnits()

}  // namespace noonmark
