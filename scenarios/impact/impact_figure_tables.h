#pragma once

#include "core/describe/figure.h"
#include "scenarios/impact/impact_figures.h"

namespace noonmark {

const Figures<ChangeFigures>& changeFigures();

/// Those of a comparison beside the change of its two measures.
const Figures<ImpactFigures>& impactFigures();

/// Those of a change that files state by threshold: the areas with more and with less shadow.
const std::vector<Figure>& figuresByThreshold();

/// All NaN: of a measure that was not computed.
ChangeFigures notComputed();

}  // namespace noonmark
