#pragma once

#include <QDate>

#include "core/sun/civil_time.h"

namespace noonmark {

/// The same day in the terms of the other.
QDate dateOf(CivilDate date);
CivilDate civilOf(QDate date);

}  // namespace noonmark
