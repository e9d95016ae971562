#pragma once

#include "core/receivers/place.h"
#include "core/study/contributions/contributions.h"

namespace noonmark {

/// What the buildings take from one place of a study.
struct PlaceContributions {
    Place place;
    ShadowBreakdown breakdown;  ///< by month and by building, over the study's cells in the place
    std::size_t cells = 0;      ///< of the study, with their centre in the place; at least 1
    std::size_t days = 0;       ///< of the study's period
    /// The shadow of the same cells in the study's field, min x m2 of the whole period. By the engine that
    /// attributes, and on level ground, the breakdown adds up to it, within the rounding of float32.
    double studyMinM2 = 0;
    std::vector<Contribution> rows;  ///< of listContributions()
};

/// Attributes the shadow of a place to buildings, with the engine, the steps and the cells of the study, but
/// only over the cells whose centre lies in the place: on level ground they get the same minutes as in the
/// whole study; on terrain the sweep rounds heights from the lowest cell up. Error: no cell of the study in
/// the place; an engine without attribution (ErrorKind::unsupported), which names others. Stops with
/// cancelled() within 0.2 s. Cost: that of a study of the place with contributions, without its error.
Result<PlaceContributions> computePlaceContributions(const Study& study, const Place& place,
                                                     Progress& progress, std::stop_token stop,
                                                     const EngineList& engines = coreEngines());

}  // namespace noonmark
