#pragma once

#include <QDate>

#include "core/sun/civil_time.h"

namespace noonmark {

/// Conversion between QDate and CivilDate.
QDate dateOf(CivilDate date);
CivilDate civilOf(QDate date);

}  // namespace noonmark
