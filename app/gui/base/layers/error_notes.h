#pragma once

#include <QString>
#include <optional>

#include "app/report/maps/shadow_measure.h"
#include "core/measures/shown_quantity.h"
#include "core/study/elements/element_study.h"

namespace noonmark {

/// The measured error of what a map shows, beside its legend, so that nobody takes an approximate map for an
/// exact one. Empty if it was not measured.
QString describeError(const std::optional<SampledError>& error, ShadowMeasure measure);
/// The error of a cell in the unit shown, in the mean and for 99 of 100 cells.
QString describeCellError(const SampledError& error, double sunlitMin, ShownAs show);
QString describeError(const ElementStudy& study, ShadowMeasure measure);

}  // namespace noonmark
