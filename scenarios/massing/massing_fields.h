#pragma once

#include "core/describe/field.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// The settings of a tower without its lists and its podium.
const Fields<MassingSettings>& massingFields();
const Fields<Podium>& podiumFields();
const Fields<Setback>& setbackFields();  ///< without flags: see massingListFields()
const Fields<FloorUse>& floorUseFields();
const Fields<FurtherTower>& furtherTowerFields();

/// Setbacks, uses and further towers as texts: "60:3:10:15", "offices:12", "homes:rest", "20:600", "20:30%".
const Fields<MassingSettings>& massingListFields();

/// Error for the first number out of its range, of the podium and the setbacks, too.
Result<void> checkRanges(const MassingSettings& settings);

}  // namespace noonmark
