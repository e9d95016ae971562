#pragma once

#include <QString>

namespace noonmark {

// Columns of numbers whose heading states the unit, in the units in use (app/gui/base/looks/units.h). Where
// both are in use, feet follow in parentheses.

QString areaUnit();                             ///< "m²", "sq ft", "m² (sq ft)"
QString lengthUnit();                           ///< "m", "ft", "m (ft)"
QString areaNumber(double squareMetres);        ///< "1,204"
QString lengthNumber(double metres);            ///< "124.3"
QString signedAreaNumber(double squareMetres);  ///< "+1,204"

}  // namespace noonmark
