#pragma once

#include "core/describe/figure.h"
#include "scenarios/impact/impact_figures.h"

namespace noonmark {

const Figures<ChangeFigures>& changeFigures();

/// Those of a comparison beside the change of its two measures.
const Figures<ImpactFigures>& impactFigures();

/// All NaN: of a measure that was not computed.
ChangeFigures notComputed();

}  // namespace noonmark
