#pragma once

#include <QDate>
#include <QString>

#include "core/sun/civil_time.h"

namespace noonmark {

// Formats of dates as the language of the window writes them, for QLocale::toString() and fields.
QString shortDay();   ///< "21 Mar"
QString longDay();    ///< "21 March"
QString dayOfYear();  ///< "21 Mar 2026"
QString longDate();   ///< "21 March 2026"

/// Conversion between QDate and CivilDate.
QDate dateOf(CivilDate date);
CivilDate civilOf(QDate date);

}  // namespace noonmark
