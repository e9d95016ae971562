#pragma once

#include "core/base/units.h"

class QSettings;

namespace noonmark {

// The units in which the window shows areas, lengths and heights, and in which lengths are typed
// (app/gui/base/widgets/number_fields.h). Results are in minutes and square metres; sheets have the units of
// their project.

/// The units saved in the settings; metric at first.
UnitSystem readUnits(const QSettings& settings);
void saveUnits(UnitSystem units, QSettings& settings);

/// For the whole application. Texts already shown do not change.
void applyUnits(UnitSystem units);
UnitSystem unitsInUse();  ///< metric before applyUnits()

/// From where the window counts heights of buildings and towers, as shown and as typed. Files and results are
/// not affected.
enum class HeightReference {
    ground,  ///< the ground under the building
    datum,   ///< the vertical zero of the project's terrain or, without terrain, the ground at the origin
};

/// The reference saved in the settings; the ground at first.
HeightReference readHeightReference(const QSettings& settings);
void saveHeightReference(HeightReference reference, QSettings& settings);

/// For the whole application. Texts and fields that are already shown do not change by themselves.
void applyHeightReference(HeightReference reference);
HeightReference heightReferenceInUse();  ///< the ground before applyHeightReference()

}  // namespace noonmark
